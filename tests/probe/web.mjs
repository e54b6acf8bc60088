// Runs the probes in WebAssembly: `node web.mjs FILE.wasm`; or times the recorded turn: `node web.mjs FILE.wasm --time`.
import { readFileSync } from "node:fs";

const [file, mode] = process.argv.slice(2);
const { instance } = await WebAssembly.instantiate(readFileSync(file), {});
const core = instance.exports;

function word(probe, part) {
    const bytes = new Uint8Array(core.memory.buffer, core.word_at(probe, part), core.word_length(probe, part));
    return new TextDecoder().decode(bytes);
}

function hashes() {
    for (let probe = 0; core.word_length(probe, 0) > 0; probe += 1) {
        const hash = BigInt.asUintN(64, core.run(probe)).toString(16).padStart(16, "0");
        console.log([0, 1, 2].map((part) => word(probe, part)).join(" "), hash);
    }
}

/** Microseconds of every step with a leaf in the air, of one run through the recording. */
function turn() {
    const times = [];
    core.timing_begin();
    for (let kind = core.timing_prepare(); kind !== 0; kind = core.timing_prepare()) {
        const start = process.hrtime.bigint();
        core.timing_step();
        const took = Number(process.hrtime.bigint() - start) / 1000;
        if (kind === 2) {
            times.push(took);
        }
    }
    return times;
}

function quantile(times, share) {
    const sorted = [...times].sort((a, b) => a - b);
    return sorted[Math.min(sorted.length - 1, Math.floor(share * sorted.length))];
}

/** The first runs let the engine compile; then each step's best of ten, so that a busy machine counts less. */
function clock() {
    for (let run = 0; run < 20; run += 1) {
        turn();
    }
    const runs = Array.from({ length: 10 }, turn);
    const best = runs[0].map((_, step) => Math.min(...runs.map((times) => times[step])));
    const all = runs.flat();
    const figures = [quantile(all, 0.5), quantile(best, 0.5), quantile(best, 0.99)];
    console.log("time", figures.map((figure) => figure.toFixed(1)).join(" "), best.length);
    if (core.timing_different() !== 0 || best.length === 0) {
        console.error(`web: ${core.timing_different()} steps differ from the recording, ${best.length} timed`);
        process.exitCode = 1;
    }
}

if (mode === "--time") {
    clock();
} else {
    hashes();
}
