// The pictures of the pages round the reader: made when they come near, given back when they are far.

/** Pages kept before and after the open ones. */
const BEFORE = 5;
const AFTER = 6;

/**
 * Where pages come from. `picture` makes one of about this size; what it throws leaves the page blank and is told once.
 * @typedef {object} PageSource
 * @property {number} pages
 * @property {(page: number, widthPx: number, heightPx: number) => Promise<TexImageSource>} picture
 * @property {() => void} [close]
 */

/** Makes one picture at a time, the nearest first. */
export class Pages {
    #at = 0;
    #size = [0, 0];
    #busy = false;
    #closed = false;
    /** @type {Set<number>} */
    #there = new Set();
    /** @type {Set<number>} */
    #failed = new Set();

    /**
     * @param {PageSource} source
     * @param {{ set: (page: number, picture: TexImageSource) => void, keep: (wanted: (page: number) => boolean) => void,
     *   failed: (page: number, why: unknown) => void }} shelf
     */
    constructor(source, shelf) {
        this.source = source;
        this.shelf = shelf;
    }

    /** Pages whose pictures are there. */
    get count() {
        return this.#there.size;
    }

    /** Whether all that is wanted is there. */
    get idle() {
        return !this.#busy && this.#next() === undefined;
    }

    /**
     * The book is open here, and a page takes so many pixels.
     * @param {number} page
     * @param {number} widthPx
     * @param {number} heightPx
     */
    near(page, widthPx, heightPx) {
        this.#at = page;
        // A little larger or smaller is sharp enough: no page is made anew for that.
        const change = Math.max(widthPx / this.#size[0], this.#size[0] / widthPx);
        if (!(change < 1.2)) {
            this.#size = [widthPx, heightPx];
            this.#there.clear();
        }
        this.shelf.keep((n) => this.#near(n));
        for (const n of this.#there) if (!this.#near(n)) this.#there.delete(n);
        void this.#work();
    }

    /** Everything is gone (a GL context, say): make it anew. */
    forget() {
        this.#there.clear();
        void this.#work();
    }

    /** @param {number} page */
    #near(page) {
        return page >= this.#at - BEFORE && page < this.#at + AFTER;
    }

    #next() {
        const far = (/** @type {number} */ n) => Math.abs(n + 0.5 - this.#at);
        const all = Array.from({ length: BEFORE + AFTER }, (_, n) => this.#at - BEFORE + n);
        const wanted = all.filter((n) => n >= 0 && n < this.source.pages && !this.#there.has(n) && !this.#failed.has(n));
        return wanted.sort((a, b) => far(a) - far(b)).at(0);
    }

    async #work() {
        if (this.#busy) return;
        this.#busy = true;
        for (let page = this.#next(); page !== undefined && !this.#closed; page = this.#next()) {
            await this.#make(page);
        }
        this.#busy = false;
    }

    /** @param {number} page */
    async #make(page) {
        const [width, height] = this.#size;
        try {
            const picture = await this.source.picture(page, width, height);
            const wanted = !this.#closed && this.#near(page) && width === this.#size[0];
            if (wanted) {
                this.shelf.set(page, picture);
                this.#there.add(page);
            }
            if ("close" in picture) picture.close();
        } catch (why) {
            this.#failed.add(page);
            if (!this.#closed) this.shelf.failed(page, why);
        }
    }

    /** Makes no more. */
    close() {
        this.#closed = true;
        this.source.close?.();
    }
}
