// Promise: the renderer of the phone draws a turn here too, and a lost context costs nothing but the pages.
package org.dogleaf

import java.awt.Color
import java.awt.Font
import java.awt.RenderingHints
import java.awt.image.BufferedImage
import java.nio.ByteBuffer
import kotlin.math.abs
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class RendererTest {
    /** A page with its number on it: red where odd, blue where even. */
    private fun page(number: Int): ByteBuffer {
        val image = BufferedImage(W, H, BufferedImage.TYPE_INT_RGB)
        image.createGraphics().apply {
            setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON)
            color = Color.WHITE
            fillRect(0, 0, W, H)
            color = if (number % 2 == 0) Color(30, 60, 160) else Color(170, 40, 30)
            fillRect(W / 10, H / 12, W * 8 / 10, H / 8)
            for (line in 0 until 16) fillRect(W / 10, H * (6 + line) / 24, W * (8 - line % 3) / 10, 4)
            color = Color.WHITE
            font = Font(Font.SANS_SERIF, Font.BOLD, H / 11)
            drawString("$number", W / 8, H / 6)
            dispose()
        }
        return image.rgba()
    }

    private fun BookRenderer.fill() = missingPages().forEach { setPage(it, W, H, page(it)) }

    private fun BufferedImage.rgb(x: Int, y: Int) = getRGB(x, y).let { listOf(it shr 16 and 255, it shr 8 and 255, it and 255) }

    private fun BufferedImage.differs(other: BufferedImage): Int =
        (0 until width * height).count {
            val (x, y) = it % width to it / width
            rgb(x, y).zip(other.rgb(x, y)).any { (a, b) -> abs(a - b) > 12 }
        }

    @Test
    fun `a turn is drawn and survives the loss of its context`() {
        Book.open(bookOptions(320u, WIDTH.toUInt(), HEIGHT.toUInt()).copy(openAt = 120u)).use { book ->
            val frame = Frames(book)
            lateinit var rest: BufferedImage
            lateinit var flight: BufferedImage
            val start = System.nanoTime()
            HeadlessGl(WIDTH, HEIGHT).use { screen ->
                val renderer = BookRenderer(screen.gl, book)
                fun shot(): BufferedImage {
                    renderer.update(frame)
                    renderer.fill()
                    renderer.draw(frame)
                    assertEquals(0, screen.gl.error(), "the driver complains of nothing")
                    return screen.picture()
                }
                frame.step(FRAME_US)
                rest = shot()
                book.turn(true, 1u)
                for (n in 2L..15L) frame.step(n * FRAME_US)
                flight = shot()
                assertTrue(frame.needsFrame && frame.through > 0.05f, "the leaf is in the air: ${frame.through}")
                println("${renderer.driver()}: ${(System.nanoTime() - start) / 1_000_000} ms for two pictures")
            }
            rest.keep("rest")
            flight.keep("flight")

            val blue = (0 until WIDTH * HEIGHT).count { rest.rgb(it % WIDTH, it / WIDTH).let { (r, _, b) -> b > r + 40 } }
            val red = (0 until WIDTH * HEIGHT).count { rest.rgb(it % WIDTH, it / WIDTH).let { (r, _, b) -> r > b + 70 } }
            assertTrue(blue > 1500, "page 120 is seen: $blue blue pixels")
            assertTrue(red > 1500, "page 119 is seen: $red red pixels")
            val bright = rest.rgb(WIDTH * 3 / 4, HEIGHT * 85 / 100)
            assertTrue(bright.all { it > 120 }, "paper is pale: $bright")
            assertTrue(rest.rgb(4, HEIGHT / 2).all { it < 150 }, "the table is dark: ${rest.rgb(4, HEIGHT / 2)}")
            val moved = rest.differs(flight)
            assertTrue(moved > WIDTH * HEIGHT / 20, "the leaf is seen in the air: $moved pixels differ")

            // The context is gone; the book is not. Another one draws the same picture.
            HeadlessGl(WIDTH, HEIGHT).use { screen ->
                val renderer = BookRenderer(screen.gl, book)
                renderer.update(frame)
                renderer.fill()
                renderer.draw(frame)
                assertEquals(0, flight.differs(screen.picture()), "drawn again from the same book")
                renderer.keepPages { false }
                assertTrue(renderer.missingPages().isNotEmpty(), "pages can be given back")
            }
        }
    }

    private companion object {
        const val WIDTH = 640
        const val HEIGHT = 480
        const val W = 390
        const val H = 600
    }
}
