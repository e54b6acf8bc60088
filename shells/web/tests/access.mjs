// Promise: keys, right to left, and what the system asks for about motion, also while the page is open.
import { holds, still } from "./harness.mjs";

const motion = (page) => page.evaluate(() => reader.book.motion.policy);
const at = (page) => page.evaluate(() => reader.book.page);

async function press(page, key) {
    await page.keyboard.press(key);
    await page.waitForTimeout(50);
    await still(page);
    return at(page);
}

export default async function run(bench) {
    const page = await bench.reader({ reducedMotion: "reduce" });
    await bench.test("motion is as the system asks, and follows when that changes", async () => {
        holds((await motion(page)) === "reduced", "asked for less from the start");
        await page.emulateMedia({ reducedMotion: "no-preference" });
        await page.waitForFunction(() => reader.book.motion.policy === "full", undefined, { timeout: 5000 });
        await page.emulateMedia({ reducedMotion: "reduce" });
        await page.waitForFunction(() => reader.book.motion.policy === "reduced", undefined, { timeout: 5000 });
    });
    await bench.test("little motion is few pictures, and the same page", async () => {
        const before = await page.evaluate(() => reader.view.counts.drawn);
        const to = await press(page, "ArrowRight");
        const drawn = (await page.evaluate(() => reader.view.counts.drawn)) - before;
        // One as it was let go, one as it lies; and new pages' pictures as they come.
        holds(to === 10 && drawn <= 2 + 4, `page ${to}, ${drawn} pictures`);
        return `${drawn} pictures`;
    });
    await bench.test("keys turn to the ends of the book", async () => {
        holds((await press(page, "PageUp")) === 8, "back");
        holds((await press(page, "End")) === 24, "to the end");
        holds(await page.isDisabled("#on"), "no further");
        holds((await press(page, "Home")) === 0, "to the beginning");
    });
    await bench.test("right to left the arrows turn round", async () => {
        await page.keyboard.press("s");
        await page.check('input[name="direction"][value="rtl"]');
        await page.keyboard.press("Escape");
        await still(page);
        await page.focus("#book");
        holds((await press(page, "ArrowLeft")) === 2, "on");
        holds((await press(page, "ArrowRight")) === 0, "back");
    });
    await bench.test("everything that can be pressed has a name", async () => {
        const nameless = await page.evaluate(() => [...document.querySelectorAll("button, input:not([hidden]), select, canvas, [role=img]")]
            .filter((e) => !(e.ariaLabel || e.textContent.trim() || e.labels?.length || e.title || e.closest("label"))).map((e) => e.outerHTML));
        holds(nameless.length === 0, nameless.join(" "));
        holds(await page.evaluate(() => document.getElementById("announce").ariaLive === "polite"), "pages are announced");
    });
    await page.context().close();
}
