// The reader's page: wires buttons, keys, files and notices to the book.
import { load } from "./dogleaf/index.js";
import { wish } from "./keys.js";
import { Lab } from "./lab.js";
import { Reader } from "./reader.js";
import { open, pdf } from "./sources.js";

const FIRST = { file: "books/old-verses.pdf", title: "Old Verses", page: 8 };
const NEWS_MS = 6000;

/**
 * @template {HTMLElement} [T=HTMLElement]
 * @param {string} id
 */
const at = (id) => /** @type {T} */ (document.getElementById(id));
const kept = /** @type {import("./reader.js").Wanted} */ ({
    direction: "ltr", layout: "auto", gaze: "table", motion: "auto", fidelity: "fine", ...stored("wanted"),
});

/** @param {string} key */
function stored(key) {
    try {
        return JSON.parse(localStorage.getItem(`dogleaf.${key}`) ?? "null");
    } catch {
        return null;
    }
}

/**
 * A page that may keep nothing is a page all the same.
 * @param {string} key
 * @param {unknown} value
 */
function store(key, value) {
    try {
        localStorage.setItem(`dogleaf.${key}`, JSON.stringify(value));
    } catch {}
}

let newsTimer = 0;
/** @param {string} line */
function news(line) {
    clearTimeout(newsTimer);
    at("news").textContent = line;
    at("news").classList.add("shown");
    newsTimer = setTimeout(() => at("news").classList.remove("shown"), NEWS_MS);
}

/** @param {import("./dogleaf/words.js").Notice} notice */
function heard(notice) {
    if (notice.kind === "lifted") document.body.classList.add("turning");
    if (notice.kind === "committed") place();
    if (notice.kind === "announce") at("announce").textContent = `Page ${reader.where()}`;
    if (notice.kind === "cancelled" || notice.kind === "committed") document.body.classList.remove("turning");
    if (notice.kind === "asleep") lab.settled();
}

function place() {
    const { book, source } = reader;
    if (!book || !source) return;
    at("where").textContent = reader.where();
    at("title").textContent = source.title;
    document.title = `${source.title} · dogleaf`;
    /** @type {HTMLButtonElement} */ (at("back")).disabled = book.page <= 0;
    /** @type {HTMLButtonElement} */ (at("on")).disabled = book.page >= book.pages;
    store(`place.${source.title}`, book.page);
}

/**
 * Opens something and says what is wrong with it; what was open stays then.
 * @param {() => Promise<import("./sources.js").Source>} how
 * @param {number} page
 */
async function show(how, page) {
    document.body.classList.add("opening");
    try {
        const source = await how();
        reader.show(source, stored(`place.${source.title}`) ?? page);
    } catch (why) {
        news(why instanceof Error ? why.message : String(why));
    }
    document.body.classList.remove("opening");
}

/** @param {FileList | File[]} files */
const dropped = (files) => show(() => open([...files]), 0);

const dogleaf = await load().catch((why) => {
    news(`This browser cannot run the book: ${why.message}.`);
    throw why;
});
const reader = new Reader(dogleaf, at("book"), kept, { notice: heard, place, news });
const lab = new Lab(reader, at);
// `?sharpness=0.5` for machines whose graphics card is the processor.
const sharpness = Number(new URLSearchParams(location.search).get("sharpness"));
if (sharpness > 0) reader.sharpness = sharpness;

// Files.
const file = /** @type {HTMLInputElement} */ (at("file"));
at("open").addEventListener("click", () => file.click());
file.addEventListener("change", () => {
    if (file.files?.length) void dropped(file.files);
    file.value = "";
});
addEventListener("dragover", (event) => {
    event.preventDefault();
    at("veil").hidden = false;
});
addEventListener("dragleave", (event) => {
    if (!event.relatedTarget) at("veil").hidden = true;
});
addEventListener("drop", (event) => {
    event.preventDefault();
    at("veil").hidden = true;
    if (event.dataTransfer?.files.length) void dropped(event.dataTransfer.files);
});

// Buttons and panes.
const turned = (/** @type {boolean} */ forward) => lab.before(() => reader.turn(forward));
const ltr = () => kept.direction === "ltr";
at("back").addEventListener("click", () => turned(!ltr()));
at("on").addEventListener("click", () => turned(ltr()));
/**
 * @param {string} pane
 * @param {string} button
 */
function toggle(pane, button) {
    for (const [p, b] of [["settings", "menu"], ["cost", "lab"]]) {
        const shown = p === pane && at(p).hidden;
        at(p).hidden = !shown;
        at(b).setAttribute("aria-expanded", String(shown));
    }
    document.body.classList.toggle("measuring", !at("cost").hidden);
    void lab.shown(!at("cost").hidden);
    if (at(pane).hidden) at(button).focus();
}
at("menu").addEventListener("click", () => toggle("settings", "menu"));
at("lab").addEventListener("click", () => toggle("cost", "lab"));

// What the reader asks for.
const settings = /** @type {HTMLFormElement} */ (at("settings"));
for (const [name, value] of Object.entries(kept)) {
    const input = settings.querySelector(`[name="${name}"][value="${value}"]`);
    if (input instanceof HTMLInputElement) input.checked = true;
}
settings.addEventListener("change", ({ target }) => {
    if (!(target instanceof HTMLInputElement)) return;
    Object.assign(kept, { [target.name]: target.value });
    store("wanted", kept);
    if (target.name === "motion") reader.follow();
    else reader.again();
});
lab.onFidelity = (fidelity) => {
    kept.fidelity = fidelity;
    store("wanted", kept);
    reader.again();
};

// Keys and the wheel.
addEventListener("keydown", (event) => {
    const { target } = event;
    if (target instanceof HTMLInputElement || target instanceof HTMLSelectElement) return;
    if (target instanceof HTMLButtonElement && (event.key === " " || event.key === "Enter")) return;
    const wanted = wish(event, kept.direction);
    if (wanted === undefined) return;
    event.preventDefault();
    if (wanted === "back") {
        if (reader.view?.fingers.pressed) reader.view.putBack();
        else if (!at("settings").hidden) toggle("settings", "menu");
        else if (!at("cost").hidden) toggle("cost", "lab");
    } else if (wanted === "open") file.click();
    else if (wanted === "settings") toggle("settings", "menu");
    else if (wanted === "cost") toggle("cost", "lab");
    else if (wanted === "full") void (document.fullscreenElement ? document.exitFullscreen() : document.body.requestFullscreen());
    else if ("bookmark" in wanted) reader.view?.bookmark(wanted.bookmark);
    else lab.before(() => reader.turn(wanted.turn, wanted.all));
});
at("book").addEventListener("wheel", (event) => {
    event.preventDefault();
    // Some systems turn the wheel when Shift is held.
    const way = event.deltaX + event.deltaY;
    if (event.shiftKey && way !== 0) reader.view?.bookmark(way > 0);
}, { passive: false });

if ("serviceWorker" in navigator) navigator.serviceWorker.register("sw.js").catch(() => {});
await show(async () => {
    const answer = await fetch(FIRST.file);
    if (!answer.ok) throw new Error("The first book is missing.");
    return pdf(FIRST.title, await answer.blob());
}, FIRST.page);
document.body.classList.add("ready");
// For whoever looks under the hood, and for the tests.
Object.assign(globalThis, { reader, lab });
