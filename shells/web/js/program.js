// The shaders of `shells/glsl` as programs.
import { COMMON, SHADERS } from "./shaders.js";

/**
 * Compiles a pair of shaders.
 * @param {WebGL2RenderingContext} gl
 * @param {"page" | "shadow" | "grain"} name
 */
export function program(gl, name) {
    const made = gl.createProgram();
    for (const [kind, end] of /** @type {const} */ ([[gl.VERTEX_SHADER, "vert"], [gl.FRAGMENT_SHADER, "frag"]])) {
        const shader = gl.createShader(kind);
        if (!made || !shader) throw new Error("the graphics context is lost");
        gl.shaderSource(shader, COMMON + SHADERS[`${name}.${end}`]);
        gl.compileShader(shader);
        gl.attachShader(made, shader);
        gl.deleteShader(shader);
    }
    gl.linkProgram(made);
    if (!gl.getProgramParameter(made, gl.LINK_STATUS) && !gl.isContextLost()) {
        const logs = (gl.getAttachedShaders(made) ?? []).map((shader) => gl.getShaderInfoLog(shader));
        const line = [gl.getProgramInfoLog(made), ...logs].filter(Boolean).join(" ");
        throw new Error(`the ${name} shader is refused: ${line}`);
    }
    /** @type {Map<string, WebGLUniformLocation | null>} */
    const places = new Map();
    const place = (/** @type {string} */ uniform) => {
        if (!places.has(uniform)) places.set(uniform, gl.getUniformLocation(made, uniform));
        return places.get(uniform) ?? null;
    };
    return { program: made, place };
}
