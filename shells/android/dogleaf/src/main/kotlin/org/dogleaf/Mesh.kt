// Triangles on the card, and direct views of memory that is not ours.
package org.dogleaf

import com.sun.jna.Pointer
import java.nio.ByteBuffer
import java.nio.ByteOrder

/** Bytes of a vertex: position, normal, place in the page picture. */
internal const val STRIDE: Int = 32

/** The vertices where the core keeps them: valid as long as the [Book] is not freed, read between two of its calls. */
public fun MeshView.bytes(): ByteBuffer = view(address, byteLen)

/** The indices where the core keeps them. */
public fun IndexView.bytes(): ByteBuffer = view(address, byteLen)

private fun view(address: ULong, length: ULong): ByteBuffer =
    Pointer(address.toLong()).getByteBuffer(0, length.toLong()).order(ByteOrder.nativeOrder())

/** A vertex array with its two buffers. */
internal class Mesh(private val gl: Gles, indices: ByteBuffer) {
    private val array: Int = gl.vertexArray()
    private val vertices: Int = gl.buffer()

    init {
        gl.bindVertexArray(array)
        gl.bindBuffer(Gl.ARRAY_BUFFER, vertices)
        gl.attribute(0, 3, STRIDE, 0)
        gl.attribute(1, 3, STRIDE, 12)
        gl.attribute(2, 2, STRIDE, 24)
        gl.bindBuffer(Gl.ELEMENT_ARRAY_BUFFER, gl.buffer())
        gl.bufferData(Gl.ELEMENT_ARRAY_BUFFER, indices, Gl.STATIC_DRAW)
        gl.bindVertexArray(0)
    }

    /** Replaces all vertices; the driver need not wait for those of the last frame. */
    fun fill(bytes: ByteBuffer) {
        gl.bindBuffer(Gl.ARRAY_BUFFER, vertices)
        gl.bufferData(Gl.ARRAY_BUFFER, bytes, Gl.DYNAMIC_DRAW)
    }

    fun bind(): Unit = gl.bindVertexArray(array)

    /** Draws so many indices from the first on; the mesh is bound. */
    fun draw(first: Int, count: Int): Unit = gl.drawElements(count, 2 * first)
}
