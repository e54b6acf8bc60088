// The book that is open on the page: its view, its place, what the reader asked for.
import { BookView } from "./dogleaf/index.js";

/** Below this shape of the window one page is shown. */
const NARROW = 0.95;

/**
 * @typedef {object} Wanted
 * @property {"ltr" | "rtl"} direction
 * @property {"auto" | "spread" | "single"} layout
 * @property {"table" | "above"} gaze
 * @property {"auto" | "full" | "reduced" | "none"} motion
 * @property {"draft" | "standard" | "fine" | "reference"} fidelity
 */

/** One book at a time on one canvas. */
export class Reader {
    /** @type {import("./dogleaf/index.js").BookView | undefined} */
    view;
    /** @type {import("./sources.js").Source | undefined} */
    source;
    /** @type {string} */
    #layout = "spread";
    /** Pixels of the canvas for each of the page's; by default the screen's. */
    sharpness = /** @type {number | undefined} */ (undefined);

    /**
     * @param {import("./dogleaf/index.js").Dogleaf} dogleaf
     * @param {HTMLCanvasElement} canvas
     * @param {Wanted} wanted
     * @param {{ notice: (notice: import("./dogleaf/words.js").Notice) => void, place: () => void, news: (line: string) => void }} tell
     */
    constructor(dogleaf, canvas, wanted, tell) {
        this.dogleaf = dogleaf;
        this.canvas = canvas;
        this.wanted = wanted;
        this.tell = tell;
        this.quiet = matchMedia("(prefers-reduced-motion: reduce)");
        this.slow = matchMedia("(update: slow)");
        for (const query of [this.quiet, this.slow]) query.addEventListener("change", () => this.follow());
        new ResizeObserver(() => this.#fit()).observe(canvas);
    }

    /** @type {import("./dogleaf/index.js").Book | undefined} */
    get book() {
        return this.view?.book;
    }

    /**
     * Opens a book in place of the one that is open.
     * @param {import("./sources.js").Source} source
     * @param {number} [openAt]
     */
    show(source, openAt = 0) {
        const book = this.#opened(source, openAt);
        const [view, old] = [this.view, this.source];
        view?.close();
        view?.book.shut();
        if (old && old !== source) old.close();
        this.source = source;
        this.view = new BookView(this.canvas, book, { ...source, close() {} }, {
            sharpness: this.sharpness,
            onNotice: this.tell.notice,
            onBadPage: (page, why) => this.tell.news(`Page ${page + 1} cannot be shown: ${why instanceof Error ? why.message : why}.`),
        });
        this.follow();
        this.tell.place();
    }

    /**
     * @param {import("./sources.js").Source} source
     * @param {number} openAt
     */
    #opened(source, openAt) {
        const { clientWidth, clientHeight } = this.canvas;
        const { direction, layout, gaze, fidelity } = this.wanted;
        const { pages, widthM, heightM } = source;
        this.#layout = this.#wide(layout) ? "spread" : "single";
        const options = { pages, widthM, heightM, direction, gaze, fidelity, layout: /** @type {"spread"} */ (this.#layout) };
        const place = Math.min(Math.max(Math.floor(openAt / 2) * 2, 0), 2 * Math.ceil(pages / 2));
        return this.dogleaf.open({ ...options, openAt: Math.min(place, pages), widthPx: clientWidth || 960, heightPx: clientHeight || 720 });
    }

    /** @param {Wanted["layout"]} layout */
    #wide(layout) {
        const { clientWidth, clientHeight } = this.canvas;
        return layout === "auto" ? clientWidth > NARROW * clientHeight : layout === "spread";
    }

    /** Opens the same book anew: what changed is said only when a book is opened. */
    again() {
        if (this.source) this.show(this.source, this.book?.page);
    }

    /** A phone was turned: another layout may fit. */
    #fit() {
        const fits = this.#wide(this.wanted.layout) ? "spread" : "single";
        if (this.source && this.canvas.clientWidth > 0 && fits !== this.#layout) this.again();
    }

    /** Motion as it is asked for: by the reader, else by the system. */
    follow() {
        const { motion } = this.wanted;
        const system = this.slow.matches ? "eink" : this.quiet.matches ? "reduced" : "full";
        this.book?.setMotion(motion === "auto" ? system : motion);
        this.view?.wake();
    }

    /**
     * @param {boolean} forward
     * @param {boolean} [all]
     */
    turn(forward, all = false) {
        const { book } = this;
        if (!book) return false;
        const left = forward ? book.pages - book.page : book.page;
        return this.view?.turn(forward, all ? Math.min(Math.ceil(left / 2), 65_535) : 1) ?? false;
    }

    /** The pages that lie open, as one says it. */
    where() {
        const { book } = this;
        if (!book) return "";
        const { page, pages } = book;
        const open = [page, page + 1].filter((n) => n >= 1 && n <= pages);
        return `${open.join("–")} of ${pages}`;
    }
}
