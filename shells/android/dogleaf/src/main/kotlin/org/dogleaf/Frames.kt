// The frame loop: one native call a frame, no garbage.
package org.dogleaf

import com.sun.jna.Pointer
import java.nio.ByteBuffer
import java.nio.ByteOrder

/** The two calls of the frame loop, by JNI's naming rule: JNA would make garbage at each. */
internal object FastCalls {
    init {
        load()
    }

    @JvmStatic external fun step(ticket: Long, nowUs: Long, samples: Int): Int

    @JvmStatic external fun feed(ticket: Long, samples: Int): Int

    /** On a phone by name; on a JVM from where JNA found it. */
    private fun load() {
        val folder = System.getProperty("jna.library.path")
        val file = folder?.let { java.io.File(it, System.mapLibraryName("dogleaf_ffi")) }
        if (file != null && file.exists()) System.load(file.absolutePath) else System.loadLibrary("dogleaf_ffi")
    }
}

/**
 * A [Book] from frame to frame: put samples in, [step], read what came of it. One thread at a time.
 *
 * It does what [Book.pointers], [Book.step] and [Book.notices] do, in one call and without making objects.
 */
public class Frames(private val book: Book) {
    private val ticket: Long
    private val words: ByteBuffer
    private var waiting = 0

    init {
        val view = book.frameWords()
        ticket = view.ticket.toLong()
        words = Pointer(view.address.toLong()).getByteBuffer(0, view.byteLen.toLong()).order(ByteOrder.nativeOrder())
    }

    /** The mesh was made anew: upload it and draw. */
    public val draw: Boolean get() = word(0) and 1L != 0L

    /** Step again at the next frame; else not before the next input. */
    public val needsFrame: Boolean get() = word(0) and 2L != 0L

    /** Number of the mesh. */
    public val generation: Long get() = word(1)

    /** Number of the list of pieces. */
    public val piecesGeneration: Long get() = word(2)

    /** Largest stretch of the leaf's edges, as a share of their length. */
    public val stretch: Float get() = words.getFloat(8 * 4)

    /** Share of the light that passes the leaf in the air. */
    public val through: Float get() = words.getFloat(8 * 5)

    /** The same of the leaf that slips into the hand or out of it. */
    public val flyingThrough: Float get() = words.getFloat(8 * 6)

    /** How the physics went. */
    public val status: StepStatus get() = STATUSES[word(7).toInt()]

    /**
     * The picture that electronic paper is to show now, under [MotionPolicy.E_INK] only: draw, then refresh the panel there.
     * Null where none is due; then nothing is to be drawn either.
     */
    public val panel: PanelUpdate? get() = if (word(8) == 0L) null else panel(word(8), word(9))

    /** Puts a pointer sample in; it is taken at the next [step]. Oldest first. */
    public fun pointer(timeUs: Long, id: Int, phase: Phase, x: Float, y: Float, leaves: Int = 0) {
        if (waiting == MOST) flush()
        val at = FIRST_SAMPLE + 32 * waiting
        words.putLong(at, timeUs)
        words.putLong(at + 8, (id and 0xFF).toLong() or (phase.ordinal.toLong() shl 8) or ((leaves and 0xFFFF).toLong() shl 16))
        words.putLong(at + 16, x.toRawBits().toLong())
        words.putLong(at + 24, y.toRawBits().toLong())
        waiting += 1
    }

    /**
     * Takes the samples and lets time pass until [nowUs], of the same clock as theirs. Answers whether all samples were
     * taken: one that came out of order is dropped.
     *
     * Throws [DogleafException.Closed] and [DogleafException.Panicked] as [Book.step] does.
     */
    public fun step(nowUs: Long): Boolean = answer(FastCalls.step(ticket, nowUs, taken()))

    /** Reads what happened, oldest first. Each notice is told once; ask after every [step]. */
    public fun notices(tell: (Notice) -> Unit) {
        val count = word(3).toInt()
        for (n in 0 until count) tell(notice(FIRST_NOTICE + 16 * n))
        words.putLong(8 * 3, 0L)
    }

    private fun flush(): Boolean = answer(FastCalls.feed(ticket, taken()))

    private fun taken(): Int = waiting.also { waiting = 0 }

    private fun answer(code: Int): Boolean = when (code) {
        0 -> true
        2 -> false
        3 -> throw DogleafException.Panicked("dogleaf broke and put the book back to rest")
        else -> throw DogleafException.Closed("the book is closed")
    }

    private fun word(n: Int): Long = words.getLong(8 * n)

    private fun notice(at: Int): Notice {
        val kind = words.getInt(at)
        val first = words.getInt(at + 4).toUInt()
        val second = words.getInt(at + 8).toUInt()
        return when (kind) {
            0 -> Notice.Lifted(second != 0u, first)
            1 -> Notice.Held(first)
            2 -> Notice.Committed(first)
            3 -> Notice.Cancelled
            4 -> Notice.Announce(first, second)
            5 -> Notice.Haptic(TICKS[first.toInt()])
            else -> Notice.Asleep
        }
    }

    private fun panel(place: Long, how: Long) = PanelUpdate(
        x = side(place, 0),
        y = side(place, 1),
        width = side(place, 2),
        height = side(place, 3),
        waveform = WAVEFORMS[(how and 0xFF).toInt()],
        full = how and 0x100L != 0L,
        settled = how and 0x200L != 0L,
        busyUs = (how ushr 32).toUInt(),
    )

    private fun side(place: Long, n: Int): UInt = (place ushr (16 * n) and 0xFFFF).toUInt()

    /** As `ffi/src/words.rs` lays them out; every machine we ship to has the little end first. */
    private companion object {
        const val MOST = 64
        const val FIRST_SAMPLE = 8 * 16
        const val FIRST_NOTICE = 8 * 272
        val STATUSES = StepStatus.entries
        val TICKS = Tick.entries
        val WAVEFORMS = Waveform.entries
    }
}
