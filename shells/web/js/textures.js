// The pictures of pages on the graphics card, and a white one for what has none.

/** Textures by page. */
export class Textures {
    /** @type {Map<number, WebGLTexture>} */
    #pages = new Map();

    /** @param {WebGL2RenderingContext} gl */
    constructor(gl) {
        this.gl = gl;
        this.blank = this.empty(1, 1);
        gl.bindTexture(gl.TEXTURE_2D, this.blank);
        gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array([255, 255, 255, 255]));
    }

    /**
     * A texture of a size, without content.
     * @param {number} width
     * @param {number} height
     */
    empty(width, height) {
        const { gl } = this;
        const texture = gl.createTexture();
        const levels = Math.floor(Math.log2(Math.max(width, height))) + 1;
        gl.activeTexture(gl.TEXTURE0);
        gl.bindTexture(gl.TEXTURE_2D, texture);
        gl.texStorage2D(gl.TEXTURE_2D, levels, gl.RGBA8, width, height);
        gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.LINEAR_MIPMAP_LINEAR);
        gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.LINEAR);
        gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_S, gl.CLAMP_TO_EDGE);
        gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_T, gl.CLAMP_TO_EDGE);
        return /** @type {WebGLTexture} */ (texture);
    }

    /**
     * Makes the smaller pictures of a texture.
     * @param {WebGLTexture} texture
     */
    chain(texture) {
        this.bind(0, texture);
        this.gl.generateMipmap(this.gl.TEXTURE_2D);
    }

    /** @param {number} page */
    has(page) {
        return this.#pages.has(page);
    }

    /** How many pages have one. */
    get size() {
        return this.#pages.size;
    }

    /** @param {number | undefined} page */
    of(page) {
        return (page === undefined ? undefined : this.#pages.get(page)) ?? this.blank;
    }

    /**
     * @param {number} unit
     * @param {WebGLTexture | null} texture
     */
    bind(unit, texture) {
        this.gl.activeTexture(this.gl.TEXTURE0 + unit);
        this.gl.bindTexture(this.gl.TEXTURE_2D, texture);
    }

    /**
     * @param {number} page
     * @param {TexImageSource} picture
     */
    set(page, picture) {
        const { gl } = this;
        const [width, height] = [widthOf(picture), heightOf(picture)];
        const texture = this.empty(width, height);
        gl.pixelStorei(gl.UNPACK_FLIP_Y_WEBGL, false);
        gl.pixelStorei(gl.UNPACK_PREMULTIPLY_ALPHA_WEBGL, false);
        gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, picture);
        gl.generateMipmap(gl.TEXTURE_2D);
        gl.deleteTexture(this.#pages.get(page) ?? null);
        this.#pages.set(page, texture);
    }

    /** @param {(page: number) => boolean} wanted */
    keep(wanted) {
        for (const [page, texture] of this.#pages) {
            if (wanted(page)) continue;
            this.gl.deleteTexture(texture);
            this.#pages.delete(page);
        }
    }

    /** Frees all of them. */
    release() {
        this.keep(() => false);
        this.gl.deleteTexture(this.blank);
    }
}

/** @param {TexImageSource} picture */
function widthOf(picture) {
    if ("displayWidth" in picture) return picture.displayWidth;
    return "videoWidth" in picture ? picture.videoWidth : picture.width;
}

/** @param {TexImageSource} picture */
function heightOf(picture) {
    if ("displayHeight" in picture) return picture.displayHeight;
    return "videoHeight" in picture ? picture.videoHeight : picture.height;
}
