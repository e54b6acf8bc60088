// From what a reader drops to a book's pages: PDF, CBZ, pictures.
import { files } from "./zip.js";

/** Width of a page nobody knows the size of, metres; sizes that a PDF is believed; metres in one of its points. */
const WIDTH_M = 0.13;
const SANE_M = [0.06, 0.3];
const POINT_M = 0.0254 / 72;
/** Shapes a page can have: height over width. */
const SHAPES = [0.2, 5];
const MOST_PAGES = 20_000;
const PICTURE = /\.(png|jpe?g|webp|gif|avif|bmp)$/i;
const PAPER = "#fff";

/**
 * @typedef {object} Source
 * @property {string} title
 * @property {number} pages
 * @property {number} widthM
 * @property {number} heightM
 * @property {(page: number, widthPx: number, heightPx: number) => Promise<OffscreenCanvas>} picture
 * @property {() => void} close
 */

/**
 * Opens what was dropped or chosen. What it throws says in one line what is wrong.
 * @param {File[]} dropped
 * @returns {Promise<Source>}
 */
export async function open(dropped) {
    const [first] = dropped;
    if (!first) throw new Error("Nothing was dropped that can be read.");
    const title = first.name.replace(/\.[^.]*$/, "");
    try {
        const head = new Uint8Array(await first.slice(0, 1024).arrayBuffer());
        const text = String.fromCharCode(...head);
        if (text.includes("%PDF-")) return await pdf(title, first);
        if (text.startsWith("PK")) return await cbz(title, first);
        const pictures = dropped.filter((file) => file.type.startsWith("image/") || PICTURE.test(file.name));
        if (pictures.length > 0) return await gallery(title, ordered(pictures.map((file) => ({ name: file.name, blob: async () => file }))));
    } catch (why) {
        const said = why instanceof Error ? why.message : String(why);
        throw new Error(`“${first.name}” ${said}.`, { cause: why });
    }
    throw new Error(`“${first.name}” is no PDF, CBZ or picture.`);
}

/**
 * @template {{ name: string }} T
 * @param {T[]} list
 */
function ordered(list) {
    const order = new Intl.Collator("en", { numeric: true, sensitivity: "base" });
    return list.sort((a, b) => order.compare(a.name, b.name));
}

/**
 * @param {string} title
 * @param {File} file
 */
async function cbz(title, file) {
    const inside = (await files(file)).filter(({ name }) => PICTURE.test(name) && !/(^|\/)(\.|__MACOSX)/.test(name));
    return gallery(title, ordered(inside));
}

/**
 * A page a picture.
 * @param {string} title
 * @param {{ name: string, blob: () => Promise<Blob> }[]} list
 * @returns {Promise<Source>}
 */
async function gallery(title, list) {
    if (list.length === 0) throw new Error("has no pictures in it");
    if (list.length > MOST_PAGES) throw new Error("has more pages than a book");
    const first = await decoded(list[0]);
    const shape = clamp(first.height / first.width, SHAPES);
    first.close();
    const picture = async (/** @type {number} */ page, /** @type {number} */ width, /** @type {number} */ height) => {
        const image = await decoded(list[page]);
        const { canvas, pen } = sheet(width, height);
        const scale = Math.min(width / image.width, height / image.height);
        const [w, h] = [image.width * scale, image.height * scale];
        pen.imageSmoothingQuality = "high";
        pen.drawImage(image, (width - w) / 2, (height - h) / 2, w, h);
        image.close();
        return canvas;
    };
    return { title, pages: list.length, widthM: WIDTH_M, heightM: WIDTH_M * shape, picture, close() {} };
}

/** @param {{ name: string, blob: () => Promise<Blob> }} file */
async function decoded(file) {
    const blob = await file.blob();
    return createImageBitmap(blob).catch((why) => {
        throw new Error(`holds “${file.name}”, which is no picture`, { cause: why });
    });
}

/**
 * @param {string} title
 * @param {Blob} file
 * @returns {Promise<Source>}
 */
export async function pdf(title, file) {
    const pdfjs = await import("./pdfjs/pdf.min.mjs");
    const here = new URL("./pdfjs/", import.meta.url).href;
    pdfjs.GlobalWorkerOptions.workerSrc = `${here}pdf.worker.min.mjs`;
    const task = pdfjs.getDocument({
        data: new Uint8Array(await file.arrayBuffer()),
        cMapUrl: `${here}cmaps/`,
        standardFontDataUrl: `${here}standard_fonts/`,
        wasmUrl: `${here}wasm/`,
        isEvalSupported: false,
        enableXfa: false,
        verbosity: 0,
    });
    const book = await task.promise.catch((/** @type {Error} */ why) => {
        void task.destroy();
        const line = why.name === "PasswordException" ? "is locked with a password" : "is no sound PDF";
        throw new Error(line, { cause: why });
    });
    if (book.numPages > MOST_PAGES) throw new Error("has more pages than a book");
    const size = (await book.getPage(1)).getViewport({ scale: 1 });
    const own = [size.width, size.height].map((points) => points * POINT_M);
    const sane = own.every((side) => side >= SANE_M[0] && side <= SANE_M[1]);
    const [widthM, heightM] = sane ? own : [WIDTH_M, WIDTH_M * clamp(size.height / size.width, SHAPES)];
    const meta = await book.getMetadata().catch(() => undefined);
    const picture = async (/** @type {number} */ page, /** @type {number} */ width, /** @type {number} */ height) => {
        const sheetOf = await book.getPage(page + 1);
        const own = sheetOf.getViewport({ scale: 1 });
        const scale = Math.min(width / own.width, height / own.height);
        const { canvas, pen } = sheet(width, height);
        const [offsetX, offsetY] = [(width - own.width * scale) / 2, (height - own.height * scale) / 2];
        const viewport = sheetOf.getViewport({ scale, offsetX, offsetY });
        await sheetOf.render({ canvas: null, canvasContext: pen, viewport }).promise;
        sheetOf.cleanup();
        return canvas;
    };
    return { title: meta?.info?.Title || title, pages: book.numPages, widthM, heightM, picture, close: () => void task.destroy() };
}

/**
 * An empty page.
 * @param {number} width
 * @param {number} height
 */
function sheet(width, height) {
    const canvas = new OffscreenCanvas(width, height);
    // In plain memory: it is drawn once, and handed to another context.
    const pen = canvas.getContext("2d", { alpha: false, willReadFrequently: true });
    if (!pen) throw new Error("needs more memory than there is");
    pen.fillStyle = PAPER;
    pen.fillRect(0, 0, width, height);
    return { canvas, pen };
}

/**
 * @param {number} value
 * @param {number[]} range
 */
function clamp(value, [low, high]) {
    return Math.min(Math.max(value, low), high);
}
