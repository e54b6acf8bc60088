// Promise: the mesh in the browser is the native one, byte for byte; and views of it survive that memory grows.
import { execFileSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { fixture, holds } from "./harness.mjs";

const GESTURE = "gestures/corner_turn.jsonl";
const [WIDTH, HEIGHT, UNTIL_US, FRAME_US] = [960, 720, 750_000, 16_667];

/** Plays the gesture in the browser; its vertices and hash. */
function played(page, samples, until) {
    return page.evaluate(async ([samples, WIDTH, HEIGHT, until, FRAME_US]) => {
        const dogleaf = await (await import("/dogleaf/index.js")).load();
        const book = dogleaf.open({ pages: 24, openAt: 8, widthPx: WIDTH, heightPx: HEIGHT });
        for (let frame = 0, next = 0; frame * FRAME_US <= until; frame += 1) {
            for (; next < samples.length && samples[next].t_us <= frame * FRAME_US; next += 1) {
                const { t_us, id, phase, x, y } = samples[next];
                book.pointer({ timeUs: t_us, id, phase, x: x / 256, y: y / 256 });
            }
            book.step(frame * FRAME_US);
        }
        const { vertices } = book;
        const hash = book.stateHash().toString(16).padStart(16, "0");
        const bytes = [...new Uint8Array(vertices.buffer.slice(vertices.byteOffset, vertices.byteOffset + vertices.byteLength))];
        // Books enough that the memory has to grow: the old view is then of nothing.
        const size = dogleaf.bytes;
        const books = [];
        while (dogleaf.bytes === size && books.length < 500) books.push(dogleaf.open({ pages: 20 }));
        const again = book.vertices;
        const grown = { more: dogleaf.bytes - size, gone: vertices.length === 0, same: again[0] === new Float32Array(new Uint8Array(bytes).buffer)[0] };
        for (const other of [book, ...books]) other.shut();
        return { bytes, hash, grown };
    }, [samples, WIDTH, HEIGHT, until, FRAME_US]);
}

export default async function run(bench) {
    const page = await bench.blank();
    const samples = String(bench.read(GESTURE)).trim().split("\n").map((line) => JSON.parse(line));
    const file = join(bench.out, "mesh.bin");
    const args = ["--gesture", fixture(GESTURE), WIDTH, HEIGHT, UNTIL_US, "--mesh", file].map(String);
    const hash = String(execFileSync(bench.native, args)).trim();
    const native = readFileSync(file);
    await bench.test("the mesh is the native one, to the byte", async () => {
        const found = await played(page, samples, UNTIL_US);
        holds(found.hash === hash, `state ${found.hash}, natively ${hash}`);
        holds(Buffer.from(found.bytes).equals(native), "the vertices differ");
        const { more, gone, same } = found.grown;
        holds(more > 0 && gone && same, `after memory grew: ${JSON.stringify(found.grown)}`);
        return `${native.length} bytes, state ${hash}`;
    });
    await bench.test("a frame later it is another", async () => {
        const found = await played(page, samples, UNTIL_US + FRAME_US);
        holds(!Buffer.from(found.bytes).equals(native), "the measure sees nothing");
    });
    await page.context().close();
}
