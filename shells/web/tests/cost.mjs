// Promise: the pane shows what accuracy costs for the gesture just made, and the page goes on meanwhile.
import { drag, holds, still } from "./harness.mjs";

export default async function run(bench) {
    const page = await bench.reader({ viewport: { width: 1000, height: 720 } });
    await bench.test("fidelities cost more and err less", async () => {
        await page.click("#lab");
        await drag(page, [[0.9, 0.7], [0.5, 0.6], [-0.4, 0.6]], { steps: 10 });
        await still(page);
        await page.click("#sweep");
        const figures = () => page.evaluate(() => lab.figures);
        await page.waitForFunction(() => lab.figures.length === 4 && document.getElementById("cost-bar").hidden, undefined, { timeout: 90_000 });
        const list = Object.fromEntries((await figures()).map((f) => [f.fidelity, f]));
        const { standard, fine, reference } = list;
        holds(standard.pictureMicros < fine.pictureMicros && fine.pictureMicros < reference.pictureMicros, JSON.stringify(list));
        holds(standard.error > fine.error && fine.error > 0, JSON.stringify(list));
        holds((await page.locator("#plot circle").count()) === 4, "four dots");
        bench.keep("cost.png", await page.screenshot());
        return Object.values(list).map((f) => `${f.fidelity} ${f.stepMicros.toFixed(0)} µs a step, ${f.pictureMicros.toFixed(0)} a picture, ${f.error.toExponential(1)}`).join("; ");
    });
    await bench.test("grid and step change both too", async () => {
        await page.selectOption("#grid", "6x5");
        await page.waitForFunction(() => lab.figures.some((f) => f.grid === "6x5") && document.getElementById("cost-bar").hidden, undefined, { timeout: 60_000 });
        const [coarse, fine] = await page.evaluate(() => ["6x5", "11x8"].map((g) => lab.figures.find((f) => f.grid === g && f.fidelity === "fine")));
        holds(coarse.pictureMicros < fine.pictureMicros && coarse.error > fine.error, JSON.stringify([coarse, fine]));
        await page.selectOption("#step", "8333");
        await page.waitForFunction(() => lab.figures.some((f) => f.stepUs === 8333), undefined, { timeout: 60_000 });
        holds(page.wrong.length === 0, page.wrong.join("; "));
    });
    await page.context().close();
}
