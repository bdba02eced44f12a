//! Places in a file: which field, by its path.

use std::fmt;

/// One step from a table or a list to what is in it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Step {
    /// A field of a table.
    Field(String),
    /// An item of a list, from 0.
    Item(usize),
}

/// The path from the top of a file to a value, such as `part.planar.outline[3]`.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Place(Vec<Step>);

impl Place {
    /// The place of the part.
    pub(crate) fn part() -> Self {
        Self::default().field("part")
    }

    /// The place of a planar part.
    pub(crate) fn planar() -> Self {
        Self::part().field("planar")
    }

    /// The place of a spatial part.
    pub(crate) fn spatial() -> Self {
        Self::part().field("spatial")
    }

    /// The place of contact number `i`.
    pub(crate) fn contact(i: usize) -> Self {
        Self::default().field("contacts").item(i)
    }

    /// The place of load number `i`.
    pub(crate) fn load(i: usize) -> Self {
        Self::default().field("loads").item(i)
    }

    /// The place of named point number `i`.
    pub(crate) fn named_point(i: usize) -> Self {
        Self::default().field("points").item(i)
    }

    /// The place of load case number `i`.
    pub(crate) fn load_case(i: usize) -> Self {
        Self::default().field("load_cases").item(i)
    }

    /// The field `name` of the table at this place.
    pub(crate) fn field(mut self, name: &str) -> Self {
        self.0.push(Step::Field(name.to_owned()));
        self
    }

    /// Item `i` of the list at this place.
    pub(crate) fn item(mut self, i: usize) -> Self {
        self.0.push(Step::Item(i));
        self
    }

    /// The steps, from the top down.
    pub(crate) fn steps(&self) -> &[Step] {
        &self.0
    }

    /// The place whose steps were found from the bottom up.
    pub(crate) fn from_reversed(mut steps: Vec<Step>) -> Self {
        steps.reverse();
        Self(steps)
    }
}

impl fmt::Display for Place {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (i, step) in self.0.iter().enumerate() {
            match step {
                Step::Field(name) if i == 0 => out.write_str(name)?,
                Step::Field(name) => write!(out, ".{name}")?,
                Step::Item(item) => write!(out, "[{item}]")?,
            }
        }
        Ok(())
    }
}
