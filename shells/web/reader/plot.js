// A small plot: error against time, both as powers of ten.

const [WIDTH, HEIGHT] = [440, 200];
const [LEFT, RIGHT, TOP, BOTTOM] = [44, 16, 12, 30];

/**
 * @param {import("./lab.js").Figure[]} figures
 * @param {import("./lab.js").Figure} last
 */
export function plot(figures, last) {
    const seen = figures.filter((f) => f.error > 0 && f.pictureMicros > 0);
    if (seen.length === 0) return "";
    const x = axis(seen.map((f) => f.pictureMicros), LEFT, WIDTH - RIGHT);
    const y = axis(seen.map((f) => f.error), HEIGHT - BOTTOM, TOP);
    const lines = [
        ...x.decades.map((d) => line(x.at(10 ** d), TOP, x.at(10 ** d), HEIGHT - BOTTOM) + label(x.at(10 ** d), HEIGHT - 14, `${name(d)} µs`, "middle")),
        ...y.decades.map((d) => line(LEFT, y.at(10 ** d), WIDTH - RIGHT, y.at(10 ** d)) + label(LEFT - 6, y.at(10 ** d) + 4, `10${power(d)}`, "end")),
    ];
    const dots = seen.map((f) => {
        const [cx, cy] = [x.at(f.pictureMicros), y.at(f.error)];
        const aside = cx > WIDTH * 0.7 ? [-8, "end"] : [8, "start"];
        return `<circle class="dot${f === last ? "" : " old"}" cx="${cx.toFixed(1)}" cy="${cy.toFixed(1)}" r="${f === last ? 5 : 4}"/>` + label(cx + Number(aside[0]), cy + 4, `${f.fidelity} ${f.grid}`, String(aside[1]));
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
