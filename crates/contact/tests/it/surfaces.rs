//! Gradient and Hessian against finite differences of curved bodies that are really moved.
//!
//! Both bodies are graphs over their common tangent plane, with third-order terms that must not
//! matter, and the overlap is measured between their deepest points by Newton's method.

use clench_contact::{Contact, Curvature, Geometry, Law};
use clench_screw::{Frame, Mat, Vector, planar, spatial};
use clench_testkit::{Random, assert_all_close, assert_close};

/// The boundary `origin + sum s_i tangent_i + normal h(s)`,
/// `h = s^T L s / 2 + sum c_i s_i^3`.
struct Graph<const N: usize> {
    origin: Vector<N>,
    tangents: Vec<Vector<N>>,
    normal: Vector<N>,
    operator: Vec<Vec<f64>>,
    cubic: Vec<f64>,
}

impl<const N: usize> Graph<N> {
    fn slope(&self, s: &[f64], i: usize) -> f64 {
        let linear: f64 = s.iter().zip(&self.operator[i]).map(|(s, l)| s * l).sum();
        linear + 3.0 * self.cubic[i] * s[i] * s[i]
    }

    fn point(&self, s: &[f64]) -> Vector<N> {
        let height: f64 = (0..s.len())
            .map(|i| {
                let row: f64 = s.iter().zip(&self.operator[i]).map(|(s, l)| s * l).sum();
                0.5 * s[i] * row + self.cubic[i] * s[i].powi(3)
            })
            .sum();
        let flat = s.iter().zip(&self.tangents).fold(self.origin, |p, (s, t)| p + *t * *s);
        flat + self.normal * height
    }

    fn derivative(&self, s: &[f64], i: usize) -> Vector<N> {
        self.tangents[i] + self.normal * self.slope(s, i)
    }

    fn second_derivative(&self, s: &[f64], i: usize, j: usize) -> Vector<N> {
        let cubic = if i == j { 6.0 * self.cubic[i] * s[i] } else { 0.0 };
        self.normal * (self.operator[i][j] + cubic)
    }

    fn moved<const M: usize>(&self, frame: &Frame<N, M>) -> Self {
        Self {
            origin: frame.point_to_parent(self.origin),
            tangents: self.tangents.iter().map(|t| frame.direction_to_parent(*t)).collect(),
            normal: frame.direction_to_parent(self.normal),
            operator: self.operator.clone(),
            cubic: self.cubic.clone(),
        }
    }
}

/// Gaussian elimination with pivots: at most 4 equations.
fn solve(mut a: Vec<Vec<f64>>, mut b: Vec<f64>) -> Vec<f64> {
    let n = b.len();
    for k in 0..n {
        let pivot = (k..n).max_by(|&i, &j| a[i][k].abs().total_cmp(&a[j][k].abs())).unwrap();
        a.swap(k, pivot);
        b.swap(k, pivot);
        for i in k + 1..n {
            let factor = a[i][k] / a[k][k];
            for j in k..n {
                a[i][j] -= factor * a[k][j];
            }
            b[i] -= factor * b[k];
        }
    }
    for k in (0..n).rev() {
        let known: f64 = (k + 1..n).map(|j| a[k][j] * b[j]).sum();
        b[k] = (b[k] - known) / a[k][k];
    }
    b
}

/// `n . (a - b)` at the pair of points where `a - b` is normal to both boundaries: the stationary
/// point of `|a - b|^2 / 2`, which exists for any depth but 0.
fn depth<const N: usize>(a: &Graph<N>, b: &Graph<N>) -> f64 {
    let d = N - 1;
    let mut x = vec![0.0; 2 * d];
    for _ in 0..30 {
        let (s, t) = x.split_at(d);
        let gap = a.point(s) - b.point(t);
        let da: Vec<_> = (0..d).map(|i| a.derivative(s, i)).collect();
        let db: Vec<_> = (0..d).map(|i| b.derivative(t, i)).collect();
        let mut hessian = vec![vec![0.0; 2 * d]; 2 * d];
        let mut gradient = vec![0.0; 2 * d];
        for i in 0..d {
            gradient[i] = gap.dot(da[i]);
            gradient[d + i] = -gap.dot(db[i]);
            for j in 0..d {
                hessian[i][j] = da[i].dot(da[j]) + gap.dot(a.second_derivative(s, i, j));
                hessian[d + i][d + j] = db[i].dot(db[j]) - gap.dot(b.second_derivative(t, i, j));
                hessian[i][d + j] = -da[i].dot(db[j]);
                hessian[d + j][i] = -da[i].dot(db[j]);
            }
        }
        let step = solve(hessian, gradient);
        x.iter_mut().zip(&step).for_each(|(x, s)| *x -= s);
        if step.iter().all(|s| s.abs() < 1e-15) {
            break;
        }
    }
    let (s, t) = x.split_at(d);
    let gap = a.point(s) - b.point(t);
    gap.norm() * gap.dot(b.normal).signum()
}

/// Tangent directions to a unit normal.
fn tangents<const N: usize>(normal: Vector<N>, r: &mut Random) -> Vec<Vector<N>> {
    let mut found: Vec<Vector<N>> = Vec::new();
    while found.len() < N - 1 {
        let mut t: Vector<N> = r.array(1.0).into();
        for known in found.iter().chain([&normal]) {
            t = t - *known * known.dot(t);
        }
        if t.norm() > 0.1 {
            found.push(t * t.norm().recip());
        }
    }
    found
}

/// A symmetric matrix in the tangent plane with eigenvalues between `low` and `high`.
fn operator(r: &mut Random, d: usize, low: f64, high: f64) -> Vec<Vec<f64>> {
    let (p, q, angle) = (r.between(low, high), r.between(low, high), r.between(0.0, 3.0));
    let (s, c) = angle.sin_cos();
    if d == 1 {
        return vec![vec![p]];
    }
    let mixed = (p - q) * s * c;
    vec![vec![p * c * c + q * s * s, mixed], vec![mixed, p * s * s + q * c * c]]
}

fn tensor<const N: usize>(graph: &Graph<N>) -> Mat<N, N> {
    let mut sum = Mat::ZERO;
    for (i, a) in graph.tangents.iter().enumerate() {
        for (j, b) in graph.tangents.iter().enumerate() {
            sum += Mat::outer(*a, *b) * graph.operator[i][j];
        }
    }
    sum
}

type Chart<const N: usize, const M: usize> = fn(&[f64]) -> Frame<N, M>;

/// Which bodies: the ranges of the curvatures of finger and part.
struct Kind {
    finger: [f64; 2],
    part: [f64; 2],
}

fn derivatives_match<const N: usize, const M: usize>(chart: Chart<N, M>, kind: &Kind, seed: u64) {
    let r = &mut Random::new(seed);
    for round in 0..60 {
        let normal: Vector<N> = r.array(1.0).into();
        let normal = normal * normal.norm().recip();
        let point: Vector<N> = r.array(2.0).into();
        let overlap = r.between(0.05, 0.15);
        let side = |r: &mut Random, origin, range: [f64; 2], normal: Vector<N>| Graph {
            origin,
            tangents: tangents(normal, r),
            normal,
            operator: operator(r, N - 1, range[0], range[1]),
            cubic: r.array::<2>(0.3)[..N - 1].to_vec(),
        };
        let part = side(r, point, kind.part, normal);
        let finger = side(r, point + normal * overlap, kind.finger, -normal);
        let place = Geometry {
            point,
            inward_normal: normal,
            finger: Curvature::of_shape_operator(tensor(&finger)),
            part: Curvature::of_shape_operator(tensor(&part)),
        };
        let law = Law::linear(1.0).unwrap();
        let contact = Contact::<N, M>::overlapping(place, law, overlap).unwrap();

        let size = N + M;
        let at = |i: usize, s: f64, j: usize, t: f64| {
            let mut q = vec![0.0; size];
            q[i] += s;
            q[j] += t;
            depth(&finger, &part.moved(&chart(&q)))
        };
        assert_close(at(0, 0.0, 0, 0.0), overlap, 1e-13, 1.0, "depth at rest");
        let gradient = contact.overlap().gradient(Vector::ZERO);
        let found = [gradient.force.to_array().as_slice(), &gradient.torque.to_array()].concat();
        // Central differences: errors of h^2 times third, for the Hessian fourth derivatives,
        // which are of the size of the inverse relative curvatures to that power, below 1e3.
        let h = 1e-5;
        let slopes: Vec<f64> =
            (0..size).map(|i| (at(i, h, i, 0.0) - at(i, -h, i, 0.0)) / (2.0 * h)).collect();
        assert_all_close(&found, &slopes, 1e-7, format!("gradient {round}"));
        let h = 3e-4;
        let hessian = contact.overlap().hessian(Vector::ZERO);
        for i in 0..size {
            for j in 0..size {
                let mixed = at(i, h, j, h) - at(i, h, j, -h) - at(i, -h, j, h) + at(i, -h, j, -h);
                let what = format!("Hessian ({i}, {j}) of contact {round}");
                assert_close(hessian.entry(i, j), mixed / (4.0 * h * h), 1e-4, 1.0, what);
            }
        }

        // The local model of a displacement has these derivatives too.
        let model = |q: &[f64]| contact.overlap().depth_after(&chart(q));
        for i in 0..size {
            let q = |s: f64| {
                let mut q = vec![0.0; size];
                q[i] = s;
                q
            };
            let second = (model(&q(h)) - 2.0 * model(&q(0.0)) + model(&q(-h))) / (h * h);
            assert_close(hessian.entry(i, i), second, 1e-5, 10.0, "model");
        }
    }
}

fn both(kind: &Kind, seed: u64) {
    derivatives_match(|q| planar::Frame::new([q[0], q[1]], q[2]), kind, seed);
    derivatives_match::<3, 3>(
        |q| spatial::Frame::new([q[0], q[1], q[2]], [q[3], q[4], q[5]]),
        kind,
        seed + 1,
    );
}

#[test]
fn two_convex_bodies_roll_as_the_hessian_says() {
    both(&Kind { finger: [0.5, 2.0], part: [0.5, 2.0] }, 41);
}

#[test]
fn a_finger_in_a_hollow_or_on_a_saddle_rolls_as_the_hessian_says() {
    both(&Kind { finger: [1.5, 3.0], part: [-1.0, 1.0] }, 43);
}

#[test]
fn a_hollow_or_nearly_flat_finger_rolls_as_the_hessian_says() {
    both(&Kind { finger: [-1.0, 0.2], part: [1.5, 3.0] }, 45);
}
