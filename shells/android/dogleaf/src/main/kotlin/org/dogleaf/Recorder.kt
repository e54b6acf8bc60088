// Recordings of what a reader did, for a bug report.
package org.dogleaf

/** Records what a [Book] is given, and its hash after every step: `dogleaf replay` runs the bytes again. */
public class Recorder(private val book: Book) {
    private var running = false

    /** Begins; false while a leaf is in the air or the book is paused. The book is opened anew at its page. */
    public fun start(): Boolean {
        running = try {
            book.startRecording()
            true
        } catch (_: DogleafException.Busy) {
            false
        } catch (_: DogleafException.Paused) {
            false
        }
        return running
    }

    /** Ends: the bytes of a `.dlr` file, or null if there is none. */
    public fun stop(): ByteArray? {
        if (!running) return null
        running = false
        return try {
            book.stopRecording()
        } catch (_: DogleafException.Recording) {
            null
        }
    }
}
