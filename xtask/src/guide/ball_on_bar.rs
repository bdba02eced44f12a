//! One contact: a ceramic ball tip on the crowned end of a steel bar, by Hertz' law.

use clench::contact::{
    Contact, ContactError, Curvature, Elastic, Geometry, Hertz, Law, effective_modulus,
};
use clench::screw::Vector;
use clench_draw::{ContactPicture, DrawError, Figure};

/// The radii of the tip and of the bar's end, in mm.
const RADII: [f64; 2] = [5.0, 12.0];

/// Young's modulus in N/mm^2 and Poisson's ratio, of silicon nitride and of steel.
const MATERIALS: [[f64; 2]; 2] = [[310e3, 0.27], [210e3, 0.3]];

/// The force, in N.
const FORCE: f64 = 50.0;

/// How much larger the overlap is drawn than it is: at its true size it is thinner than a line.
const EXAGGERATION: f64 = 400.0;

/// The contact under its force.
#[derive(Debug)]
pub(crate) struct Example {
    law: Hertz,
    contact: Contact<3, 3>,
    /// `1 / R = 1 / r_A + 1 / r_B`.
    relative_radius: f64,
}

impl Example {
    pub(crate) fn compute() -> Result<Self, ContactError> {
        let [ceramic, steel] = MATERIALS.map(|[e, nu]| Elastic::new(e, nu));
        let [tip, end] = RADII.map(Curvature::round);
        let geometry = Geometry {
            point: Vector::ZERO,
            inward_normal: Vector::new([0.0, 0.0, -1.0]),
            finger: tip,
            part: end,
        };
        let law = Hertz::of(effective_modulus(ceramic?, steel?), &geometry)?;
        let relative_radius = geometry.relative_curvature()?.smaller.recip();
        let contact = Contact::new(geometry, Law::Hertz(law), FORCE)?;
        Ok(Self { law, contact, relative_radius })
    }

    /// The contact to scale but for its overlap, with its numbers.
    pub(crate) fn figure(&self) -> Result<Figure, DrawError> {
        let overlap = EXAGGERATION * self.contact.overlap().depth();
        let [half_width, _] = self.law.semi_axes(overlap);
        ContactPicture {
            finger_radius: RADII[0],
            part_radius: RADII[1],
            overlap,
            half_width: Some(half_width),
            caption: self.caption(),
        }
        .figure()
    }

    fn caption(&self) -> Vec<String> {
        let depth = self.contact.overlap().depth();
        let [radius, _] = self.law.semi_axes(depth);
        let kilo = |value: f64| value / 1e3;
        vec![
            "silicon nitride ball, steel bar".into(),
            format!("r_{{A}} = {} mm,  r_{{B}} = {} mm", RADII[0], RADII[1]),
            format!("R = {:.3} mm", self.relative_radius),
            format!("E^{{*}} = {:.2} kN/mm^{{2}}", kilo(self.law.effective_modulus())),
            String::new(),
            format!("pressed with f = {FORCE} N:"),
            format!("overlap  δ = {:.2} µm", 1e3 * depth),
            format!("contact radius  a_{{H}} = {radius:.4} mm"),
            format!(
                "peak pressure  p_{{0}} = {:.3} kN/mm^{{2}}",
                kilo(self.law.peak_pressure(depth))
            ),
            format!("stiffness  k = f′ = {:.2} kN/mm", kilo(self.contact.slope())),
            String::new(),
            format!("drawn: δ {EXAGGERATION} times larger,"),
            format!("so a_{{H}} {} times larger", EXAGGERATION.sqrt()),
        ]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_caption_has_the_numbers_of_a_calculator() {
        // With R = 60/17 and 1/E* = 0.9271/310e3 + 0.91/210e3, by Johnson's equations 4.22 to 4.24:
        // a^3 = 3 f R / (4 E*), delta = a^2 / R, p_0 = 3 f / (2 pi a^2); and f' = 3 f / (2 delta).
        let caption = Example::compute().unwrap().caption();
        for line in [
            "R = 3.529 mm",
            "E^{*} = 136.54 kN/mm^{2}",
            "overlap  δ = 2.78 µm",
            "contact radius  a_{H} = 0.0990 mm",
            "peak pressure  p_{0} = 2.437 kN/mm^{2}",
            "stiffness  k = f′ = 27.03 kN/mm",
        ] {
            assert!(caption.iter().any(|found| found == line), "{line} in {caption:#?}");
        }
    }

    #[test]
    fn the_picture_is_drawn_with_its_caption() {
        let svg = Example::compute().unwrap().figure().unwrap().to_svg();
        assert!(svg.contains(">drawn: δ 400 times larger,</text>"));
    }
}
