// Simulates a recording again with other settings, beside the page, and measures time and error.
import init, { RawReplay } from "./dogleaf/wasm/dogleaf.js";

/** What all are compared with: the finest grid at this fidelity; and the same grid at it, for what time alone costs. */
const [FINEST, REFERENCE] = ["16x12", "reference"];
/** Pictures that one reading of the clock spans: some browsers' clocks are coarse. Runs, and time for them, at most. */
const SLICE = 12;
const MOST_RUNS = 12;
const ENOUGH_MS = 500;

const ready = init({ module_or_path: new URL("./dogleaf/wasm/grids.wasm", import.meta.url) });
/** @type {Uint8Array | undefined} */
let known;
/** @type {Map<string, Float32Array[]>} */
const references = new Map();
/** @type {Promise<unknown>} */
let queue = ready;

self.addEventListener("message", ({ data }) => {
    queue = queue.then(() => work(data)).catch((why) => self.postMessage({ wrong: `It cannot be measured: ${why.message}.` }));
});

/** @param {{ bytes: Uint8Array, list: { grid: string, fidelity: string, stepUs: number }[] }} job */
async function work({ bytes, list }) {
    if (!same(bytes)) references.clear();
    known = bytes;
    const grids = [...new Set([FINEST, ...list.map(({ grid }) => grid)])].filter((grid) => !references.has(grid));
    const parts = list.length + 3 * grids.length;
    let done = 0;
    const tell = (/** @type {number} */ share) => self.postMessage({ share: (done + share) / parts });
    for (const grid of grids) {
        references.set(grid, (await run(bytes, { grid, fidelity: REFERENCE }, tell, 3)).shapes);
        done += 3;
    }
    for (const dials of list) {
        const { shapes } = await run(bytes, dials, tell, 0.3);
        const { pictureMicros, inner } = clock(bytes, dials);
        const [error, inTime] = [FINEST, dials.grid].map((grid) => apart(shapes, references.get(grid) ?? []));
        done += 1;
        tell(0);
        self.postMessage({ figure: { ...dials, pictureMicros, stepMicros: pictureMicros / inner, error, inTime } });
    }
    self.postMessage({ done: { steps: references.get(FINEST)?.length } });
}

/** @param {Uint8Array} bytes */
function same(bytes) {
    return known?.length === bytes.length && known.every((b, n) => b === bytes[n]);
}

/**
 * Once through, in slices, with the led leaf's shape after every picture.
 * @param {Uint8Array} bytes
 * @param {{ grid: string, fidelity: string, stepUs?: number }} dials
 * @param {(share: number) => void} tell
 * @param {number} worth
 */
async function run(bytes, { grid, fidelity, stepUs }, tell, worth) {
    const replay = new RawReplay(bytes, grid, fidelity, stepUs);
    /** @type {Float32Array[]} */
    const shapes = [];
    for (let n = 1; replay.prepare() > 0; n += 1) {
        replay.step();
        shapes.push(replay.shape());
        if (n % SLICE !== 0) continue;
        tell(worth * (1 - 1 / (1 + n / 100)));
        await new Promise((next) => setTimeout(next));
    }
    replay.free();
    return { shapes };
}

/**
 * Microseconds of a picture with a leaf in the air: the median of slices; and the internal steps of a picture.
 * @param {Uint8Array} bytes
 * @param {{ grid: string, fidelity: string, stepUs: number }} dials
 */
function clock(bytes, { grid, fidelity, stepUs }) {
    const times = [];
    let [inner, pictures] = [0, 0];
    const begun = performance.now();
    for (let runs = 0; runs < MOST_RUNS && (runs < 2 || performance.now() - begun < ENOUGH_MS); runs += 1) {
        const replay = new RawReplay(bytes, grid, fidelity, stepUs);
        let [start, count] = [performance.now(), 0];
        for (let kind = replay.prepare(); kind > 0; kind = replay.prepare()) {
            if (kind === 1) {
                replay.step();
                [start, count] = [performance.now(), 0];
                continue;
            }
            const before = replay.inner;
            replay.step();
            inner += replay.inner - before;
            pictures += 1;
            count += 1;
            if (count < SLICE) continue;
            // The first run lets the engine compile.
            if (runs > 0) times.push(((performance.now() - start) * 1000) / count);
            [start, count] = [performance.now(), 0];
        }
        replay.free();
    }
    times.sort((a, b) => a - b);
    return { pictureMicros: times[times.length >> 1] ?? 0, inner: inner / Math.max(pictures, 1) };
}

/**
 * RMS distance over all places and pictures in which both lead a leaf, page widths.
 * @param {Float32Array[]} found
 * @param {Float32Array[]} wanted
 */
function apart(found, wanted) {
    let [sum, places] = [0, 0];
    found.forEach((shape, n) => {
        const other = wanted[n];
        if (!other || shape.length === 0 || shape.length !== other.length) return;
        for (let i = 0; i < shape.length; i += 1) sum += (shape[i] - other[i]) ** 2;
        places += shape.length / 3;
    });
    return Math.sqrt(sum / Math.max(places, 1));
}
