// Draws a book with WebGL 2 and the shaders of every GL shell: one mesh, a program for what is seen, one for shadows.
import { Maps } from "./maps.js";
import { Mesh } from "./mesh.js";
import { TABLE, looks } from "./look.js";
import { program } from "./program.js";
import { Textures } from "./textures.js";

/** Maps of the lamp and of the sky: how many, how many abreast, texels a side. `common.glsl` knows them too. */
const LAMPS = /** @type {const} */ ([16, 4, 512]);
const SKIES = /** @type {const} */ ([32, 8, 192]);
/** Size of the picture of the table's wood, texels. */
const GRAIN = /** @type {const} */ ([192, 1536]);
/** Half a side of the table, metres. */
const TABLE_M = 3;
/** What is seen where nothing is, encoded. */
const BACKGROUND = 0.152;
/** Centre of the lamp and radius of its disc, metres; its light, linear. */
const LAMP = [-0.33, 0.66, -0.3, 0.065];
const LAMP_COLOUR = [1.15, 1.15 * 0.93, 1.15 * 0.83];
/** Units of the samplers. */
const UNITS = { front: 0, back: 1, grain: 2, lampMaps: 3, skyMaps: 4 };

/** @typedef {import("./book.js").FrameInfo} FrameInfo */

/**
 * Draws one `Book` into the framebuffer that is bound. Where the context is lost, make another renderer and hand it the
 * pages again: the book itself has lost nothing.
 */
export class BookRenderer {
    /** @type {import("./words.js").Piece[]} */
    #pieces = [];
    /** @type {import("./look.js").Look[]} */
    #looks = [];
    #generation = -1;
    #piecesGeneration = -1;

    /**
     * @param {WebGL2RenderingContext} gl
     * @param {import("./book.js").Book} book
     */
    constructor(gl, book) {
        this.gl = gl;
        this.book = book;
        this.page = program(gl, "page");
        this.shadow = program(gl, "shadow");
        this.mesh = new Mesh(gl, book.indices);
        this.table = new Mesh(gl, new Uint16Array([0, 1, 2, 0, 2, 3]));
        this.lampMaps = new Maps(gl, ...LAMPS);
        this.skyMaps = new Maps(gl, ...SKIES);
        this.textures = new Textures(gl);
        this.grain = this.#grain();
        gl.useProgram(this.page.program);
        for (const [name, unit] of Object.entries(UNITS)) gl.uniform1i(this.page.place(name), unit);
        this.stage = this.#restage();
    }

    /** Takes note of another view: after `look` or `resize`. */
    restage() {
        this.stage = this.#restage();
    }

    #restage() {
        const stage = this.book.stage();
        const corner = (/** @type {number} */ x, /** @type {number} */ z) => [x, stage.tableY, z, 0, 1, 0, 0.5, 0.5];
        const [a, b] = [-TABLE_M, TABLE_M];
        this.table.fill(new Float32Array([corner(a, a), corner(a, b), corner(b, b), corner(b, a)].flat()));
        return stage;
    }

    /**
     * Whether a page's picture is there.
     * @param {number} page
     */
    hasPage(page) {
        return this.textures.has(page);
    }

    /** Pages that the book shows now. */
    shownPages() {
        const seen = this.#looks.flatMap(({ front, back }) => [front, back]);
        return /** @type {number[]} */ ([...new Set(seen.filter((page) => page !== undefined))]);
    }

    /** Those of them whose pictures are missing. */
    missingPages() {
        return this.shownPages().filter((page) => !this.textures.has(page));
    }

    /**
     * Takes a page's picture: opaque, rows from the top.
     * @param {number} page
     * @param {TexImageSource} picture
     */
    setPage(page, picture) {
        this.textures.set(page, picture);
    }

    /**
     * Gives back the pictures of all other pages.
     * @param {(page: number) => boolean} wanted
     */
    keepPages(wanted) {
        this.textures.keep(wanted);
    }

    /**
     * Takes over what a step made, if it made something.
     * @param {FrameInfo} frame
     */
    update(frame) {
        if (frame.piecesGeneration !== this.#piecesGeneration) {
            this.#pieces = this.book.pieces().filter((piece) => piece.visible);
            this.#looks = looks(this.#pieces);
            this.#piecesGeneration = frame.piecesGeneration;
        }
        if (frame.generation === this.#generation) return;
        this.#generation = frame.generation;
        this.mesh.fill(this.book.vertices);
        this.#shadows();
    }

    /**
     * Draws the book as of `frame`, in the size of the view.
     * @param {FrameInfo} frame
     */
    draw(frame) {
        const { gl, page, stage } = this;
        this.update(frame);
        gl.viewport(0, 0, stage.widthPx, stage.heightPx);
        gl.disable(gl.BLEND);
        gl.disable(gl.SCISSOR_TEST);
        gl.enable(gl.DEPTH_TEST);
        gl.enable(gl.CULL_FACE);
        gl.depthFunc(gl.LESS);
        gl.clearColor(BACKGROUND, BACKGROUND, BACKGROUND, 1);
        gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
        gl.useProgram(page.program);
        this.#light(page);
        gl.uniformMatrix4fv(page.place("clipFromWorld"), false, stage.viewProjection);
        gl.uniform3fv(page.place("eye"), stage.eye);
        gl.uniform2f(page.place("picture"), stage.widthPx, stage.heightPx);
        gl.uniform1f(page.place("pixelAtOneMetre"), stage.pixelAtOneMetre);
        gl.uniform3fv(page.place("lampColour"), LAMP_COLOUR);
        this.textures.bind(UNITS.grain, this.grain);
        this.textures.bind(UNITS.lampMaps, this.lampMaps.texture);
        this.textures.bind(UNITS.skyMaps, this.skyMaps.texture);
        this.#pieces.forEach((piece, n) => {
            this.#take(this.#looks[n], frame);
            this.mesh.draw(piece.firstIndex, piece.indexCount);
        });
        // Last: most of it is hidden by then.
        this.#take(TABLE, frame);
        this.table.draw(0, 6);
    }

    /**
     * @param {import("./look.js").Look} look
     * @param {FrameInfo} frame
     */
    #take(look, frame) {
        const { gl, page } = this;
        const passing = look.passes ? frame[look.passes] : 0;
        gl.uniform1i(page.place("material"), look.material);
        gl.uniform3fv(page.place("tint"), look.tint);
        gl.uniform1f(page.place("passing"), passing);
        gl.uniform1f(page.place("thickness"), passing > 0 ? Math.min(this.stage.leafM, 1e-3) : 0);
        gl.uniform1f(page.place("leaves"), look.leaves);
        this.textures.bind(UNITS.front, this.textures.of(look.front));
        this.textures.bind(UNITS.back, this.textures.of(look.back));
    }

    /** Every shadow map. */
    #shadows() {
        const { gl, shadow } = this;
        const runs = joined(this.#pieces);
        gl.useProgram(shadow.program);
        this.#light(shadow);
        const draw = (/** @type {number} */ map) => {
            gl.uniform1i(shadow.place("map"), map);
            for (const [first, count] of runs) this.mesh.draw(first, count);
        };
        this.lampMaps.fill(0, draw);
        this.skyMaps.fill(LAMPS[0], draw);
    }

    /**
     * Where the lamp is and what can stand in its way.
     * @param {ReturnType<typeof program>} to
     */
    #light(to) {
        this.gl.uniform4fv(to.place("lamp"), LAMP);
        this.gl.uniform4f(to.place("bound"), 0, 0, 0, this.stage.radiusM);
    }

    /** The wood of the table, drawn once. */
    #grain() {
        const { gl } = this;
        const [width, height] = GRAIN;
        const texture = this.textures.empty(width, height);
        const before = gl.getParameter(gl.FRAMEBUFFER_BINDING);
        const frame = gl.createFramebuffer();
        const wood = program(gl, "grain");
        gl.bindFramebuffer(gl.FRAMEBUFFER, frame);
        gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, texture, 0);
        gl.viewport(0, 0, width, height);
        for (const off of [gl.DEPTH_TEST, gl.CULL_FACE, gl.SCISSOR_TEST, gl.BLEND]) gl.disable(off);
        gl.useProgram(wood.program);
        gl.bindVertexArray(null);
        gl.drawArrays(gl.TRIANGLES, 0, 3);
        gl.bindFramebuffer(gl.FRAMEBUFFER, before);
        gl.deleteFramebuffer(frame);
        gl.deleteProgram(wood.program);
        this.textures.chain(texture);
        return texture;
    }

    /** Frees all that it has on the graphics card. */
    release() {
        const { gl } = this;
        this.textures.release();
        gl.deleteTexture(this.grain);
        for (const { program } of [this.page, this.shadow]) gl.deleteProgram(program);
        for (const part of [this.mesh, this.table, this.lampMaps, this.skyMaps]) part.release();
    }
}

/**
 * Neighbours in the index buffer as one run.
 * @param {import("./words.js").Piece[]} pieces
 */
function joined(pieces) {
    /** @type {[number, number][]} */
    const runs = [];
    for (const { firstIndex, indexCount } of pieces) {
        const last = runs.at(-1);
        if (last && last[0] + last[1] === firstIndex) last[1] += indexCount;
        else runs.push([firstIndex, indexCount]);
    }
    return runs;
}
