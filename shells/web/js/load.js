// Loads the core: the build with vectors where the browser has them.
import init, { RawReplay, version } from "./wasm/dogleaf.js";
import { Book } from "./book.js";
import { bookOptions } from "./options.js";

/** A module that only vectors make valid: one function that makes a vector and drops it. */
const VECTORS = [0, 97, 115, 109, 1, 0, 0, 0, 1, 4, 1, 96, 0, 0, 3, 2, 1, 0, 10, 8, 1, 6, 0, 65, 0, 253, 15, 26, 11];

/** Whether this engine has WebAssembly's vectors. */
export function hasVectors() {
    return WebAssembly.validate(new Uint8Array(VECTORS));
}

/**
 * @typedef {object} LoadOptions
 * @property {boolean} [vectors] the build to take; by default what the engine can
 * @property {string | URL} [folder] where `simd.wasm` and `scalar.wasm` lie; by default beside this module
 * @property {BufferSource | WebAssembly.Module} [module] the core itself, where nothing can be fetched
 */

/** The core, loaded. A page has one. */
export class Dogleaf {
    /** @type {WebAssembly.Memory} */
    #memory;

    /**
     * @param {WebAssembly.Memory} memory
     * @param {boolean} vectors
     */
    constructor(memory, vectors) {
        this.#memory = memory;
        /** Whether it is the build with vectors. */
        this.vectors = vectors;
        /** Version of dogleaf. */
        this.version = version();
    }

    /** Bytes of memory it has. */
    get bytes() {
        return this.#memory.buffer.byteLength;
    }

    /**
     * Opens a book, at rest at its page. Its mesh is there at once.
     * @param {Partial<import("./options.js").BookOptions> & { pages: number }} options
     */
    open(options) {
        return Book.open(this.#memory, bookOptions(options));
    }

    /**
     * Opens the book of a snapshot.
     * @param {Uint8Array} bytes
     */
    openSnapshot(bytes) {
        return Book.fromSnapshot(this.#memory, bytes);
    }

    /**
     * Runs a recording again, hash by hash.
     * @param {Uint8Array} bytes what `stopRecording` gave
     * @returns {{ steps: number, diverged: number | undefined, hash: bigint }}
     */
    replay(bytes) {
        const run = new RawReplay(bytes);
        while (run.prepare() > 0) run.step();
        const found = { steps: run.steps, diverged: run.diverged, hash: run.hash() };
        run.free();
        return found;
    }
}

/** @type {Promise<Dogleaf> | undefined} */
let loading;

/**
 * Loads the core, once.
 * @param {LoadOptions} [options]
 * @returns {Promise<Dogleaf>}
 */
export function load(options = {}) {
    loading ??= start(options).catch((why) => {
        loading = undefined;
        throw why;
    });
    return loading;
}

/** @param {LoadOptions} options */
async function start({ vectors = hasVectors(), folder = new URL("./wasm/", import.meta.url), module }) {
    const file = new URL(vectors ? "simd.wasm" : "scalar.wasm", folder);
    const core = await init({ module_or_path: module ?? file });
    return new Dogleaf(core.memory, vectors);
}
