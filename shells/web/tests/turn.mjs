// Promise: a page dragged with a real mouse turns, and the page's own recording of it runs natively to the same hashes.
import { execFileSync } from "node:child_process";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { drag, glide, holds, spot, still } from "./harness.mjs";

const OVER = [[0.9, 0.75], [0.6, 0.6], [0.1, 0.4], [-0.6, 0.6]];

/** Pixels of the picture to look at, for each of the page's. `SHARP=1` draws what the README shows, in minutes. */
const SHARP = Number(process.env.SHARP ?? 0.4);

/** `dogleaf replay` of a file; what it answers, and whether it was content. */
function replay(bench, file) {
    try {
        return { fine: true, ...JSON.parse(execFileSync(bench.program, ["replay", "--json", file], { stdio: ["ignore", "pipe", "pipe"] })) };
    } catch (why) {
        return { fine: false, said: String(why.stderr).trim() };
    }
}

export default async function run(bench) {
    const file = join(bench.out, "turn.dlr");
    const page = await bench.reader();
    await bench.test("a dragged page turns, and is announced", async () => {
        const before = await page.evaluate(() => reader.where());
        await page.keyboard.press("a");
        await page.waitForTimeout(400);
        await still(page);
        await drag(page, OVER, { steps: 8 });
        await still(page);
        const after = await page.evaluate(() => [reader.where(), document.getElementById("announce").textContent, document.getElementById("where").textContent]);
        holds(before === "8–9 of 24" && after[0] === "10–11 of 24", `${before} became ${after[0]}`);
        holds(after[1] === "Page 10–11 of 24" && after[2] === after[0], `announced: ${after[1]}; shown: ${after[2]}`);
        holds(page.wrong.length === 0, page.wrong.join("; "));
    });
    await bench.test("its recording runs natively to the same hashes", async () => {
        const found = await page.evaluate(async () => {
            const link = document.getElementById("save");
            const bytes = new Uint8Array(await (await fetch(link.href)).arrayBuffer());
            return { bytes: [...bytes], hash: reader.book.stateHash().toString(16).padStart(16, "0") };
        });
        writeFileSync(file, Buffer.from(found.bytes));
        const native = replay(bench, file);
        holds(native.fine && native.diverged === null, native.said ?? "it diverges");
        holds(native.final_hash === found.hash, `${native.final_hash} is not ${found.hash}`);
        holds(native.steps > 20 && native.inputs > 8, `${native.steps} steps, ${native.inputs} samples`);
        return `${native.steps} steps, ${native.inputs} samples, ${found.hash}`;
    });
    await bench.test("a recording that was touched does not", async () => {
        const bent = readFileSync(file);
        bent[bent.length - 40] ^= 1;
        writeFileSync(`${file}.bent`, bent);
        holds(!replay(bench, `${file}.bent`).fine, "and still it was content");
    });
    await bench.test("a page that is not carried far comes back", async () => {
        const before = await page.evaluate(() => reader.where());
        await drag(page, [[0.9, 0.75], [0.86, 0.74]], { steps: 3 });
        await still(page);
        const after = await page.evaluate(() => reader.where());
        holds(before === after, `${before} became ${after}`);
    });
    await bench.test("with a leaf in hand the wheel takes more behind it", async () => {
        await page.keyboard.press("a");
        await still(page);
        const [from, to] = [await spot(page, 0.9, 0.75), await spot(page, 0.4, 0.5)];
        await page.mouse.move(...from);
        await page.mouse.down();
        await glide(page, from, to, 6);
        await page.keyboard.down("Shift");
        await page.mouse.wheel(0, 100);
        await page.waitForFunction(() => reader.book.held === 2, undefined, { timeout: 20_000 });
        await page.keyboard.up("Shift");
        await page.keyboard.press("Escape");
        await page.mouse.up();
        await still(page);
        holds((await page.evaluate(() => reader.book.page)) === 10, "put back");
    });
    await page.context().close();
    await touch(bench);
    await picture(bench);
}

/** Two fingers of a touch screen: the second flips leaves behind the one that the first holds. */
async function touch(bench) {
    const page = await bench.reader({ hasTouch: true });
    await bench.test("two fingers: the second marks a place", async () => {
        const session = await page.context().newCDPSession(page);
        const send = (type, ...points) => session.send("Input.dispatchTouchEvent", { type, touchPoints: points.map(([x, y, id]) => ({ x, y, id })) });
        const at = async (x, y, id) => [...(await spot(page, x, y)), id];
        await send("touchStart", await at(0.9, 0.7, 0));
        for (const x of [0.8, 0.7, 0.6, 0.5]) await send("touchMove", await at(x, 0.6, 0));
        const first = await at(0.5, 0.6, 0);
        await page.waitForFunction(() => reader.book.held === 1, undefined, { timeout: 20_000 });
        await send("touchStart", first, await at(0.9, -0.3, 1));
        for (const x of [0.8, 0.7, 0.6, 0.5]) await send("touchMove", first, await at(x, -0.3, 1));
        await page.waitForFunction(() => reader.book.held >= 2, undefined, { timeout: 20_000 });
        const held = await page.evaluate(() => reader.book.held);
        await send("touchEnd", first);
        await send("touchEnd");
        await still(page);
        return `${held} leaves in hand`;
    });
    await page.context().close();
}

/** Draws with so many pixels, and waits until that is seen. */
async function sharp(page, sharpness) {
    await page.evaluate((sharpness) => {
        const { view } = reader;
        view.options.sharpness = sharpness;
        view.resize();
        globalThis.due = view.counts.drawn + 2;
    }, sharpness);
    await page.waitForFunction(() => reader.view.pages.idle && (reader.view.counts.drawn >= globalThis.due || !reader.book.needsFrame()), undefined, { timeout: 90_000 });
}

/** What the README shows. */
async function picture(bench) {
    const page = await bench.reader({ viewport: { width: 960, height: 600 } });
    await bench.test("a picture of the page in the middle of a turn", async () => {
        await drag(page, [[0.92, 0.8], [0.55, 0.62], [0.2, 0.45]], {
            steps: 8,
            held: async () => {
                await page.waitForFunction(() => reader.book.held === 1, undefined, { timeout: 20_000 });
                await page.waitForTimeout(1500);
                await sharp(page, SHARP);
                bench.keep("turn.png", await page.screenshot());
                await sharp(page, 0.1);
            },
        });
        await still(page);
        await sharp(page, SHARP);
        bench.keep("rest.png", await page.screenshot());
    });
    await page.context().close();
}
