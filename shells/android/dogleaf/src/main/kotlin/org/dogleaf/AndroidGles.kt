// OpenGL ES 3.0 as Android has it.
package org.dogleaf

import android.opengl.GLES30
import java.nio.ByteBuffer

/** The context that is current on this thread. */
public class AndroidGles : Gles {
    private val one = IntArray(1)

    private fun made(make: (IntArray) -> Unit): Int {
        make(one)
        return one[0]
    }

    override fun name(): String = "${GLES30.glGetString(GLES30.GL_VERSION)}, ${GLES30.glGetString(GLES30.GL_RENDERER)}"

    override fun error(): Int = GLES30.glGetError()

    override fun shader(kind: Int, source: String): Int {
        val shader = GLES30.glCreateShader(kind)
        GLES30.glShaderSource(shader, source)
        GLES30.glCompileShader(shader)
        GLES30.glGetShaderiv(shader, GLES30.GL_COMPILE_STATUS, one, 0)
        if (one[0] == 0) throw GlException(GLES30.glGetShaderInfoLog(shader))
        return shader
    }

    override fun program(vertex: Int, fragment: Int): Int {
        val program = GLES30.glCreateProgram()
        for (shader in intArrayOf(vertex, fragment)) {
            GLES30.glAttachShader(program, shader)
            GLES30.glDeleteShader(shader)
        }
        GLES30.glLinkProgram(program)
        GLES30.glGetProgramiv(program, GLES30.GL_LINK_STATUS, one, 0)
        if (one[0] == 0) throw GlException(GLES30.glGetProgramInfoLog(program))
        return program
    }

    override fun useProgram(program: Int): Unit = GLES30.glUseProgram(program)

    override fun uniform(program: Int, name: String): Int = GLES30.glGetUniformLocation(program, name)

    override fun set(place: Int, value: Int): Unit = GLES30.glUniform1i(place, value)

    override fun set(place: Int, value: Float): Unit = GLES30.glUniform1f(place, value)

    override fun set(place: Int, values: FloatArray): Unit = when (values.size) {
        2 -> GLES30.glUniform2fv(place, 1, values, 0)
        3 -> GLES30.glUniform3fv(place, 1, values, 0)
        4 -> GLES30.glUniform4fv(place, 1, values, 0)
        else -> GLES30.glUniformMatrix4fv(place, 1, false, values, 0)
    }

    override fun buffer(): Int = made { GLES30.glGenBuffers(1, it, 0) }

    override fun bindBuffer(target: Int, buffer: Int): Unit = GLES30.glBindBuffer(target, buffer)

    override fun bufferData(target: Int, bytes: ByteBuffer, usage: Int): Unit =
        GLES30.glBufferData(target, bytes.remaining(), bytes, usage)

    override fun vertexArray(): Int = made { GLES30.glGenVertexArrays(1, it, 0) }

    override fun bindVertexArray(array: Int): Unit = GLES30.glBindVertexArray(array)

    override fun attribute(location: Int, size: Int, stride: Int, offset: Int) {
        GLES30.glEnableVertexAttribArray(location)
        GLES30.glVertexAttribPointer(location, size, GLES30.GL_FLOAT, false, stride, offset)
    }

    override fun texture(): Int = made { GLES30.glGenTextures(1, it, 0) }.also { bindTexture(0, it) }

    override fun bindTexture(unit: Int, texture: Int) {
        GLES30.glActiveTexture(GLES30.GL_TEXTURE0 + unit)
        GLES30.glBindTexture(GLES30.GL_TEXTURE_2D, texture)
    }

    override fun picture(width: Int, height: Int, rgba: ByteBuffer?): Unit = GLES30.glTexImage2D(
        GLES30.GL_TEXTURE_2D, 0, GLES30.GL_RGBA8, width, height, 0, GLES30.GL_RGBA, GLES30.GL_UNSIGNED_BYTE, rgba,
    )

    override fun depths(width: Int, height: Int): Unit =
        GLES30.glTexStorage2D(GLES30.GL_TEXTURE_2D, 1, GLES30.GL_DEPTH_COMPONENT16, width, height)

    override fun parameter(name: Int, value: Int): Unit = GLES30.glTexParameteri(GLES30.GL_TEXTURE_2D, name, value)

    override fun mipChain(): Unit = GLES30.glGenerateMipmap(GLES30.GL_TEXTURE_2D)

    override fun deleteTexture(texture: Int): Unit = GLES30.glDeleteTextures(1, intArrayOf(texture), 0)

    override fun framebuffer(): Int = made { GLES30.glGenFramebuffers(1, it, 0) }

    override fun bindFramebuffer(framebuffer: Int): Unit =
        GLES30.glBindFramebuffer(GLES30.GL_FRAMEBUFFER, framebuffer)

    override fun boundFramebuffer(): Int = made { GLES30.glGetIntegerv(GLES30.GL_FRAMEBUFFER_BINDING, it, 0) }

    override fun attach(place: Int, texture: Int): Unit =
        GLES30.glFramebufferTexture2D(GLES30.GL_FRAMEBUFFER, place, GLES30.GL_TEXTURE_2D, texture, 0)

    override fun depthOnly() {
        GLES30.glDrawBuffers(1, intArrayOf(GLES30.GL_NONE), 0)
        GLES30.glReadBuffer(GLES30.GL_NONE)
    }

    override fun isComplete(): Boolean =
        GLES30.glCheckFramebufferStatus(GLES30.GL_FRAMEBUFFER) == GLES30.GL_FRAMEBUFFER_COMPLETE

    override fun deleteFramebuffer(framebuffer: Int): Unit =
        GLES30.glDeleteFramebuffers(1, intArrayOf(framebuffer), 0)

    override fun viewport(x: Int, y: Int, width: Int, height: Int): Unit = GLES30.glViewport(x, y, width, height)

    override fun enable(capability: Int, on: Boolean): Unit =
        if (on) GLES30.glEnable(capability) else GLES30.glDisable(capability)

    override fun depthLess() {
        GLES30.glDepthMask(true)
        GLES30.glDepthFunc(GLES30.GL_LESS)
    }

    override fun clear(colour: FloatArray?) {
        colour?.let { GLES30.glClearColor(it[0], it[1], it[2], 1f) }
        GLES30.glClear(GLES30.GL_DEPTH_BUFFER_BIT or if (colour == null) 0 else GLES30.GL_COLOR_BUFFER_BIT)
    }

    override fun drawElements(count: Int, offset: Int): Unit =
        GLES30.glDrawElements(GLES30.GL_TRIANGLES, count, GLES30.GL_UNSIGNED_SHORT, offset)

    override fun drawArrays(count: Int): Unit = GLES30.glDrawArrays(GLES30.GL_TRIANGLES, 0, count)
}
