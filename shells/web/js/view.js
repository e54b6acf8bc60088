// A book on a canvas: fingers in, pictures out, and nothing at all while it lies still.
import { Fingers } from "./fingers.js";
import { Pages } from "./pages.js";
import { BookRenderer } from "./renderer.js";

/** Texels a page has for each pixel it covers: it is seen at a slant, and filtered. */
const TEXELS = 1.3;
/** Longest side of a page's picture, and of the canvas. */
const MOST_TEXELS = 2048;
const MOST_PIXELS = 8_000_000;

/**
 * @typedef {object} ViewOptions
 * @property {(notice: import("./words.js").Notice) => void} [onNotice]
 * @property {(page: number, why: unknown) => void} [onBadPage]
 * @property {number} [sharpness] pixels of the canvas for each of the page's; by default the screen's
 */

/** Shows a book on a canvas. */
export class BookView {
    #asked = 0;
    /** @type {BookRenderer | undefined} */
    #renderer;
    #gone = new AbortController();
    /** @type {ResizeObserver} */
    #sizes;

    /**
     * @param {HTMLCanvasElement} canvas
     * @param {import("./book.js").Book} book
     * @param {import("./pages.js").PageSource} source
     * @param {ViewOptions} [options]
     */
    constructor(canvas, book, source, options = {}) {
        this.canvas = canvas;
        this.book = book;
        this.options = options;
        /** Pictures drawn, and frames asked of the browser, since it was made. */
        this.counts = { drawn: 0, frames: 0 };
        const gl = canvas.getContext("webgl2", { antialias: true, alpha: false, powerPreference: "low-power" });
        if (!gl) throw new Error("this browser has no WebGL 2");
        this.gl = gl;
        this.pages = new Pages(source, {
            set: (page, picture) => this.#picture(page, picture),
            keep: (wanted) => this.#renderer?.keepPages(wanted),
            failed: (page, why) => this.options.onBadPage?.(page, why),
        });
        const size = () => /** @type {[number, number]} */ ([canvas.width, canvas.height]);
        this.fingers = new Fingers(canvas, (sample) => this.#sample(sample), size);
        this.#sizes = new ResizeObserver(() => this.resize());
        this.#sizes.observe(canvas);
        const { signal } = this.#gone;
        canvas.addEventListener("webglcontextlost", (event) => this.#lost(event), { signal });
        canvas.addEventListener("webglcontextrestored", () => this.#found(), { signal });
        document.addEventListener("visibilitychange", () => this.#hidden(), { signal });
        this.#found();
        this.resize();
    }

    /** The clock that the book is stepped with, microseconds. */
    now() {
        return Math.round(performance.now() * 1000);
    }

    /** Asks for a frame, if none is asked for yet. */
    wake() {
        if (this.#asked !== 0 || document.hidden) return;
        this.#asked = requestAnimationFrame((ms) => this.#frame(ms));
    }

    /** @param {number} ms */
    #frame(ms) {
        this.#asked = 0;
        this.counts.frames += 1;
        const frame = this.book.step(Math.round(ms * 1000));
        if (frame.draw && this.#renderer && !this.gl.isContextLost()) {
            this.#renderer.draw(frame);
            this.counts.drawn += 1;
        }
        this.#tell();
        if (frame.needsFrame) this.wake();
    }

    #tell() {
        for (const notice of this.book.notices()) {
            if (notice.kind === "committed") this.#near();
            this.options.onNotice?.(notice);
        }
    }

    /** @param {import("./book.js").PointerSample} sample */
    #sample(sample) {
        try {
            this.book.pointer(sample);
        } catch (why) {
            // Too many samples between two frames: the book keeps those before, and the finger goes on.
            if (!(why instanceof Error) || !("kind" in why) || why.kind !== "pointer") throw why;
        }
        this.wake();
    }

    /**
     * Turns leaves. Answers whether the book could.
     * @param {boolean} forward
     * @param {number} [leaves]
     */
    turn(forward, leaves = 1) {
        try {
            this.book.turn(forward, leaves);
        } catch (why) {
            if (why instanceof Error && "kind" in why && why.kind !== "closed") return false;
            throw why;
        }
        this.wake();
        return true;
    }

    /**
     * A second finger takes one more leaf behind the one in hand, or gives one back.
     * @param {boolean} more
     */
    bookmark(more) {
        this.fingers.bookmark(more, this.now());
    }

    /** Puts back what is in hand. */
    putBack() {
        this.fingers.putBack(this.now());
    }

    /** The canvas is as large as its place on the page, in the screen's own pixels. */
    resize() {
        const { canvas } = this;
        const [width, height] = [canvas.clientWidth, canvas.clientHeight];
        if (width === 0 || height === 0) return;
        const sharp = this.options.sharpness ?? devicePixelRatio;
        const scale = Math.min(sharp, Math.sqrt(MOST_PIXELS / (width * height)));
        const wanted = [width, height].map((side) => Math.max(1, Math.round(side * scale)));
        if (wanted[0] !== canvas.width || wanted[1] !== canvas.height) [canvas.width, canvas.height] = wanted;
        this.book.resize(canvas.width, canvas.height);
        this.restage();
    }

    /** The book is looked at otherwise. */
    restage() {
        this.#renderer?.restage();
        this.#near();
        this.wake();
    }

    #near() {
        const { eye, pixelAtOneMetre, pageWidthM, pageHeightM } = this.book.stage();
        // As near as a lifted leaf comes to the eye.
        const away = Math.hypot(...eye);
        const nearest = Math.max(away - 0.7 * pageWidthM, 0.3 * away);
        const most = MOST_TEXELS / Math.max(pageWidthM, pageHeightM);
        const perMetre = Math.min(TEXELS / (pixelAtOneMetre * nearest), most);
        this.pages.near(this.book.page, Math.ceil(pageWidthM * perMetre), Math.ceil(pageHeightM * perMetre));
    }

    /**
     * @param {number} page
     * @param {TexImageSource} picture
     */
    #picture(page, picture) {
        if (!this.#renderer || this.gl.isContextLost()) return;
        this.#renderer.setPage(page, picture);
        if (!this.#renderer.shownPages().includes(page)) return;
        this.book.redraw();
        this.wake();
    }

    /** @param {Event} event */
    #lost(event) {
        event.preventDefault();
        this.#renderer = undefined;
    }

    #found() {
        this.#renderer = new BookRenderer(this.gl, this.book);
        this.pages.forget();
        this.book.redraw();
        this.wake();
    }

    #hidden() {
        if (document.hidden) {
            cancelAnimationFrame(this.#asked);
            this.#asked = 0;
            this.putBack();
            this.book.pause();
            this.#tell();
        } else {
            this.book.resume();
            this.wake();
        }
    }

    /** Ends it: the canvas may be given another. The book stays the caller's. */
    close() {
        cancelAnimationFrame(this.#asked);
        this.#asked = -1;
        this.#gone.abort();
        this.#sizes.disconnect();
        this.fingers.release();
        this.pages.close();
        this.#renderer?.release();
        this.#renderer = undefined;
    }
}
