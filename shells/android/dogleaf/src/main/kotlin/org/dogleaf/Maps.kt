// Depth maps of the lamp and of the sky, many in one texture.
package org.dogleaf

/** [count] maps of [side] texels, [across] beside each other; the sizes are those of `common.glsl`. */
internal class Maps(private val gl: Gles, private val count: Int, private val across: Int, private val side: Int) {
    val texture: Int = gl.texture()
    private val frame: Int

    init {
        gl.depths(across * side, count / across * side)
        gl.parameter(Gl.TEXTURE_MIN_FILTER, Gl.LINEAR)
        gl.parameter(Gl.TEXTURE_MAG_FILTER, Gl.LINEAR)
        gl.parameter(Gl.TEXTURE_WRAP_S, Gl.CLAMP_TO_EDGE)
        gl.parameter(Gl.TEXTURE_WRAP_T, Gl.CLAMP_TO_EDGE)
        gl.parameter(Gl.TEXTURE_COMPARE_MODE, Gl.COMPARE_REF_TO_TEXTURE)
        gl.parameter(Gl.TEXTURE_COMPARE_FUNC, Gl.LEQUAL)
        val before = gl.boundFramebuffer()
        frame = gl.framebuffer()
        gl.bindFramebuffer(frame)
        gl.attach(Gl.DEPTH_ATTACHMENT, texture)
        gl.depthOnly()
        val whole = gl.isComplete()
        gl.bindFramebuffer(before)
        if (!whole) throw GlException("the driver cannot draw depth alone")
    }

    /** Draws every map: [draw] is told the number of each, counted from [first]. */
    fun fill(first: Int, draw: (Int) -> Unit) {
        gl.bindFramebuffer(frame)
        gl.viewport(0, 0, across * side, count / across * side)
        gl.enable(Gl.DEPTH_TEST, true)
        gl.enable(Gl.CULL_FACE, false)
        gl.enable(Gl.BLEND, false)
        gl.enable(Gl.SCISSOR_TEST, false)
        gl.depthLess()
        gl.clear(null)
        for (n in 0 until count) {
            gl.viewport(n % across * side, n / across * side, side, side)
            draw(first + n)
        }
    }
}
