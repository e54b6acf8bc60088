//! Paper in physical units, and the seed's raw weights.
//!
//! | symbol | here | unit |
//! |---|---|---|
//! | ρ | `areal_mass_gsm` | g/m² |
//! | t | `thickness_mm` | mm |
//! | E | `youngs_gpa` | GPa |
//! | ν | `poisson` | - |
//! | D = E t³ / 12 (1 - ν²) | [`PaperSpec::rigidity_nm`] | N m |

use super::error::{SpecError, within};

/// The seed's weights, in its model units: leaf width 12, leaf mass 1, seconds. Source: Book Sec. 5.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Weights {
    /// `w_bend3D`.
    pub bend_3d: f64,
    /// `w_bend2D`.
    pub bend_2d: f64,
    /// `w_glue`.
    pub glue: f64,
    /// `w_iso3D`.
    pub iso_3d: f64,
    /// `w_pos`.
    pub position: f64,
}

impl Default for Weights {
    fn default() -> Self {
        Self { bend_3d: 120.0, bend_2d: 200.0, glue: 600.0, iso_3d: 4000.0, position: 400.0 }
    }
}

/// Paper a scene can ask for by name. Engineering estimates, not laboratory values.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Preset {
    /// Copier paper, 80 g/m².
    #[default]
    Office,
    /// Book paper, 65 g/m².
    Book,
    /// Newsprint, 48 g/m².
    Newsprint,
    /// Coated, 120 g/m².
    Coated,
    /// Glossy, 160 g/m².
    Glossy,
    /// Matte, 130 g/m².
    Matte,
    /// Card, 300 g/m².
    Cardboard,
}

impl Preset {
    /// Every preset with the name a scene uses.
    pub const ALL: [(&'static str, Self); 7] = [
        ("office", Self::Office),
        ("book", Self::Book),
        ("newsprint", Self::Newsprint),
        ("coated", Self::Coated),
        ("glossy", Self::Glossy),
        ("matte", Self::Matte),
        ("cardboard", Self::Cardboard),
    ];
}

/// What a leaf is made of.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PaperSpec {
    /// Mass per area, g/m².
    pub areal_mass_gsm: f64,
    /// Thickness, mm.
    pub thickness_mm: f64,
    /// Young's modulus, GPa.
    pub youngs_gpa: f64,
    /// Poisson's ratio.
    pub poisson: f64,
    /// The seed's raw weights instead of the physical rigidity; masses are then spread evenly over the nodes.
    pub weights: Option<Weights>,
}

impl Default for PaperSpec {
    fn default() -> Self {
        Preset::Office.into()
    }
}

impl From<Preset> for PaperSpec {
    fn from(preset: Preset) -> Self {
        let (thickness_mm, areal_mass_gsm, youngs_gpa) = match preset {
            Preset::Office => (0.104, 80.0, 4.5),
            Preset::Book => (0.090, 65.0, 4.0),
            Preset::Newsprint => (0.070, 48.0, 3.0),
            Preset::Coated => (0.095, 120.0, 6.5),
            Preset::Glossy => (0.115, 160.0, 7.5),
            Preset::Matte => (0.135, 130.0, 5.5),
            Preset::Cardboard => (0.55, 300.0, 3.5),
        };
        Self { areal_mass_gsm, thickness_mm, youngs_gpa, poisson: 0.2, weights: None }
    }
}

impl PaperSpec {
    /// About [`Preset::Office`].
    pub const OFFICE: Self = Self {
        areal_mass_gsm: 80.0,
        thickness_mm: 0.1,
        youngs_gpa: 4.0,
        poisson: 0.2,
        weights: None,
    };

    /// Bending rigidity `D = E t³ / 12 (1 - ν²)`, N m.
    pub fn rigidity_nm(&self) -> f64 {
        let t = self.thickness_mm * 1e-3;
        self.youngs_gpa * 1e9 * t * t * t / (12.0 * (1.0 - self.poisson * self.poisson))
    }

    /// Refuses paper that is none.
    ///
    /// # Errors
    ///
    /// The first field out of range.
    pub fn check(&self) -> Result<(), SpecError> {
        within("paper.areal_mass_gsm", self.areal_mass_gsm, 1.0, 10_000.0)?;
        within("paper.thickness_mm", self.thickness_mm, 0.001, 10.0)?;
        within("paper.youngs_gpa", self.youngs_gpa, 1e-6, 1000.0)?;
        within("paper.poisson", self.poisson, 0.0, 0.49)?;
        let Some(w) = self.weights else { return Ok(()) };
        for (field, value) in [
            ("paper.weights.bend_3d", w.bend_3d),
            ("paper.weights.bend_2d", w.bend_2d),
            ("paper.weights.glue", w.glue),
            ("paper.weights.iso_3d", w.iso_3d),
            ("paper.weights.position", w.position),
        ] {
            within(field, value, 1e-3, 1e6)?;
        }
        Ok(())
    }
}
