// Promise: once it was open, the page opens without a network, and asks nobody else.
import { holds, still } from "./harness.mjs";

export default async function run(bench) {
    const page = await bench.reader({ workers: "allow" });
    await bench.test("it opens again without a network", async () => {
        const strangers = [];
        page.on("request", (r) => !/^(blob|data):/.test(r.url()) && !r.url().startsWith(bench.url) && strangers.push(r.url()));
        await page.evaluate(() => navigator.serviceWorker.ready.then(() => navigator.serviceWorker.controller ?? new Promise((done) => { navigator.serviceWorker.oncontrollerchange = done; })).then(() => true));
        await page.context().setOffline(true);
        await page.reload();
        await still(page);
        const where = await page.evaluate(() => reader.where());
        holds(where === "8–9 of 24" && strangers.length === 0, `${where}; asked ${strangers}`);
    });
    await bench.test("what is not kept is not there, so the network is gone", async () => {
        const gone = await page.evaluate(() => fetch("no-such-file?fresh").then(() => false, () => true));
        holds(gone, "something answered");
    });
    await page.context().close();
}
