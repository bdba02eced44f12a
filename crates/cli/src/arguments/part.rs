//! What the command line says of a part that is a drawing or a mesh alone.

use clap::Args;

use super::value;
use crate::input::{Alone, Asked, LayerStiffness, Name, schema};

/// The part of a drawing or a mesh.
#[derive(Clone, Debug, Default, Args)]
pub(crate) struct PartArguments {
    /// Of a drawing or a mesh that is given in place of a part file: the stiffness of a contact
    /// anywhere, or with LAYER=K on one layer of a drawing, once for each.
    #[arg(long, value_name = "[LAYER=]K", value_parser = value::stiffness)]
    #[arg(allow_hyphen_values = true)]
    stiffness: Vec<LayerStiffness>,
    /// Of such a file: the units of all numbers, mm or mm,N; the force is in N if left out. A
    /// drawing in another unit is converted, one without needs this.
    #[arg(long, value_name = "LENGTH[,FORCE]", value_parser = value::units)]
    units: Option<schema::Units>,
    /// Of such a drawing: take the curves on this layer only. May be given several times.
    #[arg(long, value_name = "NAME", value_parser = value::layer)]
    layer: Vec<Name>,
    /// Of a drawing: how far edges may be from its curves; 1e-4 of its diagonal if left out.
    #[arg(long, value_name = "C", value_parser = value::positive)]
    #[arg(allow_hyphen_values = true)]
    chord: Option<f64>,
}

impl PartArguments {
    /// What is said of a file that is a part alone.
    pub(crate) fn alone(&self) -> Alone {
        Alone {
            stiffness: self.stiffness.clone(),
            units: self.units.clone(),
            layers: self.layer.iter().map(|name| name.0.clone()).collect(),
        }
    }

    /// What is said of any drawing.
    pub(crate) fn asked(&self, forbidden: &[schema::Forbidden]) -> Asked {
        let layers = forbidden.iter().filter(|f| matches!(f, schema::Forbidden::Layer(_)));
        Asked { chord: self.chord, forbidden: layers.cloned().collect() }
    }
}
