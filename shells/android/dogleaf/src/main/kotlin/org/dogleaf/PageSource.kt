// Where page pictures come from.
package org.dogleaf

import android.graphics.Bitmap
import java.nio.ByteBuffer

/** Pictures of pages: a PDF, an EPUB engine's output, scans. Called on a thread of [BookView]'s, one page at a time. */
public interface PageSource {
    /** Printed pages. */
    public val pages: Int

    /** Draws page [number], counted from 0, in about [width] by [height] pixels; null for blank paper. */
    public fun draw(number: Int, width: Int, height: Int): Bitmap?
}

/** The bytes a renderer takes. */
internal class PagePicture(val number: Int, val width: Int, val height: Int, val rgba: ByteBuffer) {
    companion object {
        fun of(number: Int, bitmap: Bitmap?): PagePicture {
            if (bitmap == null) return PagePicture(number, 1, 1, ByteBuffer.allocateDirect(4).putInt(-1).apply { flip() })
            val plain = if (bitmap.config == Bitmap.Config.ARGB_8888) bitmap else bitmap.copy(Bitmap.Config.ARGB_8888, false)
            val bytes = ByteBuffer.allocateDirect(4 * plain.width * plain.height)
            plain.copyPixelsToBuffer(bytes)
            return PagePicture(number, plain.width, plain.height, bytes.apply { flip() })
        }
    }
}
