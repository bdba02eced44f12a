//! Elastic constants of common materials.

use crate::{ContactError, Elastic};

/// A material with its elastic constants, in SI units.
///
/// The values are typical ones for small strains at room temperature, with a source where there is
/// one for just these; where a contact matters, use those of the batch. Rubbers are linear for a
/// few percent of strain only.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Material {
    /// The name by which [`Material::named`] finds it.
    pub name: &'static str,
    /// `E`, in pascals.
    pub young_modulus_pa: f64,
    /// `nu`.
    pub poisson_ratio: f64,
    /// Where the values are from, and how far others spread, in gigapascals.
    pub source: &'static str,
}

/// A consistent set of units, by its units of length and force in SI units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Units {
    /// The unit of length, in meters: 1e-3 for millimeters.
    pub length_m: f64,
    /// The unit of force, in newtons.
    pub force_n: f64,
}

impl Units {
    /// Meters and newtons, so that moduli and pressures are in pascals.
    pub const SI: Self = Self { length_m: 1.0, force_n: 1.0 };

    /// Millimeters and newtons, so that moduli and pressures are in megapascals.
    pub const MILLIMETER_NEWTON: Self = Self { length_m: 1e-3, force_n: 1.0 };
}

impl Material {
    /// All materials known here.
    pub const ALL: [Self; 16] = [
        Self::gpa("steel", 207.0, 0.30, "Callister, table B.2: A36; 193 to 212"),
        Self::gpa("stainless steel", 193.0, 0.29, "Callister, table B.2: 304; 193 to 200"),
        Self::gpa("tool steel", 210.0, 0.30, "typical of hardened steels, 200 to 215"),
        Self::gpa("cast iron", 110.0, 0.26, "Callister, table B.2: gray, 66 to 138 by grade"),
        Self::gpa("aluminum 6061", 69.0, 0.33, "Callister, table B.2; 68 to 70"),
        Self::gpa("aluminum 7075", 71.7, 0.33, "FreeCAD materials; 71 to 72"),
        Self::gpa("brass", 101.0, 0.35, "Dowling, table 5.2; 97 to 115"),
        Self::gpa("copper", 115.0, 0.34, "Callister, table B.2: C11000; 110 to 130"),
        Self::gpa("titanium", 113.8, 0.342, "typical of Ti-6Al-4V, 110 to 120"),
        Self::gpa("carbide", 630.0, 0.24, "typical of tungsten carbide with cobalt, 550 to 650"),
        Self::gpa("silicon nitride", 310.0, 0.27, "typical of hot pressed, 300 to 320"),
        Self::gpa("alumina", 400.0, 0.22, "Dowling, table 5.2; 275 to 400 by purity"),
        Self::gpa("nylon", 2.7, 0.41, "Dowling, table 5.2: 66, dry; half of it when wet"),
        Self::gpa("acetal", 2.66, 0.363, "FreeCAD materials: POM copolymer; 2.6 to 3.1"),
        Self::gpa("ptfe", 0.5, 0.46, "Callister, table B.2; 0.40 to 0.55"),
        Self::gpa("rubber", 0.002, 0.495, "typical of soft natural rubber, 0.001 to 0.01"),
    ];

    const fn gpa(name: &'static str, gpa: f64, nu: f64, source: &'static str) -> Self {
        Self { name, young_modulus_pa: gpa * 1e9, poisson_ratio: nu, source }
    }

    /// The material called `name` in [`Material::ALL`].
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|material| material.name == name)
    }

    /// The elastic constants in the caller's units.
    ///
    /// # Errors
    ///
    /// Those of [`Elastic::new`], when the units are not positive or out of all proportion.
    ///
    /// ```
    /// use clench_contact::{Material, Units};
    /// let steel = Material::named("steel").expect("a known name");
    /// let steel = steel.elastic(Units::MILLIMETER_NEWTON)?;
    /// assert!((steel.young_modulus() - 207e3).abs() < 1e-6); // N/mm^2
    /// # Ok::<(), clench_contact::ContactError>(())
    /// ```
    pub fn elastic(&self, units: Units) -> Result<Elastic, ContactError> {
        let area = units.length_m * units.length_m;
        Elastic::new(self.young_modulus_pa * area / units.force_n, self.poisson_ratio)
    }
}
