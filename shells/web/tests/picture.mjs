// Promise: what WebGL draws is the one reference picture, within a stated tolerance; and the measure would notice.
import { fixture, holds } from "./harness.mjs";
import { readFileSync } from "node:fs";

const FOLDER = "pictures/upright";
/** Mean difference from the reference, and what 99 of 100 bytes keep to, in 1/255. */
const [MEAN, MOST] = [2, 25];

function scene() {
    const lines = String(readFileSync(fixture(`${FOLDER}/scene.txt`))).trim().split("\n");
    return Object.fromEntries(lines.map((line) => line.split(" = ", 2)));
}

/** Draws the scene in the browser and compares there; `later` frames beyond it, `swap` shows the first page as the last. */
function drawn(page, given, later = 0, swap = false) {
    return page.evaluate(async ([{ scene, samples, files }, later, swap]) => {
        const { load, BookRenderer } = await import("/dogleaf/index.js");
        const dogleaf = await load();
        const number = (key) => Number(scene[key]);
        const pair = (key) => scene[key].split(" ").map(Number);
        const [widthPx, heightPx] = pair("view_px");
        const book = dogleaf.open({
            pages: number("pages"), openAt: number("open_at"), widthM: number("width_m"), heightM: number("height_m"),
            cover: scene.cover, direction: scene.direction, paper: scene.paper, layout: scene.layout, fidelity: scene.fidelity,
            grip: number("grip"), stepUs: number("step_us"), widthPx, heightPx,
        });
        const frameUs = number("frame_us");
        const last = Math.floor(number("until_us") / frameUs) + later;
        for (let frame = 0, next = 0; frame <= last; frame += 1) {
            for (; next < samples.length && samples[next].t_us <= frame * frameUs; next += 1) {
                const { t_us, id, phase, x, y } = samples[next];
                book.pointer({ timeUs: t_us, id, phase, x: x / 256, y: y / 256 });
            }
            book.step(frame * frameUs);
        }
        const state = book.stateHash().toString(16).padStart(16, "0");
        const [width, height] = pair("picture_px");
        book.resize(width, height);
        const canvas = Object.assign(document.createElement("canvas"), { width, height });
        const gl = canvas.getContext("webgl2", { antialias: true, alpha: false, preserveDrawingBuffer: true });
        const image = async (name) => createImageBitmap(await (await fetch(files[name])).blob(), { colorSpaceConversion: "none" });
        const renderer = new BookRenderer(gl, book);
        renderer.update(book.frame());
        const pages = scene.page_pngs.split(" ").map(Number);
        const missing = renderer.missingPages().sort((a, b) => a - b);
        for (const n of missing) {
            const shown = swap && n === pages[0] ? pages.at(-1) : swap && n === pages.at(-1) ? pages[0] : n;
            renderer.setPage(n, await image(`page-${shown}`));
        }
        renderer.draw(book.frame());
        const found = new Uint8Array(4 * width * height);
        gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, found);
        const flat = new OffscreenCanvas(width, height).getContext("2d", { colorSpace: "srgb" });
        flat.drawImage(await image("reference"), 0, 0);
        const wanted = flat.getImageData(0, 0, width, height).data;
        const counts = new Array(256).fill(0);
        for (let y = 0; y < height; y += 1) for (let x = 0; x < width; x += 1) for (let c = 0; c < 3; c += 1) {
            counts[Math.abs(wanted[4 * (y * width + x) + c] - found[4 * ((height - 1 - y) * width + x) + c])] += 1;
        }
        const all = 3 * width * height;
        let seen = 0;
        const most = counts.findIndex((n) => (seen += n) * 100 >= all * 99);
        const mean = counts.reduce((sum, n, d) => sum + n * d, 0) / all;
        const answer = { state, missing, mean, most, error: gl.getError(), png: canvas.toDataURL(), samples: gl.getParameter(gl.SAMPLES), driver: gl.getParameter(gl.VERSION) };
        renderer.release();
        book.shut();
        return answer;
    }, [given, later, swap]);
}

const fits = ({ mean, most }) => mean <= MEAN && most <= MOST;
const said = ({ mean, most }) => `mean ${mean.toFixed(2)}, 99 of 100 bytes within ${most}`;

export default async function run(bench) {
    const page = await bench.blank();
    const facts = scene();
    const names = ["reference", ...facts.page_pngs.split(" ").map((n) => `page-${n}`)];
    const files = Object.fromEntries(names.map((name) => [name, `data:image/png;base64,${bench.read(`${FOLDER}/${name}.png`).toString("base64")}`]));
    const samples = String(bench.read(`gestures/${facts.gesture}.jsonl`)).trim().split("\n").map((line) => JSON.parse(line));
    const given = { scene: facts, samples, files };
    await bench.test("the picture is the reference", async () => {
        const found = await drawn(page, given);
        bench.keep("reference-web.png", Buffer.from(found.png.split(",")[1], "base64"));
        holds(found.state === facts.state, `state ${found.state} is not ${facts.state}`);
        holds(found.missing.join(" ") === facts.page_pngs, `pages ${found.missing}`);
        holds(found.error === 0, `the driver complains: ${found.error}`);
        holds(fits(found), `too far: ${said(found)}`);
        return `${said(found)}; ${found.samples} samples, ${found.driver}`;
    });
    await bench.test("pages that were swapped are noticed", async () => {
        const found = await drawn(page, given, 0, true);
        holds(!fits(found), `and still ${said(found)}`);
        return said(found);
    });
    await bench.test("a moment later is noticed", async () => {
        const found = await drawn(page, given, 3);
        holds(!fits(found), `and still ${said(found)}`);
        return said(found);
    });
    await page.context().close();
}
