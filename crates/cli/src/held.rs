//! Whether a stiffness holds the part: its numbers, or the motion that it does not resist.

use clench::contact::Order;
use clench::metrics::{MetricsError, Principal};
use clench::screw::{Twist, Vector};
use clench::stiffness::{Grasp, Preloads, Stability};

/// A contact is pressed if the part moves towards it by more than this part of its speed: the
/// direction of a motion that little resists is good to half of the digits.
const PRESSES: f64 = 1.490_116_119_384_765_6e-8;

/// How a grasp is stable.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Classes {
    /// With all that preloads, curvatures and loads add.
    pub(crate) grasp: Stability,
    /// The class of the first-order stiffness alone: that of springs in place of the contacts.
    pub(crate) springs: Stability,
}

/// What a stiffness does not resist.
#[derive(Clone, Copy, Debug)]
pub(crate) enum NotHeld {
    /// One motion; or its numbers are none.
    One(MetricsError),
    /// Some motion, by the sign of the stiffness about another point.
    Some,
}

/// The principal stiffnesses of a grasp, formed near the part.
pub(crate) fn principal<const N: usize, const M: usize>(
    grasp: &Grasp<N, M>,
    order: Order,
) -> Result<Principal<N, M>, MetricsError> {
    Principal::near(grasp.centroid(), |origin| grasp.stiffness(origin, order))
}

/// The principal stiffnesses of a grasp whose stiffness to that `order` has the class `stability`.
///
/// Where the lines of action all meet, the rotational stiffness is nothing but rounding, and so is
/// the one about the centroid that it is compared to: the class, which compares it to all that the
/// contacts resist, decides.
pub(crate) fn held<const N: usize, const M: usize>(
    grasp: &Grasp<N, M>,
    order: Order,
    stability: Stability,
) -> Result<Principal<N, M>, NotHeld> {
    let principal = principal(grasp, order).map_err(NotHeld::One)?;
    match stability {
        Stability::FirstOrder | Stability::SecondOrder => Ok(principal),
        Stability::Marginal => Err(NotHeld::One(softest(&principal, grasp.length()))),
        Stability::Unstable => Err(NotHeld::Some),
    }
}

/// The motion of the least principal stiffness, torques divided by `length`.
fn softest<const N: usize, const M: usize>(
    principal: &Principal<N, M>,
    length: f64,
) -> MetricsError {
    let (sigma, mu) = (principal.translational(), principal.rotational());
    let (largest, value) = (sigma.values[N - 1], mu.values[0]);
    let scale = largest * length * length;
    if sigma.values[0] * length * length < value {
        let direction = sigma.vectors[0].in_space();
        return MetricsError::TranslationNotHeld { direction, value: sigma.values[0], largest };
    }
    MetricsError::RotationNotHeld { axis: principal.twist_axes()[0], value, scale }
}

impl Classes {
    /// The classes of `grasp`.
    pub(crate) fn of<const N: usize, const M: usize>(grasp: &Grasp<N, M>) -> Self {
        Self { grasp: grasp.stability(), springs: grasp.first_order_stability() }
    }

    /// The class of the stiffness to this order.
    pub(crate) const fn to_order(self, order: Order) -> Stability {
        match order {
            Order::First => self.springs,
            Order::Second => self.grasp,
        }
    }
}

/// The contacts that nothing presses on the part, if the others do not hold it alone.
#[derive(Clone, Debug)]
pub(crate) struct Slack {
    /// The contacts, and whether it is this preload that does not press them, or any.
    pub(crate) contacts: Vec<usize>,
    pub(crate) at_rest: bool,
    /// What the others do not resist.
    pub(crate) not_held: NotHeld,
}

impl Slack {
    /// The slack contacts of `grasp`, if it matters that they are.
    ///
    /// Its stiffness has them as springs that pull too. With force closure some preload makes them
    /// that; with loads only what presses at rest counts.
    pub(crate) fn of<const N: usize, const M: usize>(
        grasp: &Grasp<N, M>,
        preloads: &Preloads,
        order: Order,
        loaded: bool,
    ) -> Option<Self> {
        let contacts: Vec<usize> = match (preloads.force_closure, loaded) {
            (true, _) => Vec::new(),
            (false, false) => preloads.unopposed.clone(),
            (false, true) => {
                let free = |&i: &usize| grasp.contacts()[i].preload() <= 0.0;
                (0..grasp.contacts().len()).filter(free).collect()
            }
        };
        if contacts.is_empty() {
            return None;
        }
        let rest = grasp.retain(|contact| !contacts.contains(&contact));
        let not_held = match rest {
            Ok(rest) => held(&rest, order, Classes::of(&rest).to_order(order)).err()?,
            Err(_) => NotHeld::Some,
        };
        let caught = matches!(&not_held, NotHeld::One(error) if is_caught(grasp, &contacts, error));
        (!caught).then_some(Self { contacts, at_rest: loaded, not_held })
    }
}

/// Whether a motion, and its reverse too, presses the part on one of these contacts.
fn is_caught<const N: usize, const M: usize>(
    grasp: &Grasp<N, M>,
    contacts: &[usize],
    error: &MetricsError,
) -> bool {
    let Some(motion) = motion(error) else { return false };
    let motion = Twist::<N, M> {
        linear: Vector::from_fn(|i| motion.linear[i]),
        angular: Vector::from_fn(|i| motion.angular[i + 3 - M]),
    };
    let near = motion.velocity_at(grasp.centroid()).norm();
    let speed = near + motion.angular.norm() * grasp.length();
    // Positive for a motion away from the finger.
    let away = |&i: &usize| motion.power(&grasp.contacts()[i].unit_wrench(Vector::ZERO));
    let presses = |sign: f64| contacts.iter().any(|i| sign * away(i) < -PRESSES * speed);
    presses(1.0) && presses(-1.0)
}

/// The motion that a stiffness does not resist, from the frame's origin, in space.
fn motion(error: &MetricsError) -> Option<Twist<3, 3>> {
    match *error {
        MetricsError::TranslationNotHeld { direction, .. } => {
            Some(Twist { linear: direction, angular: Vector::ZERO })
        }
        MetricsError::RotationNotHeld { axis, .. } => Some(axis.twist()),
        _ => None,
    }
}
