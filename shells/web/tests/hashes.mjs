// Promise: the golden gesture ends with the same hash here as natively and on the boards, with vectors and without.
import { execFileSync } from "node:child_process";
import { fixture, holds } from "./harness.mjs";

const GOLDEN = "recordings/slow_turn_f32.dlr";

/** Runs a recording in the browser. */
async function replayed(page, bytes, vectors) {
    return page.evaluate(async ([bytes, vectors]) => {
        const { load } = await import("/dogleaf/index.js");
        const dogleaf = await load({ vectors });
        try {
            const { steps, diverged, hash } = dogleaf.replay(new Uint8Array(bytes));
            return { steps, diverged, hash: hash.toString(16).padStart(16, "0"), vectors: dogleaf.vectors };
        } catch (why) {
            return { line: why.message, name: why.name, kind: why.kind };
        }
    }, [[...bytes], vectors]);
}

export default async function run(bench) {
    const golden = bench.read(GOLDEN);
    const native = JSON.parse(execFileSync(bench.native, [fixture(GOLDEN)]));
    for (const vectors of [true, false]) {
        const page = await bench.blank();
        await bench.test(`the golden turn, ${vectors ? "with vectors" : "scalar"}`, async () => {
            const found = await replayed(page, golden, vectors);
            holds(found.vectors === vectors, "another build was loaded");
            holds(found.diverged === undefined && found.steps > 100, `step ${found.diverged} differs`);
            holds(found.hash === native.hash, `${found.hash} is not ${native.hash}`);
            return `${found.steps} steps, ${found.hash}`;
        });
        await page.context().close();
    }
    const page = await bench.blank();
    await bench.test("a recording that was touched is refused in one line", async () => {
        const bent = Buffer.from(golden);
        bent[400] ^= 1;
        const found = await replayed(page, bent, true);
        holds(found.name === "DogleafError" && found.kind === "recording" && !found.line.includes("\n"), JSON.stringify(found));
        return found.line;
    });
    await bench.test("options and calls are refused in one line", async () => {
        const lines = await page.evaluate(async () => {
            const dogleaf = await (await import("/dogleaf/index.js")).load();
            const tries = [
                () => dogleaf.open({ pages: 0 }), () => dogleaf.open({ pages: 20, direction: "up" }),
                () => dogleaf.open({ pages: 20, colour: "red" }), () => dogleaf.open({ pages: 20, widthM: Number.NaN }),
                () => dogleaf.open({ pages: 20 }).turn(false), () => dogleaf.openSnapshot(new Uint8Array(3)),
                () => dogleaf.open({ pages: 20 }).pointer({ timeUs: 0, id: 0, phase: "down", x: Infinity, y: 0 }),
                () => { const b = dogleaf.open({ pages: 20 }); b.shut(); b.step(0); },
            ];
            return tries.map((attempt) => { try { attempt(); return "not refused"; } catch (why) { return `${why.kind}: ${why.message}`; } });
        });
        const kinds = ["refused", "refused", "refused", "refused", "noSuchPage", "recording", "pointer", "closed"];
        lines.forEach((line, n) => holds(line.startsWith(`${kinds[n]}: `) && !line.includes("\n"), `${n}: ${line}`));
    });
    await page.context().close();
}
