// A mesh on the graphics card: 32 bytes a vertex, 16 bits an index.

const STRIDE = 32;
/** Attribute, how many floats, at which byte. */
const ATTRIBUTES = /** @type {const} */ ([[0, 3, 0], [1, 3, 12], [2, 2, 24]]);

/** Vertices that change, indices that do not. */
export class Mesh {
    /**
     * @param {WebGL2RenderingContext} gl
     * @param {Uint16Array} indices
     */
    constructor(gl, indices) {
        this.gl = gl;
        this.size = 0;
        this.array = gl.createVertexArray();
        this.vertices = gl.createBuffer();
        this.indices = gl.createBuffer();
        gl.bindVertexArray(this.array);
        gl.bindBuffer(gl.ARRAY_BUFFER, this.vertices);
        for (const [place, floats, at] of ATTRIBUTES) {
            gl.enableVertexAttribArray(place);
            gl.vertexAttribPointer(place, floats, gl.FLOAT, false, STRIDE, at);
        }
        gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, this.indices);
        gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, indices, gl.STATIC_DRAW);
        gl.bindVertexArray(null);
    }

    /** @param {Float32Array} vertices */
    fill(vertices) {
        const { gl } = this;
        gl.bindBuffer(gl.ARRAY_BUFFER, this.vertices);
        if (this.size === vertices.byteLength) {
            gl.bufferSubData(gl.ARRAY_BUFFER, 0, vertices);
        } else {
            gl.bufferData(gl.ARRAY_BUFFER, vertices, gl.DYNAMIC_DRAW);
            this.size = vertices.byteLength;
        }
    }

    /**
     * @param {number} first
     * @param {number} count
     */
    draw(first, count) {
        this.gl.bindVertexArray(this.array);
        this.gl.drawElements(this.gl.TRIANGLES, count, this.gl.UNSIGNED_SHORT, 2 * first);
    }

    /** Frees it. */
    release() {
        this.gl.deleteVertexArray(this.array);
        this.gl.deleteBuffer(this.vertices);
        this.gl.deleteBuffer(this.indices);
    }
}
