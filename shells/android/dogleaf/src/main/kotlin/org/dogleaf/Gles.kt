// The OpenGL ES 3.0 that BookRenderer draws with: one interface, so that the same renderer runs on a phone and in a test.
package org.dogleaf

import java.nio.ByteBuffer

/** What the driver said no to. */
public class GlException(message: String) : RuntimeException(message)

/**
 * A current OpenGL ES 3.0 context. Every call belongs on the thread the context is current on.
 *
 * `AndroidGles` stands on `android.opengl.GLES30`; the tests have one that stands on the system's own libraries.
 */
public interface Gles {
    /** What the driver calls itself. */
    public fun name(): String

    /** The first thing the driver complained about since it was last asked, or 0. */
    public fun error(): Int

    /** Compiles a shader; [kind] is [Gl.VERTEX_SHADER] or [Gl.FRAGMENT_SHADER]. Throws [GlException] with the compiler's words. */
    public fun shader(kind: Int, source: String): Int

    /** Links two shaders and gives them back. Throws [GlException] with the linker's words. */
    public fun program(vertex: Int, fragment: Int): Int

    /** Draws with a program from now on. */
    public fun useProgram(program: Int)

    /** The place of a uniform; below nought if the program has none of that name. */
    public fun uniform(program: Int, name: String): Int

    /** Sets a whole number: also a sampler's unit. */
    public fun set(place: Int, value: Int)

    /** Sets a number. */
    public fun set(place: Int, value: Float)

    /** Sets two to four numbers, or a matrix of 16, column by column. */
    public fun set(place: Int, values: FloatArray)

    /** A new buffer. */
    public fun buffer(): Int

    /** Binds a buffer to [Gl.ARRAY_BUFFER] or [Gl.ELEMENT_ARRAY_BUFFER]. */
    public fun bindBuffer(target: Int, buffer: Int)

    /** Fills the bound buffer with all of [bytes], a direct buffer. */
    public fun bufferData(target: Int, bytes: ByteBuffer, usage: Int)

    /** A new vertex array. */
    public fun vertexArray(): Int

    /** Binds a vertex array; 0 for none. */
    public fun bindVertexArray(array: Int)

    /** Reads [size] floats for [location] from the bound buffer. */
    public fun attribute(location: Int, size: Int, stride: Int, offset: Int)

    /** A new texture, bound to unit 0. */
    public fun texture(): Int

    /** Binds a texture to a unit. */
    public fun bindTexture(unit: Int, texture: Int)

    /** Gives the bound texture a picture of RGBA bytes, or room for one. */
    public fun picture(width: Int, height: Int, rgba: ByteBuffer?)

    /** Gives the bound texture room for depths. */
    public fun depths(width: Int, height: Int)

    /** Sets a parameter of the bound texture. */
    public fun parameter(name: Int, value: Int)

    /** Makes the mip chain of the bound texture. */
    public fun mipChain()

    /** Gives a texture back. */
    public fun deleteTexture(texture: Int)

    /** A new framebuffer. */
    public fun framebuffer(): Int

    /** Draws into a framebuffer from now on; 0 is the window's own. */
    public fun bindFramebuffer(framebuffer: Int)

    /** The framebuffer that is drawn into. */
    public fun boundFramebuffer(): Int

    /** Attaches a texture to the bound framebuffer at [Gl.COLOR_ATTACHMENT0] or [Gl.DEPTH_ATTACHMENT]. */
    public fun attach(place: Int, texture: Int)

    /** The bound framebuffer has depths and no colour. */
    public fun depthOnly()

    /** Whether the bound framebuffer can be drawn into. */
    public fun isComplete(): Boolean

    /** Gives a framebuffer back. */
    public fun deleteFramebuffer(framebuffer: Int)

    /** Draws into this part of the target, pixels from the lower left. */
    public fun viewport(x: Int, y: Int, width: Int, height: Int)

    /** Switches a capability. */
    public fun enable(capability: Int, on: Boolean)

    /** Depth is tested with `LESS` and written. */
    public fun depthLess()

    /** Clears colour (if [colour] is given) and depth. */
    public fun clear(colour: FloatArray?)

    /** Draws triangles of 16 bit indices of the bound vertex array. */
    public fun drawElements(count: Int, offset: Int)

    /** Draws triangles without indices. */
    public fun drawArrays(count: Int)
}

/** Names of OpenGL ES 3.0 that are used here. */
public object Gl {
    public const val VERTEX_SHADER: Int = 0x8B31
    public const val FRAGMENT_SHADER: Int = 0x8B30
    public const val COMPILE_STATUS: Int = 0x8B81
    public const val LINK_STATUS: Int = 0x8B82
    public const val ARRAY_BUFFER: Int = 0x8892
    public const val ELEMENT_ARRAY_BUFFER: Int = 0x8893
    public const val STATIC_DRAW: Int = 0x88E4
    public const val DYNAMIC_DRAW: Int = 0x88E8
    public const val FLOAT: Int = 0x1406
    public const val UNSIGNED_BYTE: Int = 0x1401
    public const val UNSIGNED_SHORT: Int = 0x1403
    public const val TEXTURE_2D: Int = 0x0DE1
    public const val TEXTURE0: Int = 0x84C0
    public const val RGBA: Int = 0x1908
    public const val RGBA8: Int = 0x8058
    public const val DEPTH_COMPONENT16: Int = 0x81A5
    public const val DEPTH_COMPONENT24: Int = 0x81A6
    public const val TEXTURE_MIN_FILTER: Int = 0x2801
    public const val TEXTURE_MAG_FILTER: Int = 0x2800
    public const val TEXTURE_WRAP_S: Int = 0x2802
    public const val TEXTURE_WRAP_T: Int = 0x2803
    public const val TEXTURE_COMPARE_MODE: Int = 0x884C
    public const val TEXTURE_COMPARE_FUNC: Int = 0x884D
    public const val COMPARE_REF_TO_TEXTURE: Int = 0x884E
    public const val LINEAR: Int = 0x2601
    public const val LINEAR_MIPMAP_LINEAR: Int = 0x2703
    public const val CLAMP_TO_EDGE: Int = 0x812F
    public const val LEQUAL: Int = 0x0203
    public const val LESS: Int = 0x0201
    public const val FRAMEBUFFER: Int = 0x8D40
    public const val FRAMEBUFFER_BINDING: Int = 0x8CA6
    public const val FRAMEBUFFER_COMPLETE: Int = 0x8CD5
    public const val COLOR_ATTACHMENT0: Int = 0x8CE0
    public const val DEPTH_ATTACHMENT: Int = 0x8D00
    public const val NONE: Int = 0
    public const val DEPTH_TEST: Int = 0x0B71
    public const val CULL_FACE: Int = 0x0B44
    public const val BLEND: Int = 0x0BE2
    public const val SCISSOR_TEST: Int = 0x0C11
    public const val COLOR_BUFFER_BIT: Int = 0x4000
    public const val DEPTH_BUFFER_BIT: Int = 0x0100
    public const val TRIANGLES: Int = 4
    public const val VERSION: Int = 0x1F02
    public const val RENDERER: Int = 0x1F01
}
