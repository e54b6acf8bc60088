// Pages of a PDF, drawn by the system.
package org.dogleaf.demo

import android.graphics.Bitmap
import android.graphics.Color
import android.graphics.pdf.PdfRenderer
import android.os.ParcelFileDescriptor
import org.dogleaf.PageSource

/** A PDF. `PdfRenderer` takes one page at a time, which is how a [PageSource] is asked. */
class PdfPages(file: ParcelFileDescriptor) : PageSource, AutoCloseable {
    private val pdf = PdfRenderer(file)

    override val pages: Int get() = pdf.pageCount

    /** Height of the first page over its width. */
    val aspect: Double = pdf.openPage(0).use { it.height.toDouble() / it.width }

    override fun draw(number: Int, width: Int, height: Int): Bitmap = pdf.openPage(number).use { page ->
        // As tall as the view: a page in a spread is seen about that large.
        val across = (height.toDouble() * page.width / page.height).toInt().coerceIn(64, 4096)
        val bitmap = Bitmap.createBitmap(across, height.coerceIn(64, 4096), Bitmap.Config.ARGB_8888)
        bitmap.eraseColor(Color.WHITE)
        page.render(bitmap, null, null, PdfRenderer.Page.RENDER_MODE_FOR_DISPLAY)
        bitmap
    }

    override fun close(): Unit = pdf.close()
}
