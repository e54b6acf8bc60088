// What the tests share: a book on a table, gestures of the fixtures, frames of sixty a second.
package org.dogleaf

import java.io.File

internal const val FRAME_US: Long = 16_667

/** The folder of the fixtures. */
internal val fixtures: File = File(System.getProperty("dogleaf.fixtures"))

/** A paperback of 320 pages, open at 120, in a view of 960 by 720. */
internal fun options(): BookOptions = bookOptions(320u, 960u, 720u).copy(openAt = 120u)

/** A gesture of the fixtures, in pixels. */
internal fun gesture(name: String): List<PointerSample> =
    File(fixtures, "gestures/$name.jsonl").readLines().filter { it.isNotBlank() }.map { line ->
        fun number(key: String) = Regex("\"$key\":(-?\\d+)").find(line)?.groupValues?.get(1)?.toLong() ?: 0L
        val phase = Regex("\"phase\":\"(\\w+)\"").find(line)!!.groupValues[1].uppercase()
        PointerSample(
            timeUs = number("t_us").toULong(),
            id = number("id").toUByte(),
            phase = Phase.valueOf(phase),
            x = number("x") / 256f,
            y = number("y") / 256f,
            leaves = number("leaves").toUShort(),
        )
    }

/** Plays a gesture frame by frame until everything is at rest; answers the frames and what was told. */
internal fun Book.play(samples: List<PointerSample>, each: (FrameInfo) -> Unit = {}): Pair<Int, List<Notice>> {
    val told = mutableListOf<Notice>()
    var next = 0
    for (frame in 1..3_000) {
        val now = (frame * FRAME_US).toULong()
        val due = samples.drop(next).takeWhile { it.timeUs <= now }
        if (due.isNotEmpty()) pointers(due)
        next += due.size
        val info = step(now)
        if (info.notices > 0u) told += notices()
        each(info)
        if (next == samples.size && !info.needsFrame) return frame to told
    }
    error("it never comes to rest")
}

/** The table that Rust wrote, row by row. */
internal fun golden(): List<List<String>> =
    File(fixtures, "golden/bindings.txt").readLines().drop(1).filter { it.isNotBlank() }.map { it.split(' ') }
