// Promise: PDF, CBZ and pictures open; what is none is refused in one line and what was open stays.
import { readFileSync } from "node:fs";
import { fixture, holds, still } from "./harness.mjs";

/** Chooses files as a reader would. */
async function choose(page, ...files) {
    await page.setInputFiles("#file", files);
}

/** Drops one file on the window. */
async function drop(page, name, bytes) {
    await page.evaluate(([name, bytes]) => {
        const transfer = new DataTransfer();
        transfer.items.add(new File([new Uint8Array(bytes)], name));
        dispatchEvent(new DragEvent("dragover", { dataTransfer: transfer, cancelable: true }));
        dispatchEvent(new DragEvent("drop", { dataTransfer: transfer, cancelable: true }));
    }, [name, [...bytes]]);
}

const opened = async (page, title) => {
    await page.waitForFunction((title) => document.getElementById("title").textContent === title, title, { timeout: 30_000 });
    await still(page);
    return page.evaluate(() => ({ where: reader.where(), pages: reader.view.pages.count, news: document.getElementById("news").textContent }));
};

export default async function run(bench) {
    const page = await bench.reader();
    await bench.test("a CBZ opens when it is dropped", async () => {
        await drop(page, "verses in pictures.cbz", readFileSync(fixture("books/old-verses.cbz")));
        const found = await opened(page, "verses in pictures");
        holds(found.where === "1 of 24" && found.pages === 6 && found.news === "", JSON.stringify(found));
    });
    await bench.test("pictures open as a book, in the order of their numbers", async () => {
        const pictures = [10, 9, 8, 7].map((n) => fixture(`pictures/upright/page-${n}.png`));
        await choose(page, ...pictures);
        const found = await opened(page, "page-10");
        const shape = await page.evaluate(() => reader.source.heightM / reader.source.widthM);
        holds(found.where === "1 of 4" && found.pages === 4 && shape > 1.3 && shape < 1.7, `${JSON.stringify(found)} ${shape}`);
    });
    await bench.test("what is no book is refused in one line", async () => {
        const lines = [];
        const pdf = readFileSync(fixture("books/old-verses.pdf"));
        const cbz = readFileSync(fixture("books/old-verses.cbz"));
        const bad = {
            "notes.txt": Buffer.from("just text"), "torn.pdf": Buffer.from("%PDF-1.7\nand no more"), "torn.cbz": cbz.subarray(0, cbz.length / 2),
            "empty.zip": Buffer.from([0x50, 0x4b, 5, 6, ...new Array(18).fill(0)]), "torn.png": Buffer.from("\x89PNG and no more"), "nothing": Buffer.alloc(0),
        };
        for (const [name, buffer] of Object.entries(bad)) {
            await page.evaluate(() => { document.getElementById("news").textContent = ""; });
            await choose(page, { name, mimeType: "", buffer });
            await page.waitForFunction(() => document.getElementById("news").textContent !== "", undefined, { timeout: 20_000 });
            const line = await page.textContent("#news");
            holds(line.includes(name) && !line.includes("\n") && line.length < 120, `${name}: ${line}`);
            lines.push(line);
        }
        holds((await page.textContent("#title")) === "page-10", "what was open stays");
        holds(pdf.length > 0 && page.wrong.length === 0, page.wrong.join("; "));
        return lines.join(" ");
    });
    await bench.test("a sound book opens after all that", async () => {
        await choose(page, fixture("books/old-verses.pdf"));
        const title = await page.waitForFunction(() => document.getElementById("title").textContent !== "page-10" && document.getElementById("title").textContent);
        await still(page);
        return title.jsonValue();
    });
    await page.context().close();
}
