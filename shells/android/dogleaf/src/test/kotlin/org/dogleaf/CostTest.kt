// Promise: crossing the boundary costs a frame 60 microseconds at most, and leaves nothing on the heap.
package org.dogleaf

import java.lang.management.ManagementFactory
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class CostTest {
    private fun median(times: LongArray): Double = times.sorted()[times.size / 2] / 1000.0

    private fun used(): Long {
        repeat(5) { System.gc(); Thread.sleep(50) }
        return Runtime.getRuntime().run { totalMemory() - freeMemory() }
    }

    private fun timed(rounds: Int, work: (Long) -> Unit): Double {
        val times = LongArray(rounds)
        for (n in -rounds until rounds) {
            val now = (n + rounds + 1L) * FRAME_US
            val start = System.nanoTime()
            work(now)
            if (n >= 0) times[n] = System.nanoTime() - start
        }
        return median(times)
    }

    /** On a book that sleeps the core does nothing: what is measured is the crossing. */
    @Test
    fun `a frame crosses in time`() {
        Book.open(options()).use { book ->
            val frames = Frames(book)
            var sum = 0f
            val fast = timed(FRAMES) { now ->
                frames.pointer(now, 0, Phase.MOVE, 1f, 1f)
                frames.step(now)
                if (frames.generation > 0) sum += frames.through
                frames.notices { sum += 1f }
            }
            println("Frames, sample + step + view + notices: %.2f µs median (%.0f)".format(fast, sum))
            assertTrue(fast <= 60.0, "a frame crosses in $fast µs")
        }
    }

    @Test
    fun `what uniffi's own calls cost is known`() {
        Book.open(options()).use { book ->
            val calls = listOf<Pair<String, (Long) -> Unit>>(
                "step" to { book.step(it.toULong()) },
                "mesh" to { book.mesh() },
                "notices" to { book.notices() },
                "pieces" to { book.pieces() },
            )
            for ((name, call) in calls) println("Book.%s: %.1f µs median".format(name, timed(4_000, call)))
        }
    }

    @Test
    fun `the heap is flat over a hundred thousand frames`() {
        Book.open(options()).use { book ->
            val frames = Frames(book)
            val bytes = book.mesh().bytes()
            var now = 0L
            var drawn = 0
            fun frames(count: Int) {
                for (n in 0 until count) {
                    now += FRAME_US
                    frames.step(now)
                    if (frames.draw) drawn += 1
                    frames.notices { }
                    if (!frames.needsFrame && n % 500 == 0) book.turn((now / FRAME_US / 500) % 2 == 0L, 1u)
                    bytes.getFloat(4)
                }
            }
            frames(20_000)
            val before = used()
            val collected = collections()
            frames(100_000)
            val ran = collections() - collected
            val after = used()
            println("heap: ${before / 1024} kB before, ${after / 1024} kB after 100,000 frames ($drawn drawn, $ran collections)")
            assertTrue(drawn > 5_000, "leaves turned meanwhile: $drawn")
            assertTrue(after - before < 256 * 1024, "it grew by ${after - before} bytes")
        }
    }

    private fun collections() = ManagementFactory.getGarbageCollectorMXBeans().sumOf { it.collectionCount }

    private companion object {
        const val FRAMES = 50_000
    }
}
