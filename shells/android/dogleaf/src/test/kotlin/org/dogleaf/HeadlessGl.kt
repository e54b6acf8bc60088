// A context of Mesa's without any surface, and a picture to draw into.
package org.dogleaf

import com.sun.jna.Native
import com.sun.jna.Pointer
import java.awt.image.BufferedImage
import java.io.File
import java.nio.ByteBuffer
import javax.imageio.ImageIO

@Suppress("FunctionName")
private object EGL {
    init {
        Native.register(EGL::class.java, "EGL")
    }

    @JvmStatic external fun eglGetPlatformDisplay(platform: Int, display: Pointer?, attributes: Pointer?): Pointer?
    @JvmStatic external fun eglInitialize(display: Pointer, major: IntArray, minor: IntArray): Int
    @JvmStatic external fun eglBindAPI(api: Int): Int
    @JvmStatic external fun eglCreateContext(display: Pointer, config: Pointer?, share: Pointer?, attributes: IntArray): Pointer?
    @JvmStatic external fun eglMakeCurrent(display: Pointer, draw: Pointer?, read: Pointer?, context: Pointer?): Int
    @JvmStatic external fun eglDestroyContext(display: Pointer, context: Pointer): Int
}

/**
 * A current context with a picture of [width] by [height], of up to [wanted] samples a pixel; closing it loses everything
 * on the card, as a phone may.
 */
internal class HeadlessGl(val width: Int, val height: Int, wanted: Int = 1) : AutoCloseable {
    private val display = checkNotNull(EGL.eglGetPlatformDisplay(SURFACELESS, null, null)) { "no surfaceless display" }
    private val context: Pointer
    private val one: Int
    private val many: Int
    val gl: JvmGles

    /** Samples a pixel. */
    val samples: Int

    init {
        check(EGL.eglInitialize(display, IntArray(1), IntArray(1)) != 0) { "EGL does not start" }
        EGL.eglBindAPI(ES_API)
        context = checkNotNull(EGL.eglCreateContext(display, null, null, intArrayOf(CLIENT_VERSION, 3, EGL_NONE))) {
            "no OpenGL ES 3 here"
        }
        check(EGL.eglMakeCurrent(display, null, null, context) != 0) { "a context without a surface is refused" }
        gl = JvmGles()
        one = gl.framebuffer()
        gl.bindFramebuffer(one)
        val colour = gl.texture()
        gl.picture(width, height, null)
        gl.parameter(Gl.TEXTURE_MIN_FILTER, Gl.LINEAR)
        gl.attach(Gl.COLOR_ATTACHMENT0, colour)
        gl.texture().also { gl.depths(width, height); gl.attach(Gl.DEPTH_ATTACHMENT, it) }
        check(gl.isComplete()) { "the picture cannot be drawn into" }
        many = if (wanted > 1) gl.framebuffer() else one
        gl.bindFramebuffer(many)
        samples = if (many != one) gl.attachSamples(wanted, width, height) else 1
        check(gl.isComplete()) { "a picture of $samples samples cannot be drawn into" }
    }

    /** What was drawn. */
    fun picture(): BufferedImage {
        if (many != one) gl.resolve(many, one, width, height)
        val bytes = gl.read(width, height)
        gl.bindFramebuffer(many)
        val image = BufferedImage(width, height, BufferedImage.TYPE_INT_RGB)
        for (y in 0 until height) for (x in 0 until width) {
            val at = 4 * ((height - 1 - y) * width + x)
            val (r, g, b) = List(3) { bytes[at + it].toInt() and 0xFF }
            image.setRGB(x, y, (r shl 16) or (g shl 8) or b)
        }
        return image
    }

    override fun close() {
        EGL.eglMakeCurrent(display, null, null, null)
        EGL.eglDestroyContext(display, context)
    }

    private companion object {
        const val SURFACELESS = 0x31DD
        const val ES_API = 0x30A0
        const val CLIENT_VERSION = 0x3098
        const val EGL_NONE = 0x3038
    }
}

/** Keeps a picture beside the test's other results, to be looked at. */
internal fun BufferedImage.keep(name: String) {
    val folder = File(System.getProperty("dogleaf.pictures")).apply { mkdirs() }
    ImageIO.write(this, "png", File(folder, "$name.png"))
}

/** Its pixels as the renderer takes a page. */
internal fun BufferedImage.rgba(): ByteBuffer {
    val bytes = ByteBuffer.allocateDirect(4 * width * height)
    for (y in 0 until height) for (x in 0 until width) bytes.putInt(getRGB(x, y) shl 8 or 0xFF)
    return bytes.apply { flip() }
}
