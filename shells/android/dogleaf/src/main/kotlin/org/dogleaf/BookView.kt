// A book on the screen.
package org.dogleaf

import android.content.Context
import android.opengl.GLSurfaceView
import android.os.Bundle
import android.util.AttributeSet
import android.view.HapticFeedbackConstants
import android.view.MotionEvent
import android.view.accessibility.AccessibilityNodeInfo
import android.view.accessibility.AccessibilityNodeInfo.AccessibilityAction
import javax.microedition.khronos.egl.EGLConfig
import javax.microedition.khronos.opengles.GL10

/**
 * A book on the screen: it feels fingers, steps, draws and tells.
 *
 * It draws while something moves and not at all at rest. The book lives on the GL thread; everything public here
 * belongs on the UI thread. Call [onPause], [onResume] and [close] with the activity's own.
 */
public class BookView @JvmOverloads constructor(context: Context, attributes: AttributeSet? = null) :
    GLSurfaceView(context, attributes), AutoCloseable {

    /** Told of every notice, on the UI thread: pages, announcements. */
    public var onNotice: (Notice) -> Unit = {}

    /**
     * Told of every picture for electronic paper, on the UI thread, once it was drawn: refresh the panel there, with what the
     * maker's library has for the waveform. Only under [MotionPolicy.E_INK].
     */
    public var onPanel: (PanelUpdate) -> Unit = {}

    /** Words for a screen reader; the page is counted from 1. */
    public var announcement: (page: Int, pages: Int) -> String = { page, pages -> "$page / $pages" }

    /** Whether the phone ticks as a page lifts and lands. */
    public var haptics: Boolean = true

    private val touches = Touches()
    private val stage = BookStage(this, touches, ::tell) { update -> post { onPanel(update) } }

    init {
        setEGLContextClientVersion(3)
        setEGLConfigChooser(8, 8, 8, 8, 24, 0)
        preserveEGLContextOnPause = true
        setRenderer(stage)
        renderMode = RENDERMODE_WHEN_DIRTY
        isFocusable = true
    }

    /** Opens a book; the view's size stands in for that of [options]. A snapshot of [saved] wins over both. */
    public fun open(options: BookOptions, source: PageSource, saved: ByteArray? = null) {
        queueEvent { stage.open(options, source, saved) }
        requestRender()
    }

    /** Turns leaves on, or back. */
    public fun turn(forward: Boolean, leaves: Int = 1): Unit = ask { it.turn(forward, leaves.toUShort()) }

    /** Lets the leaf nobody holds come to lie at once. */
    public fun skip(): Unit = ask(Book::skip)

    /** What is shown of a turn: for the system's "remove animations", for electronic paper. */
    public fun setMotion(motion: Motion): Unit = ask { it.setMotion(motion) }

    /** What a new process needs to go on here; handed to [done] on the UI thread. */
    public fun snapshot(done: (ByteArray) -> Unit): Unit = ask { book -> book.snapshot().let { post { done(it) } } }

    /** What the electronic paper can do, under [MotionPolicy.E_INK]. */
    public fun setPanel(options: PanelOptions): Unit = ask { it.setPanel(options) }

    /** Does something with the book on the thread it lives on; what it refuses is no news. */
    public fun ask(work: (Book) -> Unit) {
        queueEvent { stage.ask(work) }
        requestRender()
    }

    override fun onPause() {
        ask(Book::pause)
        super.onPause()
    }

    override fun onResume() {
        super.onResume()
        ask(Book::resume)
    }

    /** Ends the book. */
    override fun close(): Unit = queueEvent(stage::close)

    override fun onTouchEvent(event: MotionEvent): Boolean {
        touches.add(event)
        if (event.actionMasked == MotionEvent.ACTION_DOWN) requestUnbufferedDispatch(event)
        requestRender()
        return true
    }

    override fun onInitializeAccessibilityNodeInfo(info: AccessibilityNodeInfo) {
        super.onInitializeAccessibilityNodeInfo(info)
        info.isScrollable = true
        info.addAction(AccessibilityAction.ACTION_SCROLL_FORWARD)
        info.addAction(AccessibilityAction.ACTION_SCROLL_BACKWARD)
    }

    override fun performAccessibilityAction(action: Int, arguments: Bundle?): Boolean = when (action) {
        AccessibilityAction.ACTION_SCROLL_FORWARD.id -> true.also { turn(true) }
        AccessibilityAction.ACTION_SCROLL_BACKWARD.id -> true.also { turn(false) }
        else -> super.performAccessibilityAction(action, arguments)
    }

    private fun tell(notice: Notice) {
        post {
            when (notice) {
                is Notice.Announce -> announceForAccessibility(announcement(notice.page.toInt() + 1, notice.pages.toInt()))
                is Notice.Haptic -> if (haptics) performHapticFeedback(feeling(notice.tick))
                else -> {}
            }
            onNotice(notice)
        }
    }

    private fun feeling(tick: Tick): Int = when (tick) {
        Tick.LIFT, Tick.LAND -> HapticFeedbackConstants.CONTEXT_CLICK
        Tick.OVER, Tick.FLIP -> HapticFeedbackConstants.CLOCK_TICK
    }
}

/** What happens on the GL thread. */
internal class BookStage(
    private val view: GLSurfaceView,
    private val touches: Touches,
    private val tell: (Notice) -> Unit,
    private val refresh: (PanelUpdate) -> Unit,
) : GLSurfaceView.Renderer {
    private var book: Book? = null
    private var frames: Frames? = null
    private var renderer: BookRenderer? = null
    private var pages: PageLoader? = null
    private var width = 0
    private var height = 0

    fun open(options: BookOptions, source: PageSource, saved: ByteArray?) {
        close()
        val sized = options.copy(
            pages = source.pages.toUInt(),
            widthPx = maxOf(width, 1).toUInt(),
            heightPx = maxOf(height, 1).toUInt(),
        )
        val opened = saved?.let { bytes ->
            // A snapshot of an older version is no reason not to read.
            try { Book.fromSnapshot(bytes) } catch (_: DogleafException) { null }
        } ?: Book.open(sized)
        if (width > 0) opened.resize(width.toUInt(), height.toUInt())
        book = opened
        frames = Frames(opened)
        pages = PageLoader(source) { view.queueEvent { take(it) } }
        if (width > 0) renderer = BookRenderer(AndroidGles(), opened)
    }

    fun ask(work: (Book) -> Unit) {
        try {
            book?.let(work)
        } catch (_: DogleafException) {
            // Busy, paused, at either end: nothing happens, as with a book of paper.
        }
    }

    fun close() {
        pages?.close()
        book?.close()
        pages = null
        frames = null
        renderer = null
        book = null
    }

    /** A new context: everything on the card is gone, the book is not. */
    override fun onSurfaceCreated(gl: GL10?, config: EGLConfig?) {
        renderer = null
        pages?.forget()
    }

    override fun onSurfaceChanged(gl: GL10?, width: Int, height: Int) {
        this.width = width
        this.height = height
        ask { it.resize(width.toUInt(), height.toUInt()) }
        book?.let { opened -> renderer?.restage() ?: run { renderer = BookRenderer(AndroidGles(), opened) } }
    }

    override fun onDrawFrame(gl: GL10?) {
        val (frames, renderer, pages) = Triple(frames ?: return, renderer ?: return, pages ?: return)
        try {
            touches.drain(frames)
            frames.step(System.nanoTime() / 1000)
        } catch (_: DogleafException.Panicked) {
            view.requestRender() // the book was put back to rest, and goes on
        } catch (_: DogleafException.Closed) {
            return
        }
        frames.notices(tell)
        renderer.draw(frames)
        frames.panel?.let(refresh)
        pages.want(renderer.missingPages(), width, height)
        if (frames.needsFrame) view.requestRender()
    }

    private fun take(picture: PagePicture) {
        val renderer = renderer ?: return pages?.forget() ?: Unit // to be asked for again
        renderer.keepPages { pages?.near(it, book?.page()?.toInt() ?: 0) ?: false }
        renderer.setPage(picture.number, picture.width, picture.height, picture.rgba)
        view.requestRender()
    }
}
