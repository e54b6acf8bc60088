// What the tests share: a browser, a server, checks that are counted.
import { createRequire } from "node:module";
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { serve } from "./serve.mjs";

/** A browser in memory, without a network of its own, with WebGL drawn by the processor. */
const FLAGS = [
    "--no-sandbox", "--disable-quic", "--no-first-run", "--disable-background-networking", "--disable-component-update",
    "--disable-sync", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--js-flags=--expose-gc",
    "--enable-precise-memory-info", "--hide-scrollbars",
];
const CHROMIUM = process.env.CHROMIUM ?? "/usr/bin/chromium";

/** Files of the source. */
export const fixture = (name) => join("fixtures", name);

/** Everything that a test is given. */
export class Bench {
    counts = { passed: 0, failed: 0 };

    /** @param {string} out folder that `cargo ci web` filled */
    static async open(out, native, program) {
        const bench = new Bench();
        const require = createRequire(join(out, "tools/package.json"));
        const { chromium } = require("playwright-core");
        Object.assign(bench, { out, native, program, ...(await serve(out)) });
        bench.browser = await chromium.launch({ executablePath: CHROMIUM, args: FLAGS });
        mkdirSync(join(out, "pictures"), { recursive: true });
        return bench;
    }

    /** A page with nothing on it, from which the package can be imported. */
    async blank(options = {}) {
        const context = await this.browser.newContext(options);
        const page = await context.newPage();
        await page.route("**/blank", (route) => route.fulfill({
            contentType: "text/html", body: "<!doctype html>",
            headers: { "Cross-Origin-Opener-Policy": "same-origin", "Cross-Origin-Embedder-Policy": "require-corp" },
        }));
        await page.goto(`${this.url}/blank`);
        return page;
    }

    /** The reader's page, with its first book open and lying still. */
    async reader({ viewport = { width: 960, height: 640 }, workers = "block", sharpness = 0.1, ...options } = {}) {
        const context = await this.browser.newContext({ viewport, serviceWorkers: workers, ...options });
        const page = await context.newPage();
        page.wrong = [];
        page.on("pageerror", (why) => page.wrong.push(String(why)));
        // A processor draws: fewer pixels, so that frames come as they would.
        await page.goto(`${this.url}/reader/?sharpness=${sharpness}`);
        await still(page);
        return page;
    }

    /** Writes something to look at. */
    keep(name, bytes) {
        writeFileSync(join(this.out, "pictures", name), bytes);
    }

    read(name) {
        return readFileSync(fixture(name));
    }

    /** One promise. */
    async test(name, body) {
        const start = performance.now();
        try {
            const said = await body();
            this.counts.passed += 1;
            console.log(`ok      ${name}${said ? `: ${said}` : ""} (${((performance.now() - start) / 1000).toFixed(1)} s)`);
        } catch (why) {
            this.counts.failed += 1;
            console.log(`FAILED  ${name}: ${why?.stack ?? why}`);
        }
    }

    async close() {
        await this.browser.close();
        await this.stop();
        const { passed, failed } = this.counts;
        console.log(`test result: ${failed ? "FAILED" : "ok"}. ${passed} passed; ${failed} failed; 0 ignored`);
        return failed === 0;
    }
}

/** Throws with one line unless it holds. */
export function holds(truth, line) {
    if (!truth) throw new Error(line);
}

/** Waits until the book on the page lies, its pictures are there, and nothing is asked of the browser. */
export async function still(page) {
    await page.waitForFunction(() => {
        const view = globalThis.reader?.view;
        if (!view || !document.body.classList.contains("ready")) return false;
        const { pages, book } = view;
        return book.isSleeping() && !book.needsFrame() && pages.idle;
    }, undefined, { timeout: 60_000 });
}

/** A place on the book: widths of a page right of the spine, half heights below the middle. */
export async function spot(page, across, down) {
    return page.evaluate(([across, down]) => {
        const { view } = globalThis.reader;
        const { viewProjection: m, pageWidthM, pageHeightM } = view.book.stage();
        const [x, z] = [across * pageWidthM, (down * pageHeightM) / 2];
        const clip = (r) => m[r] * x + m[8 + r] * z + m[12 + r];
        const box = view.canvas.getBoundingClientRect();
        const place = [(clip(0) / clip(3) + 1) / 2, (1 - clip(1) / clip(3)) / 2];
        return [box.left + place[0] * box.width, box.top + place[1] * box.height];
    }, [across, down]);
}

/** Time between two moves, ms: no hand is as quick as a quick machine. */
const PACE = 16;

/** Moves the mouse from one place of the page to another at a hand's pace. */
export async function glide(page, from, to, steps) {
    for (let n = 1; n <= steps; n += 1) {
        await page.mouse.move(from[0] + ((to[0] - from[0]) * n) / steps, from[1] + ((to[1] - from[1]) * n) / steps);
        await page.waitForTimeout(PACE);
    }
}

/** Drags the mouse along places on the book; `held` is called before it lets go. */
export async function drag(page, places, { steps = 12, held = async () => {} } = {}) {
    const all = await Promise.all(places.map(([x, y]) => spot(page, x, y)));
    await page.mouse.move(...all[0]);
    await page.mouse.down();
    for (let k = 1; k < all.length; k += 1) await glide(page, all[k - 1], all[k], steps);
    await held();
    await page.mouse.up();
}
