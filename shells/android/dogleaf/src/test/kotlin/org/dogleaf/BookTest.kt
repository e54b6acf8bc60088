// Promise: the same book as in Rust, through Kotlin.
package org.dogleaf

import java.nio.ByteOrder
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class BookTest {
    private fun ends(told: List<Notice>) = told.count { it is Notice.Committed || it is Notice.Cancelled }

    @Test
    fun `one gesture gives one hash in Rust and in Kotlin`() {
        val rows = golden()
        assertTrue(rows.size >= 5, "the table of Rust is there")
        for ((name, frames, page, commits, hash) in rows) {
            Book.open(options()).use { book ->
                val (played, told) = book.play(gesture(name))
                assertEquals(hash, book.stateHash().toString(16).padStart(16, '0'), name)
                assertEquals(frames.toInt(), played, name)
                assertEquals(page.toUInt(), book.page(), name)
                assertEquals(commits.toInt(), told.count { it is Notice.Committed }, name)
            }
        }
    }

    @Test
    fun `frames without objects are the same frames`() {
        Book.open(options()).use { book ->
            val frames = Frames(book)
            val told = mutableListOf<Notice>()
            val samples = ArrayDeque(gesture("corner_turn"))
            var n = 0
            do {
                n += 1
                while (samples.isNotEmpty() && samples.first().timeUs.toLong() <= n * FRAME_US) {
                    samples.removeFirst().run { frames.pointer(timeUs.toLong(), id.toInt(), phase, x, y, leaves.toInt()) }
                }
                assertTrue(frames.step(n * FRAME_US))
                frames.notices { told += it }
                assertTrue(frames.stretch < 0.05f)
            } while (samples.isNotEmpty() || frames.needsFrame)
            val (_, played, _, _, hash) = golden().first { it.first() == "corner_turn" }
            assertEquals(hash, book.stateHash().toString(16).padStart(16, '0'))
            assertEquals(played.toInt(), n)
            assertEquals(1, ends(told))
            assertTrue(Notice.Announce(122u, 320u) in told)
            book.shut()
            assertThrows(DogleafException.Closed::class.java) { frames.step(n * FRAME_US) }
        }
    }

    @Test
    fun `a drag commits exactly once and is announced`() {
        Book.open(options()).use { book ->
            val (_, told) = book.play(gesture("slow_turn"))
            assertEquals(1, ends(told))
            assertTrue(Notice.Committed(122u) in told)
            assertTrue(Notice.Announce(122u, 320u) in told)
            assertTrue(Notice.Haptic(Tick.LAND) in told)
            assertFalse(book.needsFrame(), "asleep is asleep")
        }
    }

    @Test
    fun `a finger that is taken away cancels exactly once`() {
        Book.open(options()).use { book ->
            val drag = gesture("slow_turn").take(70)
            val away = drag.last().copy(phase = Phase.CANCEL)
            val (_, told) = book.play(drag + away)
            assertEquals(1, ends(told))
            assertTrue(Notice.Cancelled in told)
            assertEquals(120u, book.page())
        }
    }

    @Test
    fun `the mesh stays where it is and is seen through a direct buffer`() {
        Book.open(options()).use { book ->
            val before = book.mesh()
            val bytes = before.bytes()
            assertTrue(bytes.isDirect && bytes.order() == ByteOrder.nativeOrder())
            assertEquals(before.vertices.toInt() * STRIDE, bytes.remaining())
            var highest = 0f
            book.play(gesture("slow_turn")) {
                for (n in 0 until before.vertices.toInt()) highest = maxOf(highest, bytes.getFloat(n * STRIDE + 4))
            }
            assertEquals(before.address, book.mesh().address)
            assertTrue(highest in 0.05f..0.2f, "the leaf rose through the buffer: $highest m")
            assertTrue(book.indices().bytes().asShortBuffer().let { it.limit() > 3000 })
        }
    }

    @Test
    fun `errors say what is wrong`() {
        val why = assertThrows(DogleafException.Refused::class.java) { Book.open(options().copy(pages = 0u)) }
        assertTrue("book.pages" in why.message!!, why.message)
        Book.open(options().copy(openAt = 0u)).use { book ->
            assertThrows(DogleafException.NoSuchPage::class.java) { book.turn(false, 1u) }
            book.turn(true, 1u)
            assertThrows(DogleafException.Busy::class.java) { book.turn(true, 1u) }
            assertThrows(DogleafException.Recording::class.java) { book.restore(byteArrayOf(1, 2, 3)) }
            book.shut()
            assertThrows(DogleafException.Closed::class.java) { book.step(1u) }
        }
    }

    @Test
    fun `a snapshot survives the process`() {
        val bytes = Book.open(options()).use { book ->
            book.turn(true, 3u)
            book.pause()
            book.snapshot()
        }
        assertTrue(bytes.size < 400, "${bytes.size} bytes")
        Book.fromSnapshot(bytes).use { book -> assertEquals(320u, book.pages()) }
    }

    @Test
    fun `a recording is a dlr file`() {
        Book.open(options()).use { book ->
            val recorder = Recorder(book)
            assertTrue(recorder.start())
            book.play(gesture("flick"))
            val bytes = recorder.stop()!!
            assertEquals("DLR1", bytes.decodeToString(0, 4))
            assertTrue(bytes.size > 500, "${bytes.size} bytes")
            assertEquals(null, recorder.stop(), "only one")
        }
    }
}
