// Promise: a step in the browser takes no longer than stated, beside node and native in the same run.
import { execFileSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { fixture, holds } from "./harness.mjs";

const GOLDEN = "recordings/slow_turn_f32.dlr";
/** Microseconds of a step with vectors; and times the native one, where the machine is too busy for that. */
const MOST_US = 75;
const MOST_RATIO = 2.5;
const RUNS = 40;

/** Each step's best of many runs, then the median: runs in the browser and in node alike. */
async function timed(glue, module, bytes, runs) {
    const { default: init, RawReplay } = await import(glue);
    await init({ module_or_path: module });
    const best = [];
    const all = [];
    for (let run = 0; run < runs; run += 1) {
        const replay = new RawReplay(bytes);
        for (let kind = replay.prepare(), step = 0; kind > 0; kind = replay.prepare()) {
            const start = performance.now();
            replay.step();
            const took = (performance.now() - start) * 1000;
            if (kind !== 2) continue;
            if (run > 2) all.push(took);
            best[step] = Math.min(best[step] ?? Infinity, took);
            step += 1;
        }
        if (replay.diverged !== undefined) throw new Error(`step ${replay.diverged} diverges`);
        replay.free();
    }
    const median = (list) => list.sort((a, b) => a - b)[list.length >> 1];
    return { median: median(all), best: median(best) };
}

export default async function run(bench) {
    const golden = bench.read(GOLDEN);
    const native = JSON.parse(execFileSync(bench.native, [fixture(GOLDEN)]));
    const rows = [["native", { median: native.median_us, best: native.best_us }]];
    for (const core of ["simd", "scalar"]) {
        const page = await bench.blank();
        const found = await page.evaluate(`(${timed})("/dogleaf/wasm/dogleaf.js", "/dogleaf/wasm/${core}.wasm", new Uint8Array(${JSON.stringify([...golden])}), ${RUNS})`);
        rows.push([`Chromium, ${core}`, found]);
        await page.context().close();
        const folder = join(bench.out, "dogleaf/wasm");
        const glue = `${pathToFileURL(join(folder, "dogleaf.js")).href}?${core}`;
        rows.push([`node, ${core}`, await timed(glue, readFileSync(join(folder, `${core}.wasm`)), golden, RUNS)]);
    }
    await bench.test("a step is quick enough", () => {
        console.log("| the golden turn | µs a step, median | each step's best, median | times native |\n|---|---|---|---|");
        for (const [name, { median, best }] of rows) {
            console.log(`| ${name} | ${median.toFixed(1)} | ${best.toFixed(1)} | ${(best / native.best_us).toFixed(2)} |`);
        }
        const [, { best }] = rows[1];
        holds(best <= MOST_US || best <= MOST_RATIO * native.best_us, `${best.toFixed(1)} µs, ${(best / native.best_us).toFixed(2)} times native`);
        return `${best.toFixed(1)} µs with vectors (goal ${MOST_US})`;
    });
}
