// From what Android says of fingers to what the book is given.
package org.dogleaf

import android.view.MotionEvent
import java.util.concurrent.ConcurrentLinkedQueue

/** One pointer sample on its way from the UI thread to the one that steps. */
internal class Touch(val timeUs: Long, val id: Int, val phase: Phase, val x: Float, val y: Float)

/**
 * Fingers since the last frame. Android batches moves: every historical sample is kept, so that the speed of a flick is
 * that of the finger and not that of the display.
 */
internal class Touches {
    private val waiting = ConcurrentLinkedQueue<Touch>()

    /** Takes an event in, on the UI thread. Its clock is that of `System.nanoTime` and of every frame. */
    fun add(event: MotionEvent) {
        when (event.actionMasked) {
            MotionEvent.ACTION_DOWN, MotionEvent.ACTION_POINTER_DOWN -> one(event, event.actionIndex, Phase.DOWN)
            MotionEvent.ACTION_UP, MotionEvent.ACTION_POINTER_UP -> one(event, event.actionIndex, Phase.UP)
            MotionEvent.ACTION_CANCEL -> for (n in 0 until event.pointerCount) one(event, n, Phase.CANCEL)
            MotionEvent.ACTION_MOVE -> moves(event)
        }
    }

    private fun moves(event: MotionEvent) {
        for (at in 0 until event.historySize) for (n in 0 until event.pointerCount) {
            val timeUs = event.getHistoricalEventTime(at) * 1000
            val (x, y) = event.getHistoricalX(n, at) to event.getHistoricalY(n, at)
            waiting += Touch(timeUs, event.getPointerId(n), Phase.MOVE, x, y)
        }
        for (n in 0 until event.pointerCount) one(event, n, Phase.MOVE)
    }

    private fun one(event: MotionEvent, n: Int, phase: Phase) {
        waiting += Touch(event.eventTime * 1000, event.getPointerId(n), phase, event.getX(n), event.getY(n))
    }

    /** Hands all samples over, on the thread that steps. */
    fun drain(frames: Frames) {
        while (true) {
            val touch = waiting.poll() ?: return
            frames.pointer(touch.timeUs, touch.id, touch.phase, touch.x, touch.y)
        }
    }
}
