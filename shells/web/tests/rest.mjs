// Promise: nothing is drawn, stepped or asked of the browser while the book lies still, hidden or not; and what is lost comes back.
import { drag, holds, still } from "./harness.mjs";

const counts = (page) => page.evaluate(() => ({ ...reader.view.counts }));

export default async function run(bench) {
    const page = await bench.reader();
    await bench.test("at rest nothing is drawn", async () => {
        await page.evaluate(() => {
            globalThis.asked = 0;
            const { requestAnimationFrame: ask } = window;
            window.requestAnimationFrame = (what) => (globalThis.asked += 1, ask(what));
        });
        const before = await counts(page);
        await page.mouse.move(300, 300, { steps: 5 });
        await page.waitForTimeout(1500);
        const after = await counts(page);
        const asked = await page.evaluate(() => globalThis.asked);
        holds(after.drawn === before.drawn && after.frames === before.frames && asked === 0, `${after.drawn - before.drawn} drawn, ${asked} asked`);
    });
    await bench.test("a turn is drawn, so the count would tell", async () => {
        const before = await counts(page);
        await page.keyboard.press("ArrowRight");
        await page.waitForFunction(() => !reader.book.isSleeping());
        await still(page);
        const after = await counts(page);
        holds(after.drawn > before.drawn + 3, `${after.drawn - before.drawn} drawn`);
        return `${after.drawn - before.drawn} pictures`;
    });
    await bench.test("a hidden tab takes the fingers away and comes to rest", async () => {
        const hide = (hidden) => page.evaluate((hidden) => {
            Object.defineProperty(document, "hidden", { configurable: true, get: () => hidden });
            document.dispatchEvent(new Event("visibilitychange"));
        }, hidden);
        await drag(page, [[0.9, 0.75], [0.5, 0.6]], { steps: 4, held: async () => {
            await page.waitForFunction(() => reader.book.held === 1, undefined, { timeout: 20_000 });
            await hide(true);
        } });
        const sleeps = await page.evaluate(() => reader.book.isSleeping());
        const before = await counts(page);
        await page.waitForTimeout(500);
        holds(sleeps && (await counts(page)).frames === before.frames, `asleep ${sleeps}, ${(await counts(page)).frames - before.frames} frames`);
        await hide(false);
        await still(page);
        holds((await counts(page)).drawn > before.drawn, "and is drawn when it is back");
    });
    await bench.test("a lost context is made again, with its pages", async () => {
        const lost = await page.evaluate(async () => {
            const { view } = reader;
            const hand = view.gl.getExtension("WEBGL_lose_context");
            const heard = (what) => new Promise((done) => view.canvas.addEventListener(what, done, { once: true }));
            const gone = heard("webglcontextlost");
            hand.loseContext();
            await gone;
            const drawn = view.counts.drawn;
            const back = heard("webglcontextrestored");
            await new Promise((done) => setTimeout(done, 100));
            hand.restoreContext();
            await back;
            return drawn;
        });
        await still(page);
        const after = await page.evaluate(() => ({ drawn: reader.view.counts.drawn, pages: reader.view.pages.count, error: reader.view.gl.getError() }));
        holds(after.drawn > lost && after.pages > 4 && after.error === 0, JSON.stringify(after));
        holds(page.wrong.length === 0, page.wrong.join("; "));
    });
    await bench.test("a window of another size is drawn once it has it", async () => {
        const before = await page.evaluate(() => reader.view.canvas.width);
        await page.setViewportSize({ width: 500, height: 900 });
        await page.waitForFunction((before) => reader.view.canvas.width < before, before);
        await still(page);
        const seen = await page.evaluate(() => [reader.view.canvas.width, reader.view.book.stage().widthPx, reader.where()]);
        holds(seen[0] === seen[1] && seen[2] === "10–11 of 24", `${seen}`);
    });
    await page.context().close();
}
