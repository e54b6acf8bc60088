// What the core's numbers mean.

/** The core's surfaces, in its order. Left and right as the reader sees them. */
const SURFACES = /** @type {const} */ ([
    "leafUp", "leafDown", "leafRim", "leftTop", "leftSides", "leftBottom", "rightTop", "rightSides", "rightBottom",
    "leftBoard", "rightBoard", "spine",
]);
const FACES = /** @type {const} */ (["page", "edge", "cover"]);
const TICKS = /** @type {const} */ (["lift", "over", "land", "flip"]);
/** Planes of the camera: the near one as a share of the eye's distance, the far one beyond a table of six metres. */
const NEAR = 0.1;
const FAR_M = 40;

/**
 * @typedef {object} Piece
 * @property {typeof SURFACES[number]} surface what it is of the book
 * @property {boolean} flying it belongs to the leaf that slips into the hand or out of it
 * @property {typeof FACES[number]} face what it shows
 * @property {number | undefined} page the printed page it shows, from 0; beyond the last one blank paper
 * @property {number | undefined} reverse the page on the other side of the same leaf
 * @property {number} leaves leaves whose cut edges it shows
 * @property {number} firstIndex
 * @property {number} indexCount
 * @property {boolean} visible whether it is to be drawn
 *
 * @typedef {{ kind: "lifted", leaves: number, fromRight: boolean } | { kind: "held", leaves: number }
 *   | { kind: "committed", page: number } | { kind: "cancelled" } | { kind: "announce", page: number, pages: number }
 *   | { kind: "haptic", tick: typeof TICKS[number] } | { kind: "asleep" }} Notice
 *   one fact for the app; exactly one `committed` or `cancelled` ends every `lifted`
 *
 * @typedef {object} Stage
 * @property {Float32Array} viewProjection from metres of the book frame to clip space, column by column
 * @property {Float32Array} eye metres
 * @property {number} widthPx
 * @property {number} heightPx
 * @property {number} pixelAtOneMetre side of a pixel one metre away, metres
 * @property {number} tableY height of the table, metres: below nought
 * @property {number} leafM thickness of a leaf, metres
 * @property {number} pageWidthM width of a page, metres
 * @property {number} pageHeightM
 * @property {number} radiusM radius of a sphere about the binding that holds the book however it is opened, metres
 */

/**
 * @param {Int32Array} numbers
 * @returns {Piece}
 */
export function piece(numbers) {
    const [surface, flying, face, page, reverse, leaves, firstIndex, indexCount, visible] = numbers;
    return {
        surface: SURFACES[surface],
        flying: flying !== 0,
        face: FACES[face],
        page: page < 0 ? undefined : page,
        reverse: reverse < 0 ? undefined : reverse,
        leaves,
        firstIndex,
        indexCount,
        visible: visible !== 0,
    };
}

/**
 * @param {Uint32Array} numbers
 * @returns {Notice}
 */
export function notice([kind, first, second]) {
    switch (kind) {
        case 0: return { kind: "lifted", leaves: first, fromRight: second !== 0 };
        case 1: return { kind: "held", leaves: first };
        case 2: return { kind: "committed", page: first };
        case 3: return { kind: "cancelled" };
        case 4: return { kind: "announce", page: first, pages: second };
        case 5: return { kind: "haptic", tick: TICKS[first] };
        default: return { kind: "asleep" };
    }
}

/**
 * The core's camera as GL has it.
 * @param {Float64Array} n
 * @returns {Stage}
 */
export function stage(n) {
    const [eye, right, up, forward] = [0, 3, 6, 9].map((at) => n.subarray(at, at + 3));
    const [focal, widthPx, heightPx, tableY, leafM, radiusM, pageWidthM, pageHeightM] = n.subarray(12);
    const distance = Math.hypot(...eye);
    const [near, far] = [NEAR * distance, FAR_M + distance];
    const depth = (far + near) / (far - near);
    const rows = [
        row(right, eye, (2 * focal) / widthPx),
        row(up, eye, (2 * focal) / heightPx),
        row(forward, eye, depth),
        row(forward, eye, 1),
    ];
    rows[2][3] -= (2 * far * near) / (far - near);
    const viewProjection = Float32Array.from({ length: 16 }, (_, at) => rows[at % 4][at >> 2]);
    const seen = { viewProjection, eye: Float32Array.from(eye), widthPx, heightPx, pixelAtOneMetre: 1 / focal };
    return { ...seen, tableY, leafM, radiusM, pageWidthM, pageHeightM };
}

/**
 * @param {Float64Array} axis
 * @param {Float64Array} eye
 * @param {number} scale
 */
function row(axis, eye, scale) {
    const shift = axis[0] * eye[0] + axis[1] * eye[1] + axis[2] * eye[2];
    return [axis[0] * scale, axis[1] * scale, axis[2] * scale, -shift * scale];
}
