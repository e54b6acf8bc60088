// Promise: the pane shows what accuracy costs for the gesture just made, and the page goes on meanwhile.
import { drag, holds, still } from "./harness.mjs";

export default async function run(bench) {
    const page = await bench.reader({ viewport: { width: 1200, height: 720 } });
    const done = () => page.waitForFunction(() => document.getElementById("cost-bar").hidden && lab.figures.length > 0, undefined, { timeout: 90_000 });
    const figure = (fidelity, grid = "11x8", stepUs = 16667) => page.evaluate(([f, g, s]) =>
        lab.figures.find(({ fidelity, grid, stepUs }) => fidelity === f && grid === g && stepUs === s), [fidelity, grid, stepUs]);
    await bench.test("fidelities cost more and err less", async () => {
        await page.click("#lab");
        await page.waitForFunction(() => lab.figures.length === 4, undefined, { timeout: 90_000 });
        const [draft, standard, fine, reference] = await Promise.all(["draft", "standard", "fine", "reference"].map((f) => figure(f)));
        const list = JSON.stringify([draft, standard, fine, reference]);
        holds(standard.pictureMicros < fine.pictureMicros && fine.pictureMicros < reference.pictureMicros, list);
        holds(standard.error > fine.error && fine.error > reference.error && standard.inTime > fine.inTime && reference.inTime === 0, list);
        holds((await page.locator("#plot circle").count()) === 4 + 3, "a dot each, and a ring");
        bench.keep("cost.png", await page.screenshot());
        return [draft, standard, fine, reference].map((f) => `${f.fidelity} ${f.pictureMicros.toFixed(0)} µs a picture, ${f.error.toFixed(3)}`).join("; ");
    });
    await bench.test("grid and step change both too", async () => {
        await page.selectOption("#grid", "6x5");
        await page.waitForFunction(() => lab.figures.some((f) => f.grid === "6x5"), undefined, { timeout: 60_000 });
        const [coarse, fine] = [await figure("fine", "6x5"), await figure("fine")];
        holds(coarse.pictureMicros < fine.pictureMicros && coarse.error > fine.error, JSON.stringify([coarse, fine]));
        await page.selectOption("#grid", "11x8");
        await page.selectOption("#step", "8333");
        await page.waitForFunction(() => lab.figures.some((f) => f.stepUs === 8333), undefined, { timeout: 60_000 });
        const half = await figure("fine", "11x8", 8333);
        holds(half.pictureMicros > fine.pictureMicros && half.inTime < fine.inTime, JSON.stringify([half, fine]));
    });
    await bench.test("the next gesture is the reader's own, and the page goes on while it is measured", async () => {
        await done();
        await drag(page, [[0.9, 0.7], [0.5, 0.6], [-0.4, 0.6]], { steps: 10 });
        await still(page);
        await page.waitForFunction(() => document.getElementById("cost-state").textContent.startsWith("Your gesture"), undefined, { timeout: 60_000 });
        await page.keyboard.press("ArrowLeft");
        await page.waitForFunction(() => !reader.book.isSleeping(), undefined, { timeout: 5000 });
        await still(page);
        holds(page.wrong.length === 0, page.wrong.join("; "));
    });
    await page.context().close();
}
