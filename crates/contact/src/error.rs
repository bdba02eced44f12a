//! What can be wrong with a contact.

/// Why a law or a contact was refused.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ContactError {
    /// A parameter that has to be positive and finite is not.
    #[error("{parameter} is {value}, but has to be a positive finite number")]
    NotPositive {
        /// The name of the parameter.
        parameter: &'static str,
        /// What was found.
        value: f64,
    },
    /// A parameter that has to be zero or positive, and finite, is not.
    #[error("{parameter} is {value}, but has to be a finite number, zero or positive")]
    Negative {
        /// The name of the parameter.
        parameter: &'static str,
        /// What was found.
        value: f64,
    },
    /// A coordinate is infinite or not a number.
    #[error("{parameter} has the component {value} on axis {axis}, which is not a finite number")]
    NotFinite {
        /// The name of the vector.
        parameter: &'static str,
        /// The axis, from 0.
        axis: usize,
        /// What was found.
        value: f64,
    },
    /// The inward normal has no direction.
    #[error("inward normal is zero, so it has no direction")]
    NoNormal,
    /// Without preload this law has no finite positive slope, so the contact has no stiffness.
    #[error(
        "without preload the law's slope is {slope}, so the contact has no stiffness: \
         give it a positive preload"
    )]
    NoStiffness {
        /// `f'(0)`.
        slope: f64,
    },
}

/// `value`, if it is positive and finite.
pub(crate) fn positive(parameter: &'static str, value: f64) -> Result<f64, ContactError> {
    if value > 0.0 && value.is_finite() {
        return Ok(value);
    }
    Err(ContactError::NotPositive { parameter, value })
}

/// `value`, if it is finite and not negative.
pub(crate) fn not_negative(parameter: &'static str, value: f64) -> Result<f64, ContactError> {
    if value >= 0.0 && value.is_finite() {
        return Ok(value);
    }
    Err(ContactError::Negative { parameter, value })
}
