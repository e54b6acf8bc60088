// From the browser's pointer events to the samples a book is given.

/** Number of the finger that a wheel or a key stands for. */
const SECOND = 61;
/** Where it presses and how far it goes, in views. */
const BESIDE = 0.75;
const WAY = 0.08;

/** Mouse, fingers and pens on an element, until `release`. */
export class Fingers {
    /** @type {Map<number, { id: number, x: number, y: number }>} */
    #down = new Map();
    #gone = new AbortController();

    /**
     * @param {HTMLElement} element
     * @param {(sample: import("./book.js").PointerSample) => void} give
     * @param {() => [number, number]} size pixels of the view, which need not be the element's
     */
    constructor(element, give, size) {
        this.element = element;
        this.give = give;
        this.size = size;
        const on = (/** @type {string} */ kind, /** @type {(event: PointerEvent) => void} */ what) => {
            const heard = /** @type {EventListener} */ (/** @type {unknown} */ (what));
            element.addEventListener(kind, heard, { signal: this.#gone.signal });
        };
        on("pointerdown", (event) => this.#press(event));
        on("pointermove", (event) => this.#move(event));
        on("pointerup", (event) => this.#leave(event, "up"));
        on("pointercancel", (event) => this.#leave(event, "cancel"));
        on("lostpointercapture", (event) => this.#leave(event, "cancel"));
    }

    /** Whether something is pressed. */
    get pressed() {
        return this.#down.size > 0;
    }

    /** @param {PointerEvent} event */
    #press(event) {
        if (event.button !== 0) return;
        const taken = new Set([...this.#down.values()].map(({ id }) => id));
        const id = [...Array(SECOND).keys()].find((n) => !taken.has(n)) ?? 0;
        this.#down.set(event.pointerId, { id, x: 0, y: 0 });
        // A synthetic event has no pointer to capture.
        try {
            this.element.setPointerCapture(event.pointerId);
        } catch {}
        this.#tell(event, "down");
    }

    /** @param {PointerEvent} event */
    #move(event) {
        if (!this.#down.has(event.pointerId)) return;
        // All that the system collected since the last frame: the speed of a flick is the finger's.
        const all = event.getCoalescedEvents?.() ?? [];
        for (const one of all.length > 0 ? all : [event]) this.#tell(one, "move");
    }

    /**
     * @param {PointerEvent} event
     * @param {"up" | "cancel"} phase
     */
    #leave(event, phase) {
        if (!this.#down.has(event.pointerId)) return;
        this.#tell(event, phase);
        this.#down.delete(event.pointerId);
    }

    /**
     * @param {PointerEvent} event
     * @param {import("./book.js").PointerSample["phase"]} phase
     */
    #tell(event, phase) {
        const finger = this.#down.get(event.pointerId);
        if (!finger) return;
        const box = this.element.getBoundingClientRect();
        const [width, height] = this.size();
        // What a lost capture says of its place is nothing.
        if (phase !== "cancel") {
            finger.x = ((event.clientX - box.left) / box.width) * width;
            finger.y = ((event.clientY - box.top) / box.height) * height;
        }
        this.give({ timeUs: Math.round(event.timeStamp * 1000), phase, ...finger });
    }

    /**
     * A second finger that takes one more leaf behind the one in hand, or gives one back: for a wheel or a key.
     * @param {boolean} more
     * @param {number} timeUs
     */
    bookmark(more, timeUs) {
        if (!this.pressed) return;
        const [width, height] = this.size();
        const y = 0.5 * height;
        const to = BESIDE + (more ? -WAY : WAY);
        const way = /** @type {const} */ ([["down", BESIDE], ["move", to], ["up", to]]);
        for (const [phase, x] of way) this.give({ timeUs, id: SECOND, phase, x: x * width, y });
    }

    /**
     * Puts back what is in hand.
     * @param {number} timeUs
     */
    putBack(timeUs) {
        for (const finger of this.#down.values()) this.give({ timeUs, phase: "cancel", ...finger });
        this.#down.clear();
    }

    /** Hears nothing any more. */
    release() {
        this.#gone.abort();
    }
}
