// The loop that a host runs, whole: fingers and time in, one mesh out, nothing at rest.
import { BookRenderer, load } from "dogleaf";

/**
 * @param {HTMLCanvasElement} canvas
 * @param {number} pages
 * @param {(page: number, width: number, height: number) => Promise<TexImageSource>} picture
 * @param {(page: number) => void} turned
 */
export async function read(canvas, pages, picture, turned) {
    const dogleaf = await load();
    const book = dogleaf.open({ pages, widthPx: canvas.width, heightPx: canvas.height });
    const gl = canvas.getContext("webgl2", { antialias: true, alpha: false });
    if (!gl) throw new Error("this browser has no WebGL 2");
    const renderer = new BookRenderer(gl, book);
    let asked = 0;
    const wake = () => (asked ||= requestAnimationFrame(step));

    /** @param {number} ms */
    function step(ms) {
        asked = 0;
        const frame = book.step(Math.round(ms * 1000));
        if (frame.draw) renderer.draw(frame);
        for (const notice of book.notices()) {
            if (notice.kind === "committed") turned(notice.page);
        }
        for (const page of renderer.missingPages()) void fetchPage(page);
        if (frame.needsFrame) wake();
    }

    const asking = new Set();
    /** @param {number} page */
    async function fetchPage(page) {
        if (page >= pages || asking.has(page)) return;
        asking.add(page);
        renderer.setPage(page, await picture(page, 700, 1000));
        renderer.keepPages((other) => Math.abs(other - book.page) < 6);
        asking.delete(page);
        book.redraw();
        wake();
    }

    const phases = /** @type {const} */ ({ pointerdown: "down", pointermove: "move", pointerup: "up", pointercancel: "cancel" });
    for (const [kind, phase] of Object.entries(phases)) {
        canvas.addEventListener(kind, (event) => {
            const at = /** @type {PointerEvent} */ (event);
            if (phase === "move" && at.buttons === 0) return;
            if (phase === "down") canvas.setPointerCapture(at.pointerId);
            const [x, y] = [(at.offsetX * canvas.width) / canvas.clientWidth, (at.offsetY * canvas.height) / canvas.clientHeight];
            book.pointer({ timeUs: Math.round(at.timeStamp * 1000), id: at.pointerId % 61, phase, x, y });
            wake();
        });
    }
    wake();
    return book;
}
