// What each piece of the book is made of: the uniforms of the page shader.

/** Colours, linear: bare paper, the boards' cloth, the mean of the table's wood. */
const PAPER = [0.905, 0.885, 0.835];
const CLOTH = [0.16, 0.035, 0.03];
const WOOD = [0.105, 0.066, 0.042];

/**
 * @typedef {object} Look
 * @property {number} material 0 paper, 1 the cut edges of leaves, 2 a board, 3 the table
 * @property {number[]} tint
 * @property {number} leaves leaves whose edges are seen
 * @property {number} [front] the page on this side
 * @property {number} [back] the page on the other side of the same leaf
 * @property {"through" | "flyingThrough"} [passes] light may pass it: as much as the frame says of that leaf
 */

/** @type {Look} */
export const TABLE = { material: 3, tint: WOOD, leaves: 0 };

/**
 * @param {import("./words.js").Piece[]} pieces
 * @returns {Look[]}
 */
export function looks(pieces) {
    return pieces.map(look);
}

/**
 * @param {import("./words.js").Piece} piece
 * @returns {Look}
 */
function look({ surface, flying, page, reverse, leaves }) {
    const paper = { material: 0, tint: PAPER, leaves: 0 };
    const edges = { material: 1, tint: PAPER, leaves };
    switch (surface) {
        case "leftSides":
        case "rightSides":
            return edges;
        case "leftBoard":
        case "rightBoard":
        case "spine":
            return { material: 2, tint: CLOTH, leaves: 0 };
        case "leftBottom":
        case "rightBottom":
            return paper;
        case "leftTop":
        case "rightTop":
            return { ...paper, front: page };
        case "leafRim":
            if (leaves > 1) return edges;
    }
    return { ...paper, front: page, back: reverse, passes: flying ? "flyingThrough" : "through" };
}
