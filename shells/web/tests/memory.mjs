// Promise: a minute of scribbling leaves the core's memory and the page's heap as they were.
import { holds } from "./harness.mjs";

/** Simulated time, pictures drawn in it, and what the heap may grow by, bytes. */
const SECONDS = 60;
const DRAWN_EVERY = 60;
const SLACK = 400_000;

/** Scribbles in the browser: every frame stepped, some drawn; the heap after the first and the second half. `leak` keeps every frame, and draws none. */
function scribbled(page, leak) {
    return page.evaluate(async ([seconds, every, leak]) => {
        const { load, BookRenderer } = await import("/dogleaf/index.js");
        const dogleaf = await load();
        const [widthPx, heightPx] = [80, 60];
        const book = dogleaf.open({ pages: 240, openAt: 120, widthPx, heightPx });
        const canvas = Object.assign(document.createElement("canvas"), { width: widthPx, height: heightPx });
        const gl = canvas.getContext("webgl2");
        const renderer = new BookRenderer(gl, book);
        const kept = [];
        let seed = 1;
        const random = () => (seed = (seed * 48271) % 2147483647) / 2147483647;
        const heap = async () => {
            for (let n = 0; n < 3; n += 1) {
                globalThis.gc();
                await new Promise((next) => setTimeout(next, 20));
            }
            return performance.memory.usedJSHeapSize;
        };
        let [frame, x, y, down, drawn, committed] = [0, 0, 0, false, 0, 0];
        const half = async () => {
            for (const end = frame + seconds * 30; frame < end; frame += 1) {
                const timeUs = frame * 16667;
                const turn = random();
                if (!down && turn < 0.1) {
                    [x, y, down] = [widthPx * (0.15 + 0.7 * random()), heightPx * (0.4 + 0.4 * random()), true];
                    book.pointer({ timeUs, id: 0, phase: "down", x, y });
                } else if (down && turn < 0.03) {
                    down = false;
                    book.pointer({ timeUs, id: 0, phase: "up", x, y });
                } else if (down) {
                    [x, y] = [x + widthPx * 0.08 * (random() - 0.5), y + heightPx * 0.08 * (random() - 0.5)];
                    book.pointer({ timeUs, id: 0, phase: "move", x, y });
                }
                const info = book.step(timeUs);
                committed += book.notices().filter(({ kind }) => kind === "committed" || kind === "cancelled").length;
                if (leak) kept.push([...book.vertices.subarray(0, 100)]);
                if (info.draw && frame % every === 0) {
                    renderer.draw(info);
                    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
                    drawn += 1;
                    await new Promise((next) => setTimeout(next));
                }
            }
            return [await heap(), dogleaf.bytes];
        };
        const [first, second] = [await half(), await half()];
        renderer.release();
        book.shut();
        return { heap: [first[0], second[0]], core: [first[1], second[1]], drawn, committed, kept: kept.length };
    }, [SECONDS, leak ? Infinity : DRAWN_EVERY, leak]);
}

export default async function run(bench) {
    const page = await bench.blank();
    await bench.test(`${SECONDS} s of scribbling leave memory flat`, async () => {
        const { heap, core, drawn, committed } = await scribbled(page, false);
        holds(core[0] === core[1], `the core's memory: ${core}`);
        holds(heap[1] - heap[0] < SLACK, `the heap: ${heap}`);
        holds(drawn > 20 && committed > 5, `${drawn} drawn, ${committed} turns ended`);
        return `heap ${heap.map((n) => (n / 1e6).toFixed(2)).join(" → ")} MB, core ${core[1] / 1e6} MB, ${drawn} drawn, ${committed} turns ended`;
    });
    await bench.test("a leak would be seen", async () => {
        const { heap } = await scribbled(page, true);
        holds(heap[1] - heap[0] >= SLACK, `the heap: ${heap}`);
    });
    await page.context().close();
}
