// Promise: the example that replaces a page curl works as it stands there.
package org.dogleaf

import java.nio.ByteBuffer
import org.dogleaf.examples.HostLoop
import org.dogleaf.examples.Reader
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class HostLoopTest {
    private class Shelf : Reader {
        val went = mutableListOf<Int>()
        val said = mutableListOf<String>()
        val drawn = mutableListOf<Int>()
        var asked = false

        override fun pageCount() = 12
        override fun pageSize() = 4 to 6
        override fun drawPage(number: Int): ByteBuffer {
            drawn += number
            return ByteBuffer.allocateDirect(4 * 4 * 6)
        }
        override fun goTo(page: Int) = went.plusAssign(page)
        override fun say(text: String) = said.plusAssign(text)
        override fun askForFrame() {
            asked = true
        }
    }

    @Test
    fun `a key turns one page, and then nothing is asked for`() {
        val reader = Shelf()
        HeadlessGl(320, 240).use { screen ->
            HostLoop(screen.gl, reader, 320, 240).use { loop ->
                loop.turn(true)
                var frames = 0L
                while (reader.asked) {
                    reader.asked = false
                    frames += 1
                    loop.frame(frames * FRAME_US)
                    assertTrue(frames < 400, "it comes to rest")
                }
                assertEquals(listOf(2), reader.went)
                assertEquals(listOf("page 3 of 12"), reader.said)
                assertEquals(reader.drawn.distinct(), reader.drawn, "each page is drawn once")
                assertTrue(reader.drawn.containsAll(listOf(0, 1, 2)), "${reader.drawn}")
                assertEquals(0, screen.gl.error())
            }
        }
    }
}
