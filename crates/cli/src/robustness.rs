//! How the measures of a grasp change with its contacts, and the worst within their tolerances.

use clench::contact::{Change, Contact, ContactError, Curvature, Geometry, Order};
use clench::metrics::{Freedom, Gain, MetricsError, Sensitivity, Variation};
use clench::screw::{Stiffness, Vector};
use clench::shape::Extent;
use clench::stiffness::Grasp;

use crate::held::principal;
use crate::input::{FileGrasp, Tolerance};
use crate::metrics::Metrics;

/// The number of things that change at a contact: its place, its stiffness and its preload.
const CHANGES: usize = 3;

/// How the measures change with the contacts of a grasp.
#[derive(Clone, Debug)]
pub(crate) struct Robustness<const N: usize> {
    /// Unit directions along the boundary at each contact, one in the plane, two in space.
    pub(crate) directions: Vec<Vec<Vector<N>>>,
    /// Those of the file, if it has any.
    pub(crate) tolerances: Option<Vec<Tolerance>>,
    pub(crate) quality: Robust<N>,
    pub(crate) rotational: Robust<N>,
    pub(crate) worst_point: Robust<N>,
}

/// How one measure changes, or why it has no derivative.
pub(crate) type Robust<const N: usize> = Result<Measure<N>, MetricsError>;

/// How one measure changes.
#[derive(Clone, Debug)]
pub(crate) struct Measure<const N: usize> {
    /// Whether its derivatives are those of a smooth function.
    pub(crate) smooth: bool,
    /// By each contact.
    pub(crate) slopes: Vec<Slopes>,
    /// With all tolerances at once.
    pub(crate) worst: Option<Worst<N>>,
    /// The move of one finger that gains most, if any does.
    pub(crate) gain: Option<Move<N>>,
}

/// How a measure changes with one contact.
#[derive(Clone, Debug)]
pub(crate) struct Slopes {
    /// Per length, along each direction.
    pub(crate) placement: Vec<Slope>,
    /// Per relative change.
    pub(crate) stiffness: Slope,
    /// Per relative change.
    pub(crate) preload: Slope,
}

/// Derivatives along a change and against it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Slope {
    pub(crate) along: f64,
    pub(crate) against: f64,
}

/// The worst case within the tolerances.
#[derive(Clone, Debug)]
pub(crate) struct Worst<const N: usize> {
    /// By the derivatives.
    pub(crate) linear: f64,
    /// By the grasp with its contacts there; none if they do not hold the part.
    pub(crate) anew: Option<f64>,
    pub(crate) contacts: Vec<Displaced<N>>,
}

/// A contact at the worst of its tolerances.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Displaced<const N: usize> {
    pub(crate) point: Vector<N>,
    /// From the point of the file, before the boundary takes it.
    step: Vector<N>,
    pub(crate) stiffness_factor: f64,
    pub(crate) preload_factor: f64,
}

/// A move of one finger along the boundary.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Move<const N: usize> {
    pub(crate) contact: usize,
    pub(crate) direction: Vector<N>,
    /// What the measure gains per length.
    pub(crate) gain: f64,
}

/// A grasp, and what its measures are formed with.
struct Scene<'a, const N: usize, const M: usize> {
    found: &'a FileGrasp<N, M>,
    body: Extent<'a, N>,
    order: Order,
    directions: &'a [Vec<Vector<N>>],
}

impl<const N: usize> Robustness<N> {
    /// That of the grasp `found`, whose `metrics` are of this `order`; `None` if a contact cannot
    /// move.
    pub(crate) fn of<const M: usize>(
        found: &FileGrasp<N, M>,
        metrics: &Metrics<N, M>,
        body: Extent<'_, N>,
        order: Order,
    ) -> Option<Self> {
        let contacts = found.grasp.contacts().iter();
        let directions: Vec<_> = contacts.map(|contact| contact.overlap().tangents()).collect();
        let scene = Scene { found, body, order, directions: &directions };
        let Metrics { principal, quality, softest, worst } = metrics;
        let origin = Sensitivity::of_translation(principal).origin();
        let freedoms = scene.freedoms(origin).ok()?;
        let measure = |sensitivity: Result<Sensitivity<N, M>, MetricsError>, read: Read<N, M>| {
            scene.measure(&sensitivity?, &freedoms, read(metrics), read)
        };
        let of_quality = Sensitivity::of_quality(principal, quality, body);
        let of_least = Sensitivity::of_least(principal, softest, body);
        let of_worst_point = Sensitivity::of_worst_point(principal, worst, body);
        Some(Self {
            quality: measure(of_quality, |metrics| metrics.quality.value),
            rotational: measure(of_least, |metrics| metrics.softest.value),
            worst_point: measure(of_worst_point, |metrics| metrics.worst.stiffness),
            tolerances: found.tolerances.clone(),
            directions,
        })
    }
}

/// One of the measures.
type Read<const N: usize, const M: usize> = fn(&Metrics<N, M>) -> f64;

impl<const N: usize, const M: usize> Scene<'_, N, M> {
    /// What can change at each contact, [`CHANGES`] for each: place, stiffness and preload.
    fn freedoms(&self, origin: Vector<N>) -> Result<Vec<Freedom<N, M>>, ContactError> {
        let mut freedoms = Vec::new();
        for (contact, directions) in self.found.grasp.contacts().iter().zip(self.directions) {
            let rate = |change: Change<N>| contact.stiffness_rate(&change, origin, self.order);
            let along = |&direction: &Vector<N>| rate(self.moved_along(contact, direction));
            let places = directions.iter().map(along).collect::<Result<Vec<_>, _>>()?;
            freedoms.extend([
                match places[..] {
                    [one, other] => Freedom::Plane([one, other]),
                    _ => Freedom::Line(places[0]),
                },
                Freedom::Line(rate(Change::Stiffness)?),
                Freedom::Line(rate(Change::Preload)? * contact.preload()),
            ]);
        }
        Ok(freedoms)
    }

    fn measure(
        &self,
        sensitivity: &Sensitivity<N, M>,
        freedoms: &[Freedom<N, M>],
        value: f64,
        read: Read<N, M>,
    ) -> Robust<N> {
        let slopes: Vec<Slopes> =
            freedoms.chunks(CHANGES).map(|freedoms| Slopes::of(sensitivity, freedoms)).collect();
        if !slopes.iter().flat_map(Slopes::all).all(f64::is_finite) {
            return Err(MetricsError::OutOfRange { stiffness: value, deflection: f64::INFINITY });
        }
        let places: Vec<Freedom<N, M>> = freedoms.iter().step_by(CHANGES).copied().collect();
        let gain = sensitivity.best_gain(&places);
        let tolerances = self.found.tolerances.as_deref();
        let worst = tolerances.map(|tolerances| {
            let variations = variations(freedoms, tolerances);
            let worst = sensitivity.worst_case(&variations);
            let contacts = self.displaced(&worst.steps);
            let anew = self.anew(&contacts).map(|metrics| read(&metrics));
            Worst { linear: value + worst.change, anew, contacts }
        });
        Ok(Measure {
            smooth: sensitivity.is_smooth(),
            slopes,
            worst,
            gain: gain.map(|gain| self.along(&gain)),
        })
    }

    fn along(&self, gain: &Gain) -> Move<N> {
        let direction = self.step(gain.freedom, gain.steepest.step);
        Move { contact: gain.freedom, direction, gain: gain.steepest.rate }
    }

    /// A step of contact number `contact` along its directions.
    fn step(&self, contact: usize, step: [f64; 2]) -> Vector<N> {
        let along = self.directions[contact].iter().zip(step);
        along.fold(Vector::ZERO, |sum, (&direction, size)| sum + direction * size)
    }

    /// The contacts after steps of all that can change.
    fn displaced(&self, steps: &[[f64; 2]]) -> Vec<Displaced<N>> {
        let contacts = self.found.grasp.contacts().iter().zip(steps.chunks(CHANGES)).enumerate();
        let displaced = |(i, (contact, steps)): (usize, (&Contact<N, M>, &[[f64; 2]]))| {
            let step = self.step(i, steps[0]);
            let point = self.moved(contact.overlap().geometry(), step).point;
            let (stiffness_factor, preload_factor) = (1.0 + steps[1][0], 1.0 + steps[2][0]);
            Displaced { point, step, stiffness_factor, preload_factor }
        };
        contacts.map(displaced).collect()
    }

    /// The metrics of the grasp by other contacts, if they hold the part.
    fn anew(&self, displaced: &[Displaced<N>]) -> Option<Metrics<N, M>> {
        let made = |(contact, place): (&Contact<N, M>, &Displaced<N>)| {
            let geometry = self.moved(contact.overlap().geometry(), place.step);
            let law = contact.law().scaled(place.stiffness_factor)?;
            Contact::new(geometry, law, contact.preload() * place.preload_factor)
        };
        let grasp = &self.found.grasp;
        let contacts = grasp.contacts().iter().zip(displaced).map(made);
        let contacts = contacts.collect::<Result<Vec<_>, _>>().ok()?;
        let grasp = Grasp::new(contacts).ok()?.with_loads(grasp.loads().to_vec()).ok()?;
        Metrics::of(principal(&grasp, self.order).ok()?, self.body).ok()
    }

    /// The place after a step along the boundary.
    fn moved(&self, geometry: &Geometry<N>, step: Vector<N>) -> Geometry<N> {
        let point = geometry.point + step;
        let Some(body) = &self.found.smooth else { return Geometry { point, ..*geometry } };
        let at = body.nearest(point).boundary;
        let part = Curvature::of_shape_operator(at.shape_operator);
        Geometry { point: at.point, inward_normal: at.inward_normal, part, ..*geometry }
    }

    /// What changes when a contact moves along the boundary.
    fn moved_along(&self, contact: &Contact<N, M>, along: Vector<N>) -> Change<N> {
        let Some(body) = &self.found.smooth else { return Change::along(along) };
        let at = body.nearest(contact.overlap().point()).boundary;
        Change::Place { along, curvature_rate: body.shape_operator_rate(&at, along) }
    }
}

fn variations<const N: usize, const M: usize>(
    freedoms: &[Freedom<N, M>],
    tolerances: &[Tolerance],
) -> Vec<Variation<N, M>> {
    let each = |tolerance: &Tolerance| {
        let Tolerance { placement, stiffness, preload } = *tolerance;
        [placement, stiffness, preload]
    };
    let sizes = tolerances.iter().flat_map(each);
    let variation = |(&freedom, tolerance)| Variation { freedom, tolerance };
    freedoms.iter().zip(sizes).map(variation).collect()
}

impl Slopes {
    /// Those by a contact whose place, stiffness and preload are `freedoms`.
    fn of<const N: usize, const M: usize>(
        sensitivity: &Sensitivity<N, M>,
        freedoms: &[Freedom<N, M>],
    ) -> Self {
        let slope = |rate: &Stiffness<N, M>| Slope {
            along: sensitivity.along(rate),
            against: sensitivity.along(&(*rate * -1.0)),
        };
        let mut slopes = freedoms.iter().map(|freedom| match freedom {
            Freedom::Line(rate) => vec![slope(rate)],
            Freedom::Plane(rates) => rates.iter().map(slope).collect(),
        });
        let none = || vec![Slope { along: f64::NAN, against: f64::NAN }];
        let mut next = || slopes.next().unwrap_or_else(none);
        Self { placement: next(), stiffness: next()[0], preload: next()[0] }
    }

    /// All its numbers.
    fn all(&self) -> impl Iterator<Item = f64> {
        let slopes = self.placement.iter().chain([&self.stiffness, &self.preload]);
        slopes.flat_map(|slope| [slope.along, slope.against])
    }
}
