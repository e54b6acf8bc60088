// A small plot: error against time, both as powers of ten.

const [WIDTH, HEIGHT] = [440, 200];
const [LEFT, RIGHT, TOP, BOTTOM] = [44, 34, 12, 30];
/** Height of a line of text, and the width of a label. */
const [LINE, TEXT] = [12, 90];

/**
 * @param {import("./lab.js").Figure[]} figures
 * @param {import("./lab.js").Figure} last
 */
export function plot(figures, last) {
    const seen = figures.filter((f) => f.error > 0 && f.pictureMicros > 0);
    if (seen.length === 0) return "";
    const x = axis(seen.map((f) => f.pictureMicros), LEFT, WIDTH - RIGHT);
    const errors = seen.flatMap((f) => [f.error, f.inTime]).filter((error) => error > 0);
    const y = axis(errors, HEIGHT - BOTTOM, TOP);
    const lines = [
        ...x.decades.map((d) => line(x.at(10 ** d), TOP, x.at(10 ** d), HEIGHT - BOTTOM) + label(x.at(10 ** d), HEIGHT - 14, `${name(d)} µs`, "middle")),
        ...y.decades.map((d) => line(LEFT, y.at(10 ** d), WIDTH - RIGHT, y.at(10 ** d)) + label(LEFT - 6, y.at(10 ** d) + 4, `10${power(d)}`, "end")),
    ];
    /** @type {[number, number, number][]} */
    const written = [];
    const dots = seen.map((f) => {
        const [cx, cy] = [x.at(f.pictureMicros), y.at(f.error)];
        const end = cx > WIDTH * 0.7;
        let below = cy + 4;
        const from = end ? cx - TEXT : cx;
        while (written.some(([a, b, at]) => from < b && from + TEXT > a && Math.abs(at - below) < LINE)) below += LINE;
        written.push([from, from + TEXT, below]);
        const whole = dot(cx, cy, f === last ? "" : "old", f === last ? 5 : 4);
        const inTime = f.inTime > 0 ? dot(cx, y.at(f.inTime), "time", 4) : "";
        return inTime + whole + label(cx + (end ? -8 : 8), below, `${f.fidelity} ${f.grid}`, end ? "end" : "start");
    });
    return `<svg viewBox="0 0 ${WIDTH} ${HEIGHT}">${lines.join("")}${dots.join("")}${label(WIDTH - RIGHT, HEIGHT - 2, "a picture", "end")}</svg>`;
}

/**
 * Whole decades round all values.
 * @param {number[]} values
 * @param {number} from
 * @param {number} to
 */
function axis(values, from, to) {
    const low = Math.floor(Math.log10(Math.min(...values)) - 0.05);
    const high = Math.max(Math.ceil(Math.log10(Math.max(...values)) + 0.05), low + 1);
    const at = (/** @type {number} */ value) => from + ((Math.log10(value) - low) / (high - low)) * (to - from);
    return { at, decades: Array.from({ length: high - low + 1 }, (_, n) => low + n) };
}

/**
 * @param {number} x
 * @param {number} y
 * @param {string} kind
 * @param {number} r
 */
const dot = (x, y, kind, r) => `<circle class="dot ${kind}" cx="${x.toFixed(1)}" cy="${y.toFixed(1)}" r="${r}"/>`;

/** @param {number} decade */
const name = (decade) => (10 ** decade).toLocaleString("en");
/** @param {number} decade */
const power = (decade) => String(decade).replace(/[-\d]/g, (c) => "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"["-0123456789".indexOf(c)]);

/**
 * @param {number} x1
 * @param {number} y1
 * @param {number} x2
 * @param {number} y2
 */
const line = (x1, y1, x2, y2) => `<line class="axis" x1="${x1}" y1="${y1}" x2="${x2}" y2="${y2}"/>`;

/**
 * @param {number} x
 * @param {number} y
 * @param {string} text
 * @param {string} anchor
 */
const label = (x, y, text, anchor) => `<text x="${x.toFixed(1)}" y="${y.toFixed(1)}" text-anchor="${anchor}">${text}</text>`;
