//! A vertex shader and a fragment shader, linked.

use super::Gl;
use glow::HasContext;

/// A linked program.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Program(glow::NativeProgram);

impl Gl {
    /// Compiles and links.
    ///
    /// # Errors
    ///
    /// What the driver's compiler says.
    pub(crate) fn program(&self, vertex: &str, fragment: &str) -> Result<Program, String> {
        // SAFETY: the context is current, and the shaders belong to it.
        unsafe {
            let program = self.raw.create_program()?;
            for (kind, source) in [(glow::VERTEX_SHADER, vertex), (glow::FRAGMENT_SHADER, fragment)]
            {
                let shader = self.raw.create_shader(kind)?;
                self.raw.shader_source(shader, source);
                self.raw.compile_shader(shader);
                if !self.raw.get_shader_compile_status(shader) {
                    return Err(self.raw.get_shader_info_log(shader));
                }
                self.raw.attach_shader(program, shader);
                self.raw.delete_shader(shader);
            }
            self.raw.link_program(program);
            if !self.raw.get_program_link_status(program) {
                return Err(self.raw.get_program_info_log(program));
            }
            Ok(Program(program))
        }
    }

    /// Draws with it from now on; the setters below speak to it.
    pub(crate) fn use_program(&self, program: Program) {
        // SAFETY: the context is current, and the program is its own.
        unsafe { self.raw.use_program(Some(program.0)) }
    }

    /// A whole number: also a sampler's unit.
    pub(crate) fn int(&self, program: Program, name: &str, value: i32) {
        // SAFETY: the context is current, the program is its own and in use; a name it lacks is none.
        unsafe { self.raw.uniform_1_i32(self.place(program, name).as_ref(), value) }
    }

    /// A number.
    pub(crate) fn float(&self, program: Program, name: &str, value: f32) {
        // SAFETY: as for `int`.
        unsafe { self.raw.uniform_1_f32(self.place(program, name).as_ref(), value) }
    }

    /// Two numbers.
    pub(crate) fn vec2(&self, program: Program, name: &str, value: [f32; 2]) {
        // SAFETY: as for `int`.
        unsafe { self.raw.uniform_2_f32_slice(self.place(program, name).as_ref(), &value) }
    }

    /// Three numbers.
    pub(crate) fn vec3(&self, program: Program, name: &str, value: [f32; 3]) {
        // SAFETY: as for `int`.
        unsafe { self.raw.uniform_3_f32_slice(self.place(program, name).as_ref(), &value) }
    }

    /// Four numbers.
    pub(crate) fn vec4(&self, program: Program, name: &str, value: [f32; 4]) {
        // SAFETY: as for `int`.
        unsafe { self.raw.uniform_4_f32_slice(self.place(program, name).as_ref(), &value) }
    }

    /// A matrix, column by column.
    pub(crate) fn mat4(&self, program: Program, name: &str, value: &[f32; 16]) {
        // SAFETY: as for `int`.
        unsafe {
            self.raw.uniform_matrix_4_f32_slice(self.place(program, name).as_ref(), false, value);
        }
    }

    fn place(&self, program: Program, name: &str) -> Option<glow::NativeUniformLocation> {
        // SAFETY: the context is current, and the program is its own.
        unsafe { self.raw.get_uniform_location(program.0, name) }
    }
}
