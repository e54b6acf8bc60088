// A book drawn by OpenGL ES 3.0: one mesh, one program for all that is seen, one for what throws shadows.
package org.dogleaf

import java.nio.ByteBuffer
import java.nio.ByteOrder

/**
 * Draws one [Book] into whatever the current context draws into. It knows no window and no input.
 *
 * Make it and use it on the thread the context is current on. Where a context is lost, make another renderer and hand
 * it the pages again: the book itself has lost nothing.
 */
public class BookRenderer(private val gl: Gles, private val book: Book) {
    private val page = Program.of(gl, "page")
    private val shadow = Program.of(gl, "shadow")
    private val vertices = book.mesh().bytes()
    private val mesh = Mesh(gl, book.indices().bytes())
    private val table = Mesh(gl, shorts(0, 1, 2, 0, 2, 3))
    private val lampMaps = Maps(gl, LAMPS, 4, 512)
    private val skyMaps = Maps(gl, SKIES, 8, 192)
    private val grain = grain()
    private val blank = upload(1, 1, ByteBuffer.allocateDirect(4).putInt(-1).apply { flip() })
    private val pages = HashMap<Int, Int>()

    private var stage = book.stage()
    private var pieces: List<Piece> = emptyList()
    private var looks: List<Look> = emptyList()
    private var piecesGeneration = -1L
    private var generation = -1L
    private val two = FloatArray(2)
    private val matrix = FloatArray(16)
    private val eye = FloatArray(3)
    private val bound = FloatArray(4)

    init {
        page.use()
        for ((name, unit) in UNITS) gl.set(page.place(name), unit)
        restage()
        val error = gl.error()
        if (error != 0) throw GlException("error 0x${error.toString(16)} while setting up")
    }

    /** What the driver calls itself. */
    public fun driver(): String = gl.name()

    /** Takes note of another view: after [Book.look] or [Book.resize]. */
    public fun restage() {
        stage = book.stage()
        for (n in 0 until 16) matrix[n] = stage.viewProjection[n]
        for (n in 0 until 3) eye[n] = stage.eye[n]
        bound[3] = stage.radiusM
        val y = stage.tableY
        val corners = ByteBuffer.allocateDirect(4 * STRIDE).order(ByteOrder.nativeOrder())
        for ((x, z) in listOf(-TABLE_M to -TABLE_M, -TABLE_M to TABLE_M, TABLE_M to TABLE_M, TABLE_M to -TABLE_M)) {
            for (value in floatArrayOf(x, y, z, 0f, 1f, 0f, 0.5f, 0.5f)) corners.putFloat(value)
        }
        corners.flip()
        table.fill(corners)
    }

    /** Whether a page's picture is there. */
    public fun hasPage(page: Int): Boolean = page in pages

    /** Pages that the book shows now and whose pictures are missing. */
    public fun missingPages(): List<Int> =
        looks.flatMap { listOf(it.front, it.back) }.filter { it != Look.NO_PAGE && it !in pages }.distinct()

    /** Takes a page's picture: a direct buffer of RGBA bytes, sRGB, rows from the top, opaque. */
    public fun setPage(number: Int, width: Int, height: Int, rgba: ByteBuffer) {
        require(rgba.remaining() == 4 * width * height) { "a picture has four bytes a pixel" }
        pages.put(number, upload(width, height, rgba))?.let(gl::deleteTexture)
    }

    /** Gives back the pictures of all pages but these. */
    public fun keepPages(wanted: (Int) -> Boolean) {
        pages.entries.removeAll { (number, texture) ->
            val drop = !wanted(number)
            if (drop) gl.deleteTexture(texture)
            drop
        }
    }

    /** Takes over what a step made, if it made something. */
    public fun update(frame: Frames) {
        if (frame.piecesGeneration != piecesGeneration) {
            pieces = book.pieces().filter { it.visible }
            looks = pieces.map(Look::of)
            piecesGeneration = frame.piecesGeneration
        }
        if (frame.generation != generation) {
            vertices.rewind()
            mesh.fill(vertices)
            generation = frame.generation
            maps()
        }
    }

    /** Draws the book as of [frame] into the framebuffer that is bound, in the size of the view. */
    public fun draw(frame: Frames) {
        update(frame)
        gl.viewport(0, 0, stage.widthPx.toInt(), stage.heightPx.toInt())
        gl.enable(Gl.BLEND, false)
        gl.enable(Gl.SCISSOR_TEST, false)
        gl.enable(Gl.DEPTH_TEST, true)
        gl.enable(Gl.CULL_FACE, true)
        gl.depthLess()
        gl.clear(BACKGROUND)
        page.use()
        light(page)
        gl.set(page.place("clipFromWorld"), matrix)
        gl.set(page.place("eye"), eye)
        two[0] = stage.widthPx.toFloat()
        two[1] = stage.heightPx.toFloat()
        gl.set(page.place("picture"), two)
        gl.set(page.place("pixelAtOneMetre"), stage.pixelAtOneMetre)
        gl.set(page.place("lampColour"), LAMP_COLOUR)
        gl.bindTexture(2, grain)
        gl.bindTexture(3, lampMaps.texture)
        gl.bindTexture(4, skyMaps.texture)
        mesh.bind()
        for (n in pieces.indices) {
            take(looks[n], frame)
            mesh.draw(pieces[n].firstIndex.toInt(), pieces[n].indexCount.toInt())
        }
        // Last: most of it is hidden by then.
        table.bind()
        take(Look.TABLE, frame)
        table.draw(0, 6)
        gl.bindVertexArray(0)
    }

    private fun take(look: Look, frame: Frames) {
        val passing = when (look.passes) {
            1 -> frame.through
            2 -> frame.flyingThrough
            else -> 0f
        }
        gl.set(page.place("material"), look.material)
        gl.set(page.place("tint"), look.tint)
        gl.set(page.place("passing"), passing)
        gl.set(page.place("thickness"), if (passing > 0f) minOf(stage.leafM, 1e-3f) else 0f)
        gl.set(page.place("leaves"), look.leaves)
        gl.bindTexture(0, pages[look.front] ?: blank)
        gl.bindTexture(1, pages[look.back] ?: blank)
    }

    /** Draws every shadow map, and comes back to the framebuffer that was bound. */
    private fun maps() {
        val before = gl.boundFramebuffer()
        shadow.use()
        light(shadow)
        mesh.bind()
        lampMaps.fill(0, ::map)
        skyMaps.fill(LAMPS, ::map)
        gl.bindVertexArray(0)
        gl.bindFramebuffer(before)
    }

    private fun map(number: Int) {
        gl.set(shadow.place("map"), number)
        var at = 0
        // Pieces that follow each other in the buffer are drawn in one go.
        while (at < pieces.size) {
            val first = pieces[at].firstIndex
            var end = first + pieces[at].indexCount
            while (at + 1 < pieces.size && pieces[at + 1].firstIndex == end) {
                at += 1
                end += pieces[at].indexCount
            }
            mesh.draw(first.toInt(), (end - first).toInt())
            at += 1
        }
    }

    /** Where the lamp is and what can stand in its way. */
    private fun light(program: Program) {
        gl.set(program.place("lamp"), LAMP)
        gl.set(program.place("bound"), bound)
    }

    private fun upload(width: Int, height: Int, rgba: ByteBuffer?): Int {
        val texture = gl.texture()
        gl.picture(width, height, rgba)
        gl.parameter(Gl.TEXTURE_MIN_FILTER, Gl.LINEAR_MIPMAP_LINEAR)
        gl.parameter(Gl.TEXTURE_MAG_FILTER, Gl.LINEAR)
        gl.parameter(Gl.TEXTURE_WRAP_S, Gl.CLAMP_TO_EDGE)
        gl.parameter(Gl.TEXTURE_WRAP_T, Gl.CLAMP_TO_EDGE)
        if (rgba != null) gl.mipChain()
        return texture
    }

    /** The wood of the table, drawn once into a picture. */
    private fun grain(): Int {
        val texture = upload(GRAIN_WIDTH, GRAIN_HEIGHT, null)
        val before = gl.boundFramebuffer()
        val frame = gl.framebuffer()
        gl.bindFramebuffer(frame)
        gl.attach(Gl.COLOR_ATTACHMENT0, texture)
        gl.viewport(0, 0, GRAIN_WIDTH, GRAIN_HEIGHT)
        gl.enable(Gl.DEPTH_TEST, false)
        gl.enable(Gl.CULL_FACE, false)
        gl.enable(Gl.SCISSOR_TEST, false)
        Program.of(gl, "grain").use()
        table.bind()
        gl.drawArrays(3)
        gl.bindVertexArray(0)
        gl.bindFramebuffer(before)
        gl.deleteFramebuffer(frame)
        gl.bindTexture(0, texture)
        gl.mipChain()
        return texture
    }

    private companion object {
        const val LAMPS = 16
        const val SKIES = 32
        const val GRAIN_WIDTH = 192
        const val GRAIN_HEIGHT = 1536
        /** Half a side of the table, metres. */
        const val TABLE_M = 3f
        /** Linear colour where nothing is drawn, as it is encoded. */
        val BACKGROUND = floatArrayOf(0.152f, 0.152f, 0.152f)
        /** Centre of the lamp and radius of its disc, metres; its light, linear. */
        val LAMP = floatArrayOf(-0.33f, 0.66f, -0.30f, 0.065f)
        val LAMP_COLOUR = floatArrayOf(1.15f, 1.15f * 0.93f, 1.15f * 0.83f)
        val UNITS = listOf("front" to 0, "back" to 1, "grain" to 2, "lampMaps" to 3, "skyMaps" to 4)

        fun shorts(vararg values: Int): ByteBuffer {
            val bytes = ByteBuffer.allocateDirect(2 * values.size).order(ByteOrder.nativeOrder())
            values.forEach { bytes.putShort(it.toShort()) }
            return bytes.apply { flip() }
        }
    }
}
