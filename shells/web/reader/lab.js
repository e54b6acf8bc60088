// "What accuracy costs, live": the gesture just made, simulated again with other settings, in a worker.
import { plot } from "./plot.js";

/** Shorter recordings show nothing. */
const FEWEST_BYTES = 600;
/** What is measured until the reader has turned a page. */
const FIRST = "recordings/slow_turn_f32.dlr";
const FIDELITIES = ["draft", "standard", "fine", "reference"];

/** @typedef {{ grid: string, fidelity: string, stepUs: number, stepMicros: number, pictureMicros: number, error: number, inTime: number }} Figure */

/** @param {number} error */
const said = (error) => (error > 0 ? error.toFixed(4) : "–");

/** The pane. */
export class Lab {
    /** @type {Uint8Array | undefined} */
    #bytes;
    #name = "";
    /** @type {Worker | undefined} */
    #worker;
    /** @type {Figure[]} */
    figures = [];
    #open = false;
    #recording = false;
    /** @type {(fidelity: import("./reader.js").Wanted["fidelity"]) => void} */
    onFidelity = () => {};

    /**
     * @param {import("./reader.js").Reader} reader
     * @param {(id: string) => HTMLElement} at
     */
    constructor(reader, at) {
        this.reader = reader;
        this.at = at;
        const select = (/** @type {string} */ id) => /** @type {HTMLSelectElement} */ (at(id));
        this.dials = () => ({ grid: select("grid").value, fidelity: select("fidelity").value, stepUs: Number(select("step").value) });
        select("fidelity").value = reader.wanted.fidelity;
        select("fidelity").addEventListener("change", ({ target }) => {
            this.onFidelity(/** @type {import("./reader.js").Wanted["fidelity"]} */ (/** @type {HTMLSelectElement} */ (target).value));
        });
        for (const id of ["fidelity", "grid", "step"]) select(id).addEventListener("change", () => this.measure([this.dials()]));
        at("measure").addEventListener("click", () => this.measure([this.dials()]));
        at("sweep").addEventListener("click", () => this.measure(this.#sweep()));
        // Before the book hears of it.
        reader.canvas.parentElement?.addEventListener("pointerdown", () => this.#begin(), { capture: true });
    }

    /** @param {boolean} open */
    async shown(open) {
        this.#open = open;
        if (!open || this.#bytes) return;
        const answer = await fetch(FIRST);
        if (answer.ok && !this.#bytes) this.#take(new Uint8Array(await answer.arrayBuffer()), "A recorded slow turn");
        this.measure(this.#sweep());
    }

    #sweep() {
        const dials = this.dials();
        return FIDELITIES.map((fidelity) => ({ ...dials, fidelity }));
    }

    /**
     * @param {Uint8Array} bytes
     * @param {string} name
     */
    #take(bytes, name) {
        this.#bytes = bytes;
        this.#name = name;
        this.figures = [];
        const link = /** @type {HTMLAnchorElement} */ (this.at("save"));
        URL.revokeObjectURL(link.href);
        link.href = URL.createObjectURL(new Blob([/** @type {Uint8Array<ArrayBuffer>} */ (bytes)]));
        link.hidden = false;
        for (const id of ["measure", "sweep"]) /** @type {HTMLButtonElement} */ (this.at(id)).disabled = false;
    }

    /**
     * Something that is not a finger is about to turn a page.
     * @template T
     * @param {() => T} turn
     */
    before(turn) {
        this.#begin();
        return turn();
    }

    #begin() {
        const { book } = this.reader;
        if (!this.#open || !book?.isSleeping()) return;
        book.startRecording();
        this.#recording = true;
    }

    /** Everything is at rest: the recording is whole. */
    settled() {
        const { book, view } = this.reader;
        if (!this.#recording || !book || view?.fingers.pressed) return;
        this.#recording = false;
        const bytes = book.stopRecording();
        if (bytes.length < FEWEST_BYTES) return;
        this.#take(bytes, "Your gesture");
        this.measure([this.dials()]);
    }

    /** @param {{ grid: string, fidelity: string, stepUs: number }[]} list */
    measure(list) {
        if (!this.#bytes) return;
        this.#worker ??= this.#employed();
        this.at("cost-bar").hidden = false;
        this.at("cost-state").textContent = `${this.#name} is simulated again…`;
        this.#worker.postMessage({ bytes: this.#bytes, list });
    }

    #employed() {
        const worker = new Worker(new URL("./lab-worker.js", import.meta.url), { type: "module" });
        worker.addEventListener("message", ({ data }) => this.#heard(data));
        worker.addEventListener("error", (event) => {
            this.at("cost-state").textContent = `It cannot be measured here: ${event.message ?? "no worker"}.`;
        });
        return worker;
    }

    /** @param {{ share?: number, figure?: Figure, done?: { steps: number }, wrong?: string }} said */
    #heard({ share, figure, done, wrong }) {
        if (share !== undefined) /** @type {HTMLProgressElement} */ (this.at("cost-bar")).value = share;
        if (wrong) this.at("cost-state").textContent = wrong;
        if (done) this.at("cost-state").textContent = `${this.#name}: ${done.steps} pictures, simulated again.`;
        if (done || wrong) this.at("cost-bar").hidden = true;
        if (!figure) return;
        const same = (/** @type {Figure} */ f) => ["grid", "fidelity", "stepUs"].every((k) => f[/** @type {"grid"} */ (k)] === figure[/** @type {"grid"} */ (k)]);
        this.figures = [...this.figures.filter((f) => !same(f)), figure];
        this.#draw(figure);
    }

    /** @param {Figure} last */
    #draw(last) {
        this.at("plot").innerHTML = plot(this.figures, last);
        this.at("figures").hidden = false;
        const rows = [...this.figures].sort((a, b) => a.pictureMicros - b.pictureMicros).map((f) => {
            const row = document.createElement("tr");
            const cells = [`${f.fidelity}, ${f.grid}, 1/${Math.round(1e6 / f.stepUs)} s`, f.stepMicros.toFixed(1), f.pictureMicros.toFixed(0), said(f.error), said(f.inTime)];
            row.append(...cells.map((text) => Object.assign(document.createElement("td"), { textContent: text })));
            return row;
        });
        this.at("figures").querySelector("tbody")?.replaceChildren(...rows);
    }
}
