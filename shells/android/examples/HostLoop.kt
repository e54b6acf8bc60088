// A page curl, replaced: everything a reader has to do, with a surface and a toolkit of its own.
package org.dogleaf.examples

import java.nio.ByteBuffer
import org.dogleaf.*

/** What your reader already has. */
interface Reader {
    fun pageCount(): Int
    fun pageSize(): Pair<Int, Int>
    fun drawPage(number: Int): ByteBuffer // RGBA, direct
    fun goTo(page: Int)
    fun say(text: String)
    fun askForFrame()
}

/** Lives on the thread your GL context is current on. */
class HostLoop(gl: Gles, private val reader: Reader, width: Int, height: Int) : AutoCloseable {
    private val book = Book.open(bookOptions(reader.pageCount().toUInt(), width.toUInt(), height.toUInt()))
    private val frames = Frames(book)
    private val renderer = BookRenderer(gl, book)

    /** Every sample your touch handler wants a page to feel, historical ones too; any clock in microseconds. */
    fun touch(timeUs: Long, finger: Int, phase: Phase, x: Float, y: Float) {
        frames.pointer(timeUs, finger, phase, x, y)
        reader.askForFrame()
    }

    /** A key, a button. */
    fun turn(forward: Boolean) {
        book.turn(forward, 1u)
        reader.askForFrame()
    }

    /** A frame, at the time it will be seen: the clock is the fingers' one. */
    fun frame(nowUs: Long) {
        frames.step(nowUs)
        frames.notices { notice ->
            when (notice) {
                is Notice.Committed -> reader.goTo(notice.page.toInt()) // exactly once a turn, or Cancelled
                is Notice.Announce -> reader.say("page ${notice.page + 1u} of ${notice.pages}")
                else -> {}
            }
        }
        renderer.update(frames)
        for (number in renderer.missingPages()) {
            val (width, height) = reader.pageSize()
            renderer.setPage(number, width, height, reader.drawPage(number))
        }
        renderer.draw(frames)
        if (frames.needsFrame) reader.askForFrame() // at rest: no frame, no work
    }

    override fun close(): Unit = book.close()
}
