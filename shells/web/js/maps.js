// Depth maps of the lamp and of the sky, many in one texture.

/** Maps of equal size, some abreast. */
export class Maps {
    /**
     * @param {WebGL2RenderingContext} gl
     * @param {number} count
     * @param {number} across
     * @param {number} side
     */
    constructor(gl, count, across, side) {
        this.gl = gl;
        this.count = count;
        this.across = across;
        this.side = side;
        this.texture = gl.createTexture();
        gl.activeTexture(gl.TEXTURE0);
        gl.bindTexture(gl.TEXTURE_2D, this.texture);
        gl.texStorage2D(gl.TEXTURE_2D, 1, gl.DEPTH_COMPONENT16, across * side, (count / across) * side);
        for (const [name, value] of [
            [gl.TEXTURE_MIN_FILTER, gl.LINEAR],
            [gl.TEXTURE_MAG_FILTER, gl.LINEAR],
            [gl.TEXTURE_WRAP_S, gl.CLAMP_TO_EDGE],
            [gl.TEXTURE_WRAP_T, gl.CLAMP_TO_EDGE],
            [gl.TEXTURE_COMPARE_MODE, gl.COMPARE_REF_TO_TEXTURE],
            [gl.TEXTURE_COMPARE_FUNC, gl.LEQUAL],
        ]) {
            gl.texParameteri(gl.TEXTURE_2D, name, value);
        }
        this.frame = gl.createFramebuffer();
        const before = gl.getParameter(gl.FRAMEBUFFER_BINDING);
        gl.bindFramebuffer(gl.FRAMEBUFFER, this.frame);
        gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.DEPTH_ATTACHMENT, gl.TEXTURE_2D, this.texture, 0);
        gl.bindFramebuffer(gl.FRAMEBUFFER, before);
    }

    /**
     * Draws every map: `draw` is told the number of each, counted from `first`.
     * @param {number} first
     * @param {(map: number) => void} draw
     */
    fill(first, draw) {
        const { gl, count, across, side } = this;
        const before = gl.getParameter(gl.FRAMEBUFFER_BINDING);
        gl.bindFramebuffer(gl.FRAMEBUFFER, this.frame);
        gl.viewport(0, 0, across * side, (count / across) * side);
        gl.enable(gl.DEPTH_TEST);
        for (const off of [gl.CULL_FACE, gl.BLEND, gl.SCISSOR_TEST]) gl.disable(off);
        gl.depthFunc(gl.LESS);
        gl.clear(gl.DEPTH_BUFFER_BIT);
        for (let n = 0; n < count; n += 1) {
            gl.viewport((n % across) * side, Math.floor(n / across) * side, side, side);
            draw(first + n);
        }
        gl.bindFramebuffer(gl.FRAMEBUFFER, before);
    }

    /** Frees it. */
    release() {
        this.gl.deleteFramebuffer(this.frame);
        this.gl.deleteTexture(this.texture);
    }
}
