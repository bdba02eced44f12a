//! The overlap of a disc with a polygon's edge against an independent geometry library.

use clench_contact::{Contact, Geometry, Law};
use clench_screw::{Vector, planar};
use clench_testkit::{Random, assert_close};
use parry2d_f64::math::{Pose, Vector as Point};
use parry2d_f64::query;
use parry2d_f64::shape::{Ball, ConvexPolygon};

#[test]
fn depth_is_the_penetration_depth_of_the_moved_shapes() {
    // A wide block below y = 0; the disc touches its top edge from above.
    let corners = [[-8.0, -6.0], [8.0, -6.0], [8.0, 0.0], [-8.0, 0.0]];
    let points = corners.map(|[x, y]| Point::new(x, y)).to_vec();
    let block = ConvexPolygon::from_convex_polyline(points).unwrap();
    let r = &mut Random::new(17);
    for _ in 0..200 {
        let point = Vector::new([r.between(-2.0, 2.0), 0.0]);
        let law = Law::linear(1.0).unwrap();
        let (radius, preload) = (r.between(0.3, 1.0), r.between(0.05, 0.2));
        let contact = Contact::<2, 1>::new(
            Geometry::on_face(point, Vector::new([0.0, -1.0]), radius),
            law,
            preload,
        )
        .unwrap();
        let (shift, angle) = (r.array(0.1), r.between(-0.05, 0.05));
        let found = contact.overlap().depth_after(&planar::Frame::new(shift, angle));

        let overlap = contact.overlap();
        let center = overlap.point() - overlap.inward_normal() * (radius - overlap.depth());
        let touching = query::contact(
            &Pose::new(Point::new(shift[0], shift[1]), angle),
            &block,
            &Pose::new(Point::new(center[0], center[1]), 0.0),
            &Ball::new(radius),
            10.0,
        )
        .unwrap()
        .unwrap();
        assert_close(found, -touching.dist, 1e-13, 1.0, "depth");
    }
}
