// Somebody who uses the package in TypeScript: it has to compile as it stands.
import { Book, BookRenderer, BookView, DogleafError, bookOptions, hasVectors, load } from "dogleaf";

const canvas = document.querySelector("canvas")!;
const dogleaf = await load({ vectors: hasVectors() });
const book: Book = dogleaf.open({ ...bookOptions({ pages: 24, fidelity: "fine" }), direction: "rtl" });

try {
    book.pointer({ timeUs: 0, id: 0, phase: "down", x: 700, y: 600 });
} catch (why) {
    if (why instanceof DogleafError && why.kind === "pointer") console.warn(why.message);
}
const { draw, needsFrame, work } = book.step(16_667);
const gl = canvas.getContext("webgl2")!;
const renderer = new BookRenderer(gl, book);
if (draw || needsFrame || work.newtonSteps > 0) renderer.draw(book.frame());

const corner: Float32Array = book.vertices.subarray(0, 3);
const triangle: Uint16Array = book.indices.subarray(0, 3);
for (const notice of book.notices()) {
    if (notice.kind === "committed") console.log(notice.page + 1, corner, triangle);
}
book.setMotion("reduced", 400_000);
const bytes: Uint8Array = book.snapshot();
dogleaf.openSnapshot(bytes).shut();
const hash: bigint = dogleaf.replay(bytes).hash;

const view = new BookView(canvas, book, {
    pages: 24,
    picture: async (page, widthPx, heightPx) => new ImageData(widthPx, heightPx + page),
}, { onNotice: (notice) => console.log(notice.kind, hash) });
view.turn(true);
view.close();
