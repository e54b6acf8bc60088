//! Small scenes that several tests look at.

#![allow(dead_code, unreachable_pub)]

use dogleaf_core::mesh::Vertex;
use dogleaf_render::{Camera, Environment, Lights, Material, Patch, PointLight, Renderer, Vec3};

/// A mesh that owns its lists.
#[derive(Default)]
pub struct Mesh {
    pub vertices: Vec<Vertex>,
    pub indices: Vec<u16>,
}

impl Mesh {
    /// A level rectangle at height `y`, facing up, `uv` from its corner at least x and z.
    pub fn level(y: f32, x: [f32; 2], z: [f32; 2]) -> Self {
        let corner = |i: usize, j: usize| Vertex {
            position: [x[i], y, z[j]],
            normal: [0.0, 1.0, 0.0],
            uv: [i as f32, j as f32],
        };
        Self {
            vertices: vec![corner(0, 0), corner(0, 1), corner(1, 1), corner(1, 0)],
            indices: vec![0, 1, 2, 0, 2, 3],
        }
    }

    /// The mesh in a material.
    pub fn patch<'a>(&'a self, material: Material<'a>) -> Patch<'a> {
        Patch { vertices: &self.vertices, indices: &self.indices, material }
    }
}

/// A camera `height` above the origin that looks straight down; up in the picture is -Z.
pub fn above(height: f32, fov_y_rad: f32) -> Camera {
    Camera { eye: Vec3::new(0.0, height, 0.0), target: Vec3::ZERO, up: Vec3::NEG_Z, fov_y_rad }
}

/// Plain opaque white.
pub fn white() -> Material<'static> {
    Material::Paper {
        front: None,
        back: None,
        thickness_m: f32::INFINITY,
        alpha: 1.0,
        tint: Vec3::splat(0.9),
        roughness: 0.9,
    }
}

/// An even room and no lamp.
pub fn room_only() -> Lights {
    Lights {
        environment: Environment::from_fn(|_| Vec3::splat(0.6)),
        point: PointLight { position: Vec3::new(0.0, 1.0, 0.0), colour: Vec3::ZERO, radius_m: 0.0 },
    }
}

/// A lamp at `position` and no room.
pub fn lamp_only(position: Vec3) -> Lights {
    Lights {
        environment: Environment::from_fn(|_| Vec3::ZERO),
        point: PointLight { position, colour: Vec3::splat(1.2), radius_m: 0.02 },
    }
}

/// Draws and gives the green channel back, row by row.
pub fn green(
    renderer: &mut Renderer,
    camera: &Camera,
    lights: &Lights,
    patches: &[Patch<'_>],
) -> Vec<u8> {
    let picture = renderer.render(camera, lights, patches).expect("the scene is sound");
    picture.chunks_exact(3).map(|p| p[1]).collect()
}
