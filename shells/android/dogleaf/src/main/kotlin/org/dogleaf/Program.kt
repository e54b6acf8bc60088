// The shaders every GL shell shares, compiled.
package org.dogleaf

/** A linked program, and the places of its uniforms once they were asked for. */
internal class Program private constructor(private val gl: Gles, private val handle: Int) {
    private val places = HashMap<String, Int>()

    fun use(): Unit = gl.useProgram(handle)

    fun place(name: String): Int = places.getOrPut(name) { gl.uniform(handle, name) }

    companion object {
        private const val FOLDER = "/org/dogleaf/glsl"

        /** Links `NAME.vert` and `NAME.frag`; the common part stands before each. */
        fun of(gl: Gles, name: String): Program {
            val common = source("common.glsl")
            val vertex = gl.shader(Gl.VERTEX_SHADER, common + source("$name.vert"))
            val fragment = gl.shader(Gl.FRAGMENT_SHADER, common + source("$name.frag"))
            return Program(gl, gl.program(vertex, fragment))
        }

        private fun source(file: String): String {
            val stream = Program::class.java.getResourceAsStream("$FOLDER/$file")
                ?: throw GlException("the shader $file is not in the package")
            return stream.use { it.readBytes().decodeToString() }
        }
    }
}
