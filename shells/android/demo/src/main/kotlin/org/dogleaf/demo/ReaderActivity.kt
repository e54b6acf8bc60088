// A reader of one book.
package org.dogleaf.demo

import android.animation.ValueAnimator
import android.app.Activity
import android.content.Intent
import android.os.Bundle
import android.os.ParcelFileDescriptor
import android.view.KeyEvent
import java.io.File
import org.dogleaf.BookView
import org.dogleaf.Layout
import org.dogleaf.Motion
import org.dogleaf.MotionPolicy
import org.dogleaf.Notice
import org.dogleaf.bookOptions

/** Shows a PDF that was opened with it, or the book that comes along. */
class ReaderActivity : Activity() {
    private lateinit var view: BookView
    private lateinit var source: PdfPages
    private var saved: ByteArray? = null

    override fun onCreate(state: Bundle?) {
        super.onCreate(state)
        view = BookView(this)
        setContentView(view)
        source = PdfPages(file())
        val wide = resources.displayMetrics.run { widthPixels > heightPixels }
        val options = bookOptions(source.pages.toUInt(), 1u, 1u).run {
            copy(heightM = widthM * source.aspect, layout = if (wide) Layout.SPREAD else Layout.SINGLE)
        }
        view.open(options, source, state?.getByteArray(BOOK))
        // "Remove animations" turns pages as well, only without the way.
        if (!ValueAnimator.areAnimatorsEnabled()) view.setMotion(Motion(MotionPolicy.REDUCED, null))
        view.onNotice = { if (it is Notice.Committed) view.snapshot { bytes -> saved = bytes } }
    }

    private fun file(): ParcelFileDescriptor {
        intent.data?.takeIf { intent.action == Intent.ACTION_VIEW }?.let { return contentResolver.openFileDescriptor(it, "r")!! }
        val copy = File(cacheDir, "old-verses.pdf")
        assets.open("old-verses.pdf").use { from -> copy.outputStream().use(from::copyTo) }
        return ParcelFileDescriptor.open(copy, ParcelFileDescriptor.MODE_READ_ONLY)
    }

    override fun onKeyDown(code: Int, event: KeyEvent?): Boolean = when (code) {
        KeyEvent.KEYCODE_PAGE_DOWN, KeyEvent.KEYCODE_VOLUME_DOWN -> true.also { view.turn(true) }
        KeyEvent.KEYCODE_PAGE_UP, KeyEvent.KEYCODE_VOLUME_UP -> true.also { view.turn(false) }
        else -> super.onKeyDown(code, event)
    }

    override fun onSaveInstanceState(state: Bundle) {
        super.onSaveInstanceState(state)
        saved?.let { state.putByteArray(BOOK, it) }
    }

    override fun onPause() {
        view.onPause()
        super.onPause()
    }

    override fun onResume() {
        super.onResume()
        view.onResume()
    }

    override fun onDestroy() {
        view.close()
        super.onDestroy()
    }

    private companion object {
        const val BOOK = "book"
    }
}
