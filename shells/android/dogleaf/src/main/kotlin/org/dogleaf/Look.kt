// What each piece of the book is made of: the uniforms of the page shader.
package org.dogleaf

/** How the shader shall take a piece: its uniforms of the same names. */
internal class Look(
    val material: Int,
    val tint: FloatArray,
    val leaves: Float = 0f,
    val front: Int = NO_PAGE,
    val back: Int = NO_PAGE,
    /** Light may pass it: 0 not, 1 as much as passes the leaf in the air, 2 the one on its way. */
    val passes: Int = 0,
) {
    companion object {
        const val NO_PAGE: Int = -1

        /** Colours, linear: bare paper, the boards' cloth, the mean of the table's wood. */
        private val PAPER = floatArrayOf(0.905f, 0.885f, 0.835f)
        private val CLOTH = floatArrayOf(0.16f, 0.035f, 0.03f)
        private val WOOD = floatArrayOf(0.105f, 0.066f, 0.042f)

        val TABLE: Look = Look(3, WOOD)

        fun of(piece: Piece): Look = when (piece.surface) {
            Surface.LEFT_SIDES, Surface.RIGHT_SIDES -> Look(1, PAPER, leaves = piece.leaves.toFloat())
            Surface.LEFT_BOARD, Surface.RIGHT_BOARD, Surface.SPINE -> Look(2, CLOTH)
            Surface.LEFT_TOP, Surface.RIGHT_TOP -> Look(0, PAPER, front = page(piece.face))
            Surface.LEFT_BOTTOM, Surface.RIGHT_BOTTOM -> Look(0, PAPER)
            Surface.LEAF_RIM ->
                if (piece.leaves > 1u) Look(1, PAPER, leaves = piece.leaves.toFloat()) else leaf(piece)
            Surface.LEAF_UP, Surface.LEAF_DOWN -> leaf(piece)
        }

        private fun leaf(piece: Piece) = Look(
            0, PAPER,
            front = page(piece.face),
            back = piece.reverse?.toInt() ?: NO_PAGE,
            passes = if (piece.flying) 2 else 1,
        )

        private fun page(face: PieceFace): Int = if (face is PieceFace.Page) face.page.toInt() else NO_PAGE
    }
}
