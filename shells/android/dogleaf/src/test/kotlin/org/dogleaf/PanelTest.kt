// Promise: electronic paper gets few pictures, each with its place and waveform, and none at rest.
package org.dogleaf

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class PanelTest {
    private var now = 0L

    private fun onPaper() = Book.open(options()).also { it.setMotion(Motion(MotionPolicy.E_INK, null)) }

    /** Steps until nothing is owed; the pictures on the way. */
    private fun Frames.rest(): List<PanelUpdate> = buildList {
        do {
            now += FRAME_US
            assertTrue(step(now))
            notices {}
            assertEquals(draw, panel != null, "it draws what it shows")
            panel?.let { add(it) }
        } while (needsFrame)
    }

    @Test
    fun `a turn is a few pictures and the page after`() {
        onPaper().use { book ->
            val frames = Frames(book)
            val first = frames.rest()
            val whole = PanelUpdate(0u, 0u, 960u, 720u, Waveform.GC16, full = true, settled = true, first.single().busyUs)
            assertEquals(listOf(whole), first)
            now += whole.busyUs.toLong() // the panel is done with it
            book.turn(true, 1u)
            val turn = frames.rest()
            assertTrue(turn.size in 3..5, "$turn")
            assertTrue(turn.dropLast(1).none { it.settled || it.full }, "$turn")
            assertEquals(Waveform.DU, turn.first().waveform)
            assertTrue(turn.last().run { settled && !full }, "$turn")
            assertTrue(turn.all { it.x % 8u == 0u && it.x + it.width <= 960u && it.y + it.height <= 720u }, "$turn")
            assertEquals(122u, book.page())
        }
    }

    @Test
    fun `the words say what the object says`() {
        val (words, objects) = List(2) { onPaper() }
        words.use { objects.use {
            val frames = Frames(words)
            for (n in 1..200L) {
                if (n == 60L) listOf(words, objects).forEach { it.turn(true, 1u) }
                frames.step(n * FRAME_US)
                assertEquals(objects.step((n * FRAME_US).toULong()).panel, frames.panel, "frame $n")
            }
        } }
    }

    @Test
    fun `at rest nothing is shown and a lost picture is shown whole`() {
        onPaper().use { book ->
            val frames = Frames(book)
            frames.rest()
            repeat(600) {
                now += FRAME_US
                frames.step(now)
                assertNull(frames.panel)
                assertFalse(frames.draw || frames.needsFrame)
            }
            book.redraw()
            assertTrue(frames.rest().single().full)
        }
    }

    @Test
    fun `another policy has no panel`() {
        Book.open(options()).use { book ->
            val frames = Frames(book)
            book.turn(true, 1u)
            do {
                now += FRAME_US
                frames.step(now)
                assertNull(frames.panel)
            } while (frames.needsFrame)
        }
    }

    @Test
    fun `a slow panel gets fewer pictures`() {
        onPaper().use { book ->
            book.setPanel(panelOptions().copy(a2Us = null, duUs = 600_000u, keyFrames = 12u))
            val frames = Frames(book)
            frames.rest()
            book.turn(true, 1u)
            val turn = frames.rest()
            assertTrue(turn.size <= 3 && turn.none { it.waveform == Waveform.A2 }, "$turn")
        }
    }
}
