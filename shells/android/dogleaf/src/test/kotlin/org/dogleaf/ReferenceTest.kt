// Promise: what this renderer draws is the one reference picture, within a stated tolerance; and the measure would notice.
package org.dogleaf

import java.awt.image.BufferedImage
import java.io.File
import javax.imageio.ImageIO
import kotlin.math.abs
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class ReferenceTest {
    private val folder = File(fixtures, "pictures/upright")
    private val scene: Map<String, String> =
        File(folder, "scene.txt").readLines().associate { line -> line.split(" = ", limit = 2).let { (key, value) -> key to value } }
    private val reference = image("reference")
    private val pages: Map<Int, BufferedImage> = numbers("page_pngs").associateWith { image("page-$it") }

    private fun word(key: String): String = checkNotNull(scene[key]) { "$key is missing in scene.txt" }
    private fun numbers(key: String): List<Int> = word(key).split(' ').map { it.toInt() }
    private fun image(name: String): BufferedImage = ImageIO.read(File(folder, "$name.png"))

    private fun options(): BookOptions {
        val (width, height) = numbers("view_px").map { it.toUInt() }
        assertEquals("book", word("paper"), "another paper needs another line here")
        return bookOptions(word("pages").toUInt(), width, height).copy(
            openAt = word("open_at").toUInt(),
            widthM = word("width_m").toDouble(),
            heightM = word("height_m").toDouble(),
            cover = Cover.valueOf(word("cover").uppercase()),
            direction = Direction.valueOf(word("direction").uppercase()),
            paper = Paper.Book,
            layout = Layout.valueOf(word("layout").uppercase()),
            fidelity = Fidelity.valueOf(word("fidelity").uppercase()),
            grip = word("grip").toDouble(),
            stepUs = word("step_us").toUInt(),
        )
    }

    /** Plays the gesture to the moment of the scene, or [later] frames beyond it, as the writer of the scene did. */
    private fun Book.playTo(frames: Frames, later: Long) {
        val frame = word("frame_us").toLong()
        val samples = ArrayDeque(gesture(word("gesture")))
        for (n in 0..word("until_us").toLong() / frame + later) {
            while (samples.isNotEmpty() && samples.first().timeUs.toLong() <= n * frame) {
                samples.removeFirst().run { frames.pointer(timeUs.toLong(), id.toInt(), phase, x, y, leaves.toInt()) }
            }
            assertTrue(frames.step(n * frame))
        }
        val hash = stateHash().toString(16).padStart(16, '0')
        if (later == 0L) assertEquals(word("state"), hash, "the same moment as in Rust")
    }

    /** The scene as this renderer draws it; [shown] says which page's picture a page gets. */
    private fun drawn(later: Long = 0, shown: (Int) -> Int = { it }): BufferedImage =
        Book.open(options()).use { book ->
            val frames = Frames(book)
            book.playTo(frames, later)
            val (width, height) = numbers("picture_px")
            book.resize(width.toUInt(), height.toUInt())
            assertEquals(word("thickness_mm").toFloat() * 1e-3f, book.stage().leafM, 1e-9f)
            HeadlessGl(width, height, SAMPLES).use { screen ->
                val renderer = BookRenderer(screen.gl, book)
                renderer.update(frames)
                assertEquals(pages.keys, renderer.missingPages().toSet(), "the pages that are seen")
                for (page in renderer.missingPages()) {
                    val picture = pages.getValue(shown(page))
                    renderer.setPage(page, picture.width, picture.height, picture.rgba())
                }
                renderer.draw(frames)
                assertEquals(0, screen.gl.error(), "the driver complains of nothing")
                println("${renderer.driver()}, ${screen.samples} samples")
                screen.picture()
            }
        }

    /** How far pictures are apart in 1/255 of a channel: on the mean, and 99 of 100 bytes at most. */
    private data class Apart(val mean: Double, val most: Int) {
        val fits: Boolean get() = mean <= MEAN && most <= MOST
    }

    private fun apart(found: BufferedImage): Apart {
        assertEquals(reference.width to reference.height, found.width to found.height)
        val counts = LongArray(256)
        for (y in 0 until found.height) for (x in 0 until found.width) {
            val (a, b) = reference.getRGB(x, y) to found.getRGB(x, y)
            for (shift in intArrayOf(0, 8, 16)) counts[abs((a shr shift and 255) - (b shr shift and 255))] += 1L
        }
        val all = counts.sum()
        var seen = 0L
        val most = counts.indexOfFirst { seen += it; seen * 100 >= all * 99 }
        return Apart(counts.withIndex().sumOf { (d, n) -> d * n }.toDouble() / all, most)
    }

    @Test
    fun `the picture is the reference`() {
        val picture = drawn()
        picture.keep("reference-kotlin")
        val found = apart(picture)
        println("to the reference: $found")
        assertTrue(found.fits, "too far from the reference: $found")
    }

    @Test
    fun `pages that were swapped are noticed`() {
        val (first, last) = pages.keys.min() to pages.keys.max()
        val found = apart(drawn { if (it == first) last else if (it == last) first else it })
        println("pages $first and $last swapped: $found")
        assertFalse(found.fits, "pages $first and $last swapped, and still $found")
    }

    @Test
    fun `a moment later is noticed`() {
        val found = apart(drawn(later = 3))
        println("three frames later: $found")
        assertFalse(found.fits, "three frames later, and still $found")
    }

    private companion object {
        /** Mean difference from the reference, and what 99 of 100 bytes keep to, in 1/255. Reached: 1.28 and 21. */
        const val MEAN = 2.0
        const val MOST = 25

        /** Samples a pixel that are wanted; the software renderer has eight. */
        const val SAMPLES = 8
    }
}
