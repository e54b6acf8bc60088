// What a book is opened with.

/**
 * @typedef {object} BookOptions
 * @property {number} pages printed pages, two a leaf; 1 to 20,000
 * @property {number} openAt page the book is open at; 0 is before the first leaf
 * @property {number} widthM width of a page, metres
 * @property {number} heightM height of a page, metres; 0.2 to 5 times the width
 * @property {"hard" | "soft"} cover boards, or leaves that are the cover
 * @property {"ltr" | "rtl"} direction which way one reads
 * @property {"office" | "book" | "newsprint" | "coated" | "glossy" | "matte" | "cardboard"} paper what the leaves are made of
 * @property {number} widthPx width of the view, pixels
 * @property {number} heightPx height of the view, pixels
 * @property {"spread" | "single"} layout both pages, or the one that is turned next
 * @property {"table" | "above"} gaze a reader at a table, or straight down
 * @property {"draft" | "standard" | "fine" | "reference"} fidelity what accuracy is bought
 * @property {number} grip how hard the finger holds the paper, 0 to 100
 * @property {number} stepUs internal step, microseconds; 100 to 100,000
 */

/** @type {BookOptions} */
const DEFAULTS = {
    pages: 0,
    openAt: 0,
    widthM: 0.13,
    heightM: 0.2,
    cover: "hard",
    direction: "ltr",
    paper: "book",
    widthPx: 960,
    heightPx: 720,
    layout: "spread",
    gaze: "table",
    fidelity: "fine",
    grip: 16,
    stepUs: 16667,
};

/**
 * A paperback for a touch screen, with what is wanted otherwise.
 * @param {Partial<BookOptions>} wanted
 * @returns {BookOptions}
 */
export function bookOptions(wanted) {
    const options = { ...DEFAULTS };
    for (const [name, value] of Object.entries(wanted)) {
        if (!Object.hasOwn(DEFAULTS, name)) throw new DogleafError("refused", `there is no option \`${name}\``);
        if (value === undefined) continue;
        const wrong = typeof value !== typeof DEFAULTS[/** @type {keyof BookOptions} */ (name)];
        if (wrong || Number.isNaN(value)) throw new DogleafError("refused", `option \`${name}\`: \`${value}\` will not do`);
        Object.assign(options, { [name]: value });
    }
    return options;
}

/**
 * Why a call was refused. The core throws plain `Error`s of the same `name` and with the same `kind`.
 */
export class DogleafError extends Error {
    /**
     * @param {"closed" | "busy" | "noSuchPage" | "paused" | "refused" | "pointer" | "recording"} kind
     * @param {string} line
     */
    constructor(kind, line) {
        super(line);
        this.name = "DogleafError";
        this.kind = kind;
    }
}
