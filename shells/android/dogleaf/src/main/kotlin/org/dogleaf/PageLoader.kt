// Pages drawn beside the frames, never within one.
package org.dogleaf

import java.util.concurrent.ExecutorService
import java.util.concurrent.Executors
import kotlin.math.abs

/** Asks a [PageSource] for pages on a thread of its own. Everything else happens on the thread that draws. */
internal class PageLoader(private val source: PageSource, private val done: (PagePicture) -> Unit) : AutoCloseable {
    private val worker: ExecutorService = Executors.newSingleThreadExecutor()
    private val asked = HashSet<Int>()

    /** Pages that are missing, in a view of this size. */
    fun want(missing: List<Int>, width: Int, height: Int) {
        for (number in missing) if (asked.add(number)) worker.execute {
            val bitmap = if (number < source.pages) source.draw(number, width, height) else null
            done(PagePicture.of(number, bitmap))
        }
    }

    /** Whether a page is worth its memory: the reader may see it within a turn or two. */
    fun near(number: Int, page: Int): Boolean = (abs(number - page) <= NEAR).also { if (!it) asked.remove(number) }

    /** The card has forgotten all pages. */
    fun forget(): Unit = asked.clear()

    override fun close(): Unit = worker.shutdown()

    private companion object {
        const val NEAR = 8
    }
}
