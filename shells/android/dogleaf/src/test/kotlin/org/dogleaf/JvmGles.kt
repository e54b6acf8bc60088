// OpenGL ES 3.0 of the system's own libraries, for the tests: no window, no X server.
package org.dogleaf

import com.sun.jna.Memory
import com.sun.jna.Native
import com.sun.jna.Pointer
import java.nio.ByteBuffer

/** Direct bindings of what [JvmGles] needs; names as in the header. */
@Suppress("FunctionName")
private object GLESv2 {
    init {
        Native.register(GLESv2::class.java, "GLESv2")
    }

    @JvmStatic external fun glGetString(name: Int): Pointer?
    @JvmStatic external fun glGetError(): Int
    @JvmStatic external fun glCreateShader(kind: Int): Int
    @JvmStatic external fun glShaderSource(shader: Int, count: Int, sources: Pointer, lengths: Pointer?)
    @JvmStatic external fun glCompileShader(shader: Int)
    @JvmStatic external fun glGetShaderiv(shader: Int, name: Int, out: IntArray)
    @JvmStatic external fun glGetShaderInfoLog(shader: Int, size: Int, length: IntArray, out: ByteArray)
    @JvmStatic external fun glDeleteShader(shader: Int)
    @JvmStatic external fun glCreateProgram(): Int
    @JvmStatic external fun glAttachShader(program: Int, shader: Int)
    @JvmStatic external fun glLinkProgram(program: Int)
    @JvmStatic external fun glGetProgramiv(program: Int, name: Int, out: IntArray)
    @JvmStatic external fun glGetProgramInfoLog(program: Int, size: Int, length: IntArray, out: ByteArray)
    @JvmStatic external fun glUseProgram(program: Int)
    @JvmStatic external fun glGetUniformLocation(program: Int, name: String): Int
    @JvmStatic external fun glUniform1i(place: Int, value: Int)
    @JvmStatic external fun glUniform1f(place: Int, value: Float)
    @JvmStatic external fun glUniform2fv(place: Int, count: Int, values: FloatArray)
    @JvmStatic external fun glUniform3fv(place: Int, count: Int, values: FloatArray)
    @JvmStatic external fun glUniform4fv(place: Int, count: Int, values: FloatArray)
    @JvmStatic external fun glUniformMatrix4fv(place: Int, count: Int, transpose: Byte, values: FloatArray)
    @JvmStatic external fun glGenBuffers(count: Int, out: IntArray)
    @JvmStatic external fun glBindBuffer(target: Int, buffer: Int)
    @JvmStatic external fun glBufferData(target: Int, size: Long, data: Pointer?, usage: Int)
    @JvmStatic external fun glGenVertexArrays(count: Int, out: IntArray)
    @JvmStatic external fun glBindVertexArray(array: Int)
    @JvmStatic external fun glEnableVertexAttribArray(location: Int)
    @JvmStatic external fun glVertexAttribPointer(location: Int, size: Int, kind: Int, norm: Byte, stride: Int, at: Long)
    @JvmStatic external fun glGenTextures(count: Int, out: IntArray)
    @JvmStatic external fun glActiveTexture(unit: Int)
    @JvmStatic external fun glBindTexture(target: Int, texture: Int)
    @JvmStatic external fun glTexImage2D(
        target: Int, level: Int, inside: Int, width: Int, height: Int, border: Int, format: Int, kind: Int, data: Pointer?,
    )
    @JvmStatic external fun glTexStorage2D(target: Int, levels: Int, inside: Int, width: Int, height: Int)
    @JvmStatic external fun glTexParameteri(target: Int, name: Int, value: Int)
    @JvmStatic external fun glGenerateMipmap(target: Int)
    @JvmStatic external fun glDeleteTextures(count: Int, names: IntArray)
    @JvmStatic external fun glGenFramebuffers(count: Int, out: IntArray)
    @JvmStatic external fun glBindFramebuffer(target: Int, framebuffer: Int)
    @JvmStatic external fun glGetIntegerv(name: Int, out: IntArray)
    @JvmStatic external fun glFramebufferTexture2D(target: Int, place: Int, kind: Int, texture: Int, level: Int)
    @JvmStatic external fun glGenRenderbuffers(count: Int, out: IntArray)
    @JvmStatic external fun glBindRenderbuffer(target: Int, buffer: Int)
    @JvmStatic external fun glRenderbufferStorageMultisample(target: Int, samples: Int, inside: Int, width: Int, height: Int)
    @JvmStatic external fun glFramebufferRenderbuffer(target: Int, place: Int, kind: Int, buffer: Int)
    @JvmStatic external fun glBlitFramebuffer(
        x0: Int, y0: Int, x1: Int, y1: Int, toX0: Int, toY0: Int, toX1: Int, toY1: Int, mask: Int, filter: Int,
    )
    @JvmStatic external fun glDrawBuffers(count: Int, names: IntArray)
    @JvmStatic external fun glReadBuffer(name: Int)
    @JvmStatic external fun glCheckFramebufferStatus(target: Int): Int
    @JvmStatic external fun glDeleteFramebuffers(count: Int, names: IntArray)
    @JvmStatic external fun glViewport(x: Int, y: Int, width: Int, height: Int)
    @JvmStatic external fun glEnable(capability: Int)
    @JvmStatic external fun glDisable(capability: Int)
    @JvmStatic external fun glDepthMask(on: Byte)
    @JvmStatic external fun glDepthFunc(function: Int)
    @JvmStatic external fun glClearColor(r: Float, g: Float, b: Float, a: Float)
    @JvmStatic external fun glClear(mask: Int)
    @JvmStatic external fun glDrawElements(mode: Int, count: Int, kind: Int, offset: Long)
    @JvmStatic external fun glDrawArrays(mode: Int, first: Int, count: Int)
    @JvmStatic external fun glReadPixels(x: Int, y: Int, width: Int, height: Int, format: Int, kind: Int, out: Pointer)
}

/** The context that is current on this thread: see [HeadlessGl]. */
internal class JvmGles : Gles {
    private val one = IntArray(1)

    private fun made(make: (IntArray) -> Unit): Int {
        make(one)
        return one[0]
    }

    private fun log(read: (Int, IntArray, ByteArray) -> Unit): String {
        val bytes = ByteArray(4096)
        read(bytes.size, one, bytes)
        return bytes.decodeToString(0, one[0])
    }

    private fun direct(bytes: ByteBuffer): Pointer =
        Native.getDirectBufferPointer(bytes).share(bytes.position().toLong())

    override fun name(): String = listOf(Gl.VERSION, Gl.RENDERER).joinToString { GLESv2.glGetString(it)!!.getString(0) }

    override fun error(): Int = GLESv2.glGetError()

    override fun shader(kind: Int, source: String): Int {
        val shader = GLESv2.glCreateShader(kind)
        val bytes = source.encodeToByteArray()
        val text = Memory(bytes.size + 1L).apply { write(0, bytes, 0, bytes.size); setByte(bytes.size.toLong(), 0) }
        val list = Memory(8).apply { setPointer(0, text) }
        GLESv2.glShaderSource(shader, 1, list, null)
        GLESv2.glCompileShader(shader)
        if (made { GLESv2.glGetShaderiv(shader, Gl.COMPILE_STATUS, it) } == 0) {
            throw GlException(log { size, length, out -> GLESv2.glGetShaderInfoLog(shader, size, length, out) })
        }
        return shader
    }

    override fun program(vertex: Int, fragment: Int): Int {
        val program = GLESv2.glCreateProgram()
        for (shader in intArrayOf(vertex, fragment)) {
            GLESv2.glAttachShader(program, shader)
            GLESv2.glDeleteShader(shader)
        }
        GLESv2.glLinkProgram(program)
        if (made { GLESv2.glGetProgramiv(program, Gl.LINK_STATUS, it) } == 0) {
            throw GlException(log { size, length, out -> GLESv2.glGetProgramInfoLog(program, size, length, out) })
        }
        return program
    }

    override fun useProgram(program: Int): Unit = GLESv2.glUseProgram(program)
    override fun uniform(program: Int, name: String): Int = GLESv2.glGetUniformLocation(program, name)
    override fun set(place: Int, value: Int): Unit = GLESv2.glUniform1i(place, value)
    override fun set(place: Int, value: Float): Unit = GLESv2.glUniform1f(place, value)
    override fun set(place: Int, values: FloatArray): Unit = when (values.size) {
        2 -> GLESv2.glUniform2fv(place, 1, values)
        3 -> GLESv2.glUniform3fv(place, 1, values)
        4 -> GLESv2.glUniform4fv(place, 1, values)
        else -> GLESv2.glUniformMatrix4fv(place, 1, 0, values)
    }

    override fun buffer(): Int = made { GLESv2.glGenBuffers(1, it) }
    override fun bindBuffer(target: Int, buffer: Int): Unit = GLESv2.glBindBuffer(target, buffer)
    override fun bufferData(target: Int, bytes: ByteBuffer, usage: Int): Unit =
        GLESv2.glBufferData(target, bytes.remaining().toLong(), direct(bytes), usage)

    override fun vertexArray(): Int = made { GLESv2.glGenVertexArrays(1, it) }
    override fun bindVertexArray(array: Int): Unit = GLESv2.glBindVertexArray(array)
    override fun attribute(location: Int, size: Int, stride: Int, offset: Int) {
        GLESv2.glEnableVertexAttribArray(location)
        GLESv2.glVertexAttribPointer(location, size, Gl.FLOAT, 0, stride, offset.toLong())
    }

    override fun texture(): Int = made { GLESv2.glGenTextures(1, it) }.also { bindTexture(0, it) }
    override fun bindTexture(unit: Int, texture: Int) {
        GLESv2.glActiveTexture(Gl.TEXTURE0 + unit)
        GLESv2.glBindTexture(Gl.TEXTURE_2D, texture)
    }

    override fun picture(width: Int, height: Int, rgba: ByteBuffer?): Unit = GLESv2.glTexImage2D(
        Gl.TEXTURE_2D, 0, Gl.RGBA8, width, height, 0, Gl.RGBA, Gl.UNSIGNED_BYTE, rgba?.let(::direct),
    )

    override fun depths(width: Int, height: Int): Unit =
        GLESv2.glTexStorage2D(Gl.TEXTURE_2D, 1, Gl.DEPTH_COMPONENT16, width, height)

    override fun parameter(name: Int, value: Int): Unit = GLESv2.glTexParameteri(Gl.TEXTURE_2D, name, value)
    override fun mipChain(): Unit = GLESv2.glGenerateMipmap(Gl.TEXTURE_2D)
    override fun deleteTexture(texture: Int): Unit = GLESv2.glDeleteTextures(1, intArrayOf(texture))
    override fun framebuffer(): Int = made { GLESv2.glGenFramebuffers(1, it) }
    override fun bindFramebuffer(framebuffer: Int): Unit = GLESv2.glBindFramebuffer(Gl.FRAMEBUFFER, framebuffer)
    override fun boundFramebuffer(): Int = made { GLESv2.glGetIntegerv(Gl.FRAMEBUFFER_BINDING, it) }
    override fun attach(place: Int, texture: Int): Unit =
        GLESv2.glFramebufferTexture2D(Gl.FRAMEBUFFER, place, Gl.TEXTURE_2D, texture, 0)

    override fun depthOnly() {
        GLESv2.glDrawBuffers(1, intArrayOf(Gl.NONE))
        GLESv2.glReadBuffer(Gl.NONE)
    }

    override fun isComplete(): Boolean = GLESv2.glCheckFramebufferStatus(Gl.FRAMEBUFFER) == Gl.FRAMEBUFFER_COMPLETE
    override fun deleteFramebuffer(framebuffer: Int): Unit = GLESv2.glDeleteFramebuffers(1, intArrayOf(framebuffer))
    override fun viewport(x: Int, y: Int, width: Int, height: Int): Unit = GLESv2.glViewport(x, y, width, height)
    override fun enable(capability: Int, on: Boolean): Unit =
        if (on) GLESv2.glEnable(capability) else GLESv2.glDisable(capability)

    override fun depthLess() {
        GLESv2.glDepthMask(1)
        GLESv2.glDepthFunc(Gl.LESS)
    }

    override fun clear(colour: FloatArray?) {
        colour?.let { GLESv2.glClearColor(it[0], it[1], it[2], 1f) }
        GLESv2.glClear(Gl.DEPTH_BUFFER_BIT or if (colour == null) 0 else Gl.COLOR_BUFFER_BIT)
    }

    override fun drawElements(count: Int, offset: Int): Unit =
        GLESv2.glDrawElements(Gl.TRIANGLES, count, Gl.UNSIGNED_SHORT, offset.toLong())

    override fun drawArrays(count: Int): Unit = GLESv2.glDrawArrays(Gl.TRIANGLES, 0, count)

    /** Gives the bound framebuffer colour and depth of up to [wanted] samples a pixel; answers how many it has. */
    fun attachSamples(wanted: Int, width: Int, height: Int): Int {
        val samples = minOf(wanted, made { GLESv2.glGetIntegerv(MAX_SAMPLES, it) })
        for ((place, inside) in listOf(Gl.COLOR_ATTACHMENT0 to Gl.RGBA8, Gl.DEPTH_ATTACHMENT to Gl.DEPTH_COMPONENT24)) {
            val buffer = made { GLESv2.glGenRenderbuffers(1, it) }
            GLESv2.glBindRenderbuffer(RENDERBUFFER, buffer)
            GLESv2.glRenderbufferStorageMultisample(RENDERBUFFER, samples, inside, width, height)
            GLESv2.glFramebufferRenderbuffer(Gl.FRAMEBUFFER, place, RENDERBUFFER, buffer)
        }
        return samples
    }

    /** Makes one sample a pixel of many: from framebuffer [many] into [one], which is bound afterwards. */
    fun resolve(many: Int, one: Int, width: Int, height: Int) {
        GLESv2.glBindFramebuffer(READ_FRAMEBUFFER, many)
        GLESv2.glBindFramebuffer(DRAW_FRAMEBUFFER, one)
        GLESv2.glBlitFramebuffer(0, 0, width, height, 0, 0, width, height, Gl.COLOR_BUFFER_BIT, NEAREST)
        bindFramebuffer(one)
    }

    /** What was drawn: RGBA bytes, rows from the bottom. */
    fun read(width: Int, height: Int): ByteBuffer {
        val bytes = ByteBuffer.allocateDirect(4 * width * height)
        GLESv2.glReadPixels(0, 0, width, height, Gl.RGBA, Gl.UNSIGNED_BYTE, Native.getDirectBufferPointer(bytes))
        return bytes
    }
    private companion object {
        const val MAX_SAMPLES = 0x8D57
        const val RENDERBUFFER = 0x8D41
        const val READ_FRAMEBUFFER = 0x8CA8
        const val DRAW_FRAMEBUFFER = 0x8CA9
        const val NEAREST = 0x2600
    }
}
