// A book being read: pointer samples and time in, a mesh and notices out. The names are those of the other shells.
import { RawBook } from "./wasm/dogleaf.js";
import { DogleafError } from "./options.js";
import { notice, piece, stage } from "./words.js";

/** Numbers a vertex and a piece take, and phases as the core counts them. */
export const FLOATS = 8;
const NOTICE = 3;
const PIECE = 9;
const PHASES = { down: 0, move: 1, up: 2, cancel: 3 };
const STATUSES = /** @type {const} */ (["asleep", "converged", "reduced", "stalled", "held", "recovered"]);

/**
 * @typedef {object} PointerSample
 * @property {number} timeUs when, microseconds of the clock that `step` is called with
 * @property {number} id which finger, 0 to 62; a second one flips leaves behind the one the first holds
 * @property {keyof PHASES} phase what it did
 * @property {number} x pixels of the view from its left edge
 * @property {number} y pixels from its top edge
 * @property {number} [leaves] leaves to take up at once, with `down`
 *
 * @typedef {object} FrameInfo
 * @property {boolean} draw the mesh was made anew: upload it and draw
 * @property {boolean} needsFrame call again at the next frame; else not before the next input
 * @property {number} generation moves when the vertices do
 * @property {number} piecesGeneration moves when a piece shows another page, comes or goes
 * @property {number} stretch largest stretch of the leaf's edges, as a share of their length
 * @property {number} through share of the light that passes the leaf in the air
 * @property {number} flyingThrough the same of the leaf that slips into the hand or out of it
 * @property {typeof STATUSES[number]} status how the physics went
 * @property {{ steps: number, newtonSteps: number, cuts: number, passes: number, chainSolves: number, parted: number }} work
 *   what it cost: internal steps, factorisations, line-search cuts, collision passes, small solves, steps taken again
 *
 * @typedef {object} Motion
 * @property {"full" | "reduced" | "none" | "eink"} policy what is shown; what becomes of a turn is the same under each
 * @property {number | undefined} capUs longest time until a leaf that is let go lies; none leaves it to the paper
 */

/** A book. `Dogleaf.open` makes one; `shut` frees its memory. */
export class Book {
    /** @type {RawBook | undefined} */
    #raw;
    /** @type {WebAssembly.Memory} */
    #memory;
    /** @type {Float32Array | undefined} */
    #vertices;
    /** @type {Uint16Array | undefined} */
    #indices;
    /** @type {Float64Array | undefined} */
    #figures;

    /**
     * For `Dogleaf.open`.
     * @param {WebAssembly.Memory} memory
     * @param {object} raw
     */
    constructor(memory, raw) {
        this.#memory = memory;
        // The core's own types stay out of the package's.
        this.#raw = /** @type {RawBook} */ (raw);
    }

    /**
     * @param {WebAssembly.Memory} memory
     * @param {import("./options.js").BookOptions} options
     */
    static open(memory, options) {
        return new Book(memory, RawBook.open(options));
    }

    /**
     * @param {WebAssembly.Memory} memory
     * @param {Uint8Array} bytes
     */
    static fromSnapshot(memory, bytes) {
        return new Book(memory, RawBook.fromSnapshot(bytes));
    }

    get #open() {
        if (!this.#raw) throw new DogleafError("closed", "the book is closed");
        return this.#raw;
    }

    /**
     * Takes a pointer sample. A paused book takes none and says nothing.
     * @param {PointerSample} sample
     */
    pointer({ timeUs, id, phase, x, y, leaves = 0 }) {
        this.#open.pointer(timeUs, id, PHASES[phase], x, y, leaves);
    }

    /**
     * Takes a batch of samples, oldest first. Those before a bad one were taken.
     * @param {PointerSample[]} samples
     */
    pointers(samples) {
        for (const sample of samples) this.pointer(sample);
    }

    /**
     * Lets time pass until `nowUs`, the time of the frame to be drawn, and makes the mesh if it changed.
     * @param {number} nowUs
     * @returns {FrameInfo}
     */
    step(nowUs) {
        const bits = this.#open.step(nowUs);
        return this.#info((bits & 1) !== 0, (bits & 2) !== 0);
    }

    /**
     * What the last step answered.
     * @returns {FrameInfo}
     */
    frame() {
        return this.#info(false, this.needsFrame());
    }

    /**
     * @param {boolean} draw
     * @param {boolean} needsFrame
     * @returns {FrameInfo}
     */
    #info(draw, needsFrame) {
        const figures = this.#seen(this.#figures, Float64Array, this.#open.figuresAt, 12);
        this.#figures = figures;
        const [generation, piecesGeneration, stretch, through, flyingThrough, status] = figures;
        const [steps, newtonSteps, cuts, passes, chainSolves, parted] = figures.subarray(6);
        const work = { steps, newtonSteps, cuts, passes, chainSolves, parted };
        const words = { generation, piecesGeneration, stretch, through, flyingThrough, status: STATUSES[status], work };
        return { draw, needsFrame, ...words };
    }

    /**
     * A view of the core's memory. A browser makes that anew when it grows; then the view is too.
     * @template {Float32Array | Float64Array | Uint16Array} T
     * @param {T | undefined} kept
     * @param {{ new(buffer: ArrayBuffer, at: number, length: number): T }} kind
     * @param {number} at
     * @param {number} length
     * @returns {T}
     */
    #seen(kept, kind, at, length) {
        const there = kept?.buffer === this.#memory.buffer;
        return there && kept ? kept : new kind(this.#memory.buffer, at, length);
    }

    /**
     * The vertices, eight floats each: position (metres), normal, place in the page picture. It lies in the core's
     * memory: ask again in every frame, and read it before the next call that changes the book.
     */
    get vertices() {
        const raw = this.#open;
        return (this.#vertices = this.#seen(this.#vertices, Float32Array, raw.verticesAt, FLOATS * raw.vertices));
    }

    /** The indices, three a triangle. They never change. */
    get indices() {
        const raw = this.#open;
        return (this.#indices = this.#seen(this.#indices, Uint16Array, raw.indicesAt, raw.indices));
    }

    /** What the mesh is made of. Ask again when `piecesGeneration` moved. */
    pieces() {
        return split(this.#open.pieces(), PIECE).map(piece);
    }

    /** All notices waiting, oldest first. */
    notices() {
        return split(this.#open.notices(), NOTICE).map(notice);
    }

    /** What stands around the book, for the renderer. Ask again after `look` and `resize`. */
    stage() {
        return stage(this.#open.stage());
    }

    /** Whether `step` has to be called again. False while everything is at rest or paused. */
    needsFrame() {
        return this.#open.needsFrame();
    }

    /**
     * Turns leaves on, or back, as a key or a screen reader asks for.
     * @param {boolean} forward
     * @param {number} [leaves]
     */
    turn(forward, leaves = 1) {
        this.#open.turn(forward, leaves);
    }

    /** Lets the leaf that nobody holds come to lie at once. */
    skip() {
        this.#open.skip();
    }

    /** @returns {Motion} */
    get motion() {
        const { policy, capUs } = this.#open;
        return { policy: /** @type {Motion["policy"]} */ (policy), capUs };
    }

    /**
     * Changes what moves, also in the middle of a turn.
     * @param {Motion["policy"]} policy
     * @param {number} [capUs]
     */
    setMotion(policy, capUs) {
        this.#open.setMotion(policy, capUs);
    }

    /**
     * Looks from elsewhere, in a view of this size.
     * @param {"table" | "above"} gaze
     * @param {number} widthPx
     * @param {number} heightPx
     */
    look(gaze, widthPx, heightPx) {
        this.#open.look(gaze, widthPx, heightPx);
    }

    /**
     * The view has another size.
     * @param {number} widthPx
     * @param {number} heightPx
     */
    resize(widthPx, heightPx) {
        this.#open.look(this.#open.gaze, widthPx, heightPx);
    }

    /** The picture is lost (a GL context, say): the next `step` asks to draw. */
    redraw() {
        this.#open.redraw();
    }

    /** The page goes into the background: fingers are taken away, the leaf comes to rest. */
    pause() {
        this.#open.pause();
    }

    /** It is back. Time that passed meanwhile does not count. */
    resume() {
        this.#open.resume();
    }

    /** What `restore` needs, some 300 bytes. A leaf in the air counts as put back. */
    snapshot() {
        return this.#open.snapshot();
    }

    /**
     * Opens the book of a snapshot in place of this one; a recording under way is dropped.
     * @param {Uint8Array} bytes
     */
    restore(bytes) {
        this.#open.restore(bytes);
    }

    /** Page the book is open at. */
    get page() {
        return this.#open.page;
    }

    /** Pages of the book. */
    get pages() {
        return this.#open.pages;
    }

    /** Share of the book that is read, 0 to 1: what the two fore-edges show. */
    get progress() {
        return this.#open.progress;
    }

    /** Leaves in hand; nought while none is in the air. */
    get held() {
        return this.#open.held;
    }

    /** Hash of the state: equal on every platform after the same calls. */
    stateHash() {
        return this.#open.stateHash();
    }

    /** Whether everything is at rest. */
    isSleeping() {
        return this.#open.isSleeping();
    }

    /** Records from now on what the book is given, and a hash a step. It is opened anew at its page for that. */
    startRecording() {
        this.#open.startRecording();
    }

    /** Ends the recording: the bytes of a `.dlr` file, which `dogleaf replay` runs again. */
    stopRecording() {
        return this.#open.stopRecording();
    }

    /** Ends the book: every later call is refused, and its memory is free. */
    shut() {
        this.#raw?.free();
        this.#raw = undefined;
    }
}

/**
 * @template {Int32Array | Uint32Array} T
 * @param {T} numbers
 * @param {number} size
 * @returns {T[]}
 */
function split(numbers, size) {
    const count = Math.floor(numbers.length / size);
    return Array.from({ length: count }, (_, n) => /** @type {T} */ (numbers.subarray(n * size, (n + 1) * size)));
}
