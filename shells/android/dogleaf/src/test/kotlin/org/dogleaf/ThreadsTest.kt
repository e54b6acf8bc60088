// Promise: calls from eight threads while one closes the book end in an answer or in an error, never in a crash.
package org.dogleaf

import java.util.concurrent.CountDownLatch
import java.util.concurrent.atomic.AtomicInteger
import kotlin.concurrent.thread
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class ThreadsTest {
    /** Eight threads of 10^5 calls; [end] runs in the middle. Answers how many were answered and how many refused. */
    private fun hammer(book: Book, end: (Book) -> Unit): Pair<Int, Int> {
        val ticket = book.frameWords().ticket.toLong()
        val answered = AtomicInteger()
        val refused = AtomicInteger()
        val faults = AtomicInteger()
        val half = CountDownLatch(8)
        val threads = List(8) { own ->
            thread {
                for (n in 0 until CALLS) {
                    if (n == CALLS / 2) half.countDown()
                    try {
                        // Most calls are those of the frame loop; uniffi's come between, as they do in an app.
                        val code = if (n % 50 != own) FastCalls.step(ticket, n * 100L, n % 2) else 0.also { other(book, n) }
                        if (code == 1) refused.incrementAndGet() else answered.incrementAndGet()
                    } catch (_: DogleafException.Closed) {
                        refused.incrementAndGet()
                    } catch (_: IllegalStateException) {
                        refused.incrementAndGet() // what the generated class says of a freed object
                    } catch (fault: Throwable) {
                        faults.incrementAndGet()
                        fault.printStackTrace()
                    }
                }
            }
        }
        half.await()
        end(book)
        threads.forEach(Thread::join)
        assertEquals(0, faults.get(), "nothing but answers and refusals")
        assertEquals(8 * CALLS, answered.get() + refused.get())
        return answered.get() to refused.get()
    }

    private fun other(book: Book, n: Int) {
        when (n / 50 % 5) {
            0 -> book.needsFrame()
            1 -> book.page()
            2 -> book.mesh()
            3 -> book.notices()
            else -> book.step((n * 100).toULong())
        }
    }

    @Test
    fun `one shuts the book`() {
        val book = Book.open(options())
        val (answered, refused) = hammer(book) { it.shut() }
        println("shut: $answered answered, $refused refused")
        assertTrue(answered >= 4 * CALLS, "half of them came before")
        book.close()
    }

    @Test
    fun `one frees the book`() {
        val (answered, refused) = hammer(Book.open(options())) { it.close() }
        println("freed: $answered answered, $refused refused")
        assertTrue(answered >= 4 * CALLS, "half of them came before")
    }

    private companion object {
        const val CALLS = 100_000
    }
}
