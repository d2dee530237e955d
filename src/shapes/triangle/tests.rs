use super::*;
use crate::math::Random;
use crate::shapes::Single;
use crate::shapes::single_many::tests::assert_same_bits;

fn hit(origin: [f32; 3], dir: [f32; 3], t: &Triangle) -> Option<(f32, f32, f32)> {
    t.intersect(&Ray::new(origin.into(), dir.into()))
}

#[test]
fn a_hit_has_the_parameter_and_weights_of_its_point() {
    let t = Triangle::new([Vec3::ZERO, Vec3::X, Vec3::Y]);
    for (z, dz) in [(2.0, -1.0), (-2.0, 1.0)] {
        let (time, u, v) = hit([0.25, 0.5, z], [0.0, 0.0, dz], &t).unwrap();
        assert_eq!((time, u, v), (2.0, 0.25, 0.5), "both sides are hit alike");
    }
    assert!(hit([0.75, 0.5, 2.0], [0.0, 0.0, -1.0], &t).is_none());
}

#[test]
fn edges_and_corners_belong_to_the_triangle() {
    let t = Triangle::new([Vec3::ZERO, Vec3::X, Vec3::Y]);
    for p in [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [0.5, 0.5], [0.5, 0.0], [0.0, 0.5]] {
        assert!(hit([p[0], p[1], 1.0], [0.0, 0.0, -1.0], &t).is_some(), "{p:?}");
    }
}

#[test]
fn a_degenerate_triangle_has_no_finite_parameter() {
    let t = Triangle::new([Vec3::ZERO, Vec3::X, Vec3::X]);
    assert_eq!(hit([0.5, 0.0, 1.0], [0.0, 0.0, -1.0], &t), None);
}

#[test]
fn one_triangle_and_four_lanes_give_the_same_bits() {
    let mut random = Random::new(&[17]);
    let mut point = || Vec3::from_array(std::array::from_fn(|_| random.next_f32() - 0.5));
    let mut hits = 0;
    for _ in 0..20_000 {
        let t = Triangle::new([point(), point(), point()]);
        let origin = 4.0 * point();
        let ray = Ray::new(origin, point() - origin);
        let of_triangles = TriangleRay::from(&ray);
        let corners = t
            .corners
            .map(|corner| of_triangles.axes().arrange(&corner.to_array()).map(glam::Vec4::splat));
        let h = scaled_hit(&of_triangles.splat::<glam::Vec4>(), corners);
        let inside = h.inside.bits() >> 3 & 1 != 0;
        let time = h.t[3] / h.scale[3];
        let lanes = (inside && (0.0..=f32::MAX).contains(&time))
            .then(|| (time, h.u[3] / h.scale[3], h.v[3] / h.scale[3]));
        let bits =
            |h: Option<(f32, f32, f32)>| h.map(|(t, u, v)| [t.to_bits(), u.to_bits(), v.to_bits()]);
        assert_eq!(bits(t.intersect(&ray)), bits(lanes));
        hits += u32::from(lanes.is_some());
    }
    assert!(hits > 100, "{hits}");
}

#[test]
fn every_ray_in_a_fan_around_a_corner_is_in_one_of_its_triangles() {
    let mut random = Random::new(&[41]);
    let mut hits = [0; 4];
    for number in 0..40_000u32 {
        let scale = [1.0, 1e-6, 1e6, 1e-3][number as usize % 4];
        let mut point = || Vec3::from_array(std::array::from_fn(|_| random.next_f32() - 0.5));
        let (hub, origin) = (scale * point(), 10.0 * scale * point());
        // Corners around the hub as the ray sees it: what they enclose contains the hub.
        let dir = (hub - origin).normalize();
        let across = dir.any_orthonormal_vector();
        let up = dir.cross(across);
        let rim: [Vec3; 5] = std::array::from_fn(|i| {
            let (sin, cos) = (std::f32::consts::TAU * (i as f32 / 5.0)).sin_cos();
            hub + scale * (cos * across + sin * up + 0.5 * point())
        });
        let to = if number % 3 == 0 { hub } else { hub.lerp(rim[0], 0.3 * random.next_f32()) };
        let ray = Ray::new(origin, to - origin);
        let count = (0..5)
            .filter(|&i| Triangle::new([hub, rim[i], rim[(i + 1) % 5]]).intersect(&ray).is_some())
            .count();
        assert!(count > 0, "{ray:?} gets through a corner at {hub}");
        hits[count.min(3)] += 1;
    }
    assert!(hits[1] > 0 && hits[2] > 0, "on edges, too: {hits:?}");
}

#[test]
fn a_triangle_whose_area_is_rounded_to_nothing_is_hit_if_it_contains_the_ray() {
    let mut random = Random::new(&[43]);
    let (mut inside, mut beside) = (0, 0);
    for _ in 0..100_000 {
        // Nearly on a line through the ray, on both sides of it.
        let mut near = |size: f32| size * (1.0 + random.below(6) as f32 * f32::EPSILON);
        let corners = [[near(1.0), near(1.0)], [near(-1.0), near(-1.0)], [near(0.75), near(0.75)]];
        let triangle = Triangle::new(corners.map(|[x, y]| Vec3::new(x, y, 2.0)));
        let ray = Ray::new(Vec3::ZERO, Vec3::Z);
        let corners = triangle.corners.map(|corner| corner.to_array());
        let hit = scaled_hit(&TriangleRay::from(&ray).splat::<f32>(), corners);
        if hit.flat() == 0 {
            continue;
        }
        let [a, b, c] = triangle.corners.map(|corner| corner.as_dvec3().truncate());
        let sides = [a.perp_dot(b), b.perp_dot(c), c.perp_dot(a)];
        let area: f64 = sides.iter().sum();
        let contains = area != 0.0 && sides.iter().all(|side| side * area >= 0.0);
        let hit = triangle.intersect(&ray);
        assert_eq!(hit.is_some(), contains, "{triangle:?}");
        if let Some((t, u, v)) = hit {
            assert!(t == 2.0 && u >= 0.0 && v >= 0.0 && u + v <= 1.0, "{t} {u} {v}");
            inside += 1;
        } else {
            beside += 1;
        }
    }
    assert!(inside > 100 && beside > 100, "{inside} {beside}");
}

/// Triangles of all kinds with boxes that cut them: far from the origin, slivers, flat; planes
/// anywhere, through a corner, or next to an edge that nearly lies in them.
fn cut_triangles() -> impl Iterator<Item = (Triangle, Aabb, Random)> {
    let mut random = Random::new(&[29]);
    (0..4_000u32).map(move |number| {
        let mut point = || Vec3::from_array(std::array::from_fn(|_| random.next_f32() - 0.5));
        let [a, mut b, mut c] = [point(), point(), point()];
        match number % 4 {
            0 => c = a + 1.000_001 * (b - a),
            1 => b.z = a.z.next_up(),
            2 => (b.x, c.x) = (a.x, a.x),
            _ => {}
        }
        let far = [0.0, 1.0, 1e4][number as usize / 4 % 3];
        let corners = [a, b, c].map(|corner| corner + Vec3::new(far, -far, 0.5 * far));
        let triangle = Triangle::new(corners);
        let mut to = Aabb::of_points([point(), point()].map(|p| Vec3A::from(p + corners[0])));
        if number % 5 < 3 {
            let axis = number as usize % 5;
            to.max[axis] = corners[1][axis].max(to.min[axis]);
        }
        (triangle, to, random.clone())
    })
}

#[test]
fn the_box_of_a_part_holds_every_point_of_it_and_no_more_than_both_boxes() {
    let (mut inside, mut smaller) = (0, 0);
    for (triangle, to, mut random) in cut_triangles() {
        let (own, part) = (triangle.bounds(), triangle.clipped_bounds(&to));
        let default = own.intersection(to);
        assert_eq!(part.union(default), default);
        smaller += u32::from(part != default);
        let corners = triangle.corners.map(|corner| Vec3A::from(corner).as_dvec3());
        for _ in 0..50 {
            let [u, v] = random.next_pair().map(f64::from);
            let (u, v) = if u + v > 1.0 { (1.0 - u, 1.0 - v) } else { (u, v) };
            let point = corners[0] * (1.0 - u - v) + corners[1] * u + corners[2] * v;
            // Its own rounding does not count.
            let point = point.clamp(own.min.as_dvec3(), own.max.as_dvec3());
            let is_in = |bounds: &Aabb| {
                let [min, max] = [bounds.min, bounds.max].map(Vec3A::as_dvec3);
                min.cmple(point).all() && point.cmple(max).all()
            };
            if is_in(&to) {
                inside += 1;
                assert!(is_in(&part), "{triangle:?} in {to:?}: {point} is not in {part:?}");
            }
        }
    }
    assert!(inside > 10_000 && smaller > 500, "{inside} {smaller}");
}

#[test]
fn the_boxes_of_two_parts_cover_that_of_the_whole() {
    for (triangle, to, _) in cut_triangles() {
        let own = triangle.bounds();
        for (axis, plane) in [(0, to.max.x), (1, to.max.y), (2, to.min.z)] {
            let plane = plane.clamp(own.min[axis], own.max[axis]);
            let (mut below, mut above) = (own, own);
            below.max[axis] = plane;
            above.min[axis] = plane;
            let parts = [below, above].map(|half| triangle.clipped_bounds(&half));
            assert_eq!(parts[0].union(parts[1]), own, "{triangle:?} at {plane}");
        }
    }
}

#[test]
fn the_box_of_a_part_is_tight() {
    // In the plane x = y: what lies left of x = 0.25 lies below y = 0.25.
    let triangle = Triangle::new([Vec3::ZERO, Vec3::ONE, Vec3::new(1.0, 1.0, 0.0)]);
    let to = Aabb { min: Vec3A::splat(-1.0), max: Vec3A::new(0.25, 2.0, 2.0) };
    let part = triangle.clipped_bounds(&to);
    assert_eq!((part.min, part.max.x), (Vec3A::ZERO, 0.25));
    assert!((part.max - Vec3A::splat(0.25)).abs().max_element() < 1e-7, "{part:?}");
    // A box that only the triangle's box touches.
    let corner = Aabb { min: Vec3A::new(0.0, 0.5, 0.0), max: Vec3A::new(0.25, 1.0, 1.0) };
    assert_eq!(triangle.clipped_bounds(&corner), Aabb::EMPTY);
}

#[test]
fn a_part_as_thin_as_a_line_is_not_lost() {
    // In the plane x = y: where x is at least m and y at most m, a line is left.
    for (n, m) in (2..60u16).flat_map(|n| (1..n).map(move |m| (f32::from(n), f32::from(m)))) {
        let corners = [Vec3::ZERO, Vec3::new(n, n, 0.0), Vec3::splat(n)];
        let to = Aabb { min: Vec3A::new(m, 0.0, 0.0), max: Vec3A::new(n, m, n) };
        let part = Triangle::new(corners).clipped_bounds(&to);
        let line = Aabb { min: Vec3A::new(m, m, 0.0), max: Vec3A::splat(m) };
        assert_eq!(part.union(line), part, "{m} of {n}");
    }
}

#[test]
fn the_surface_point_lies_in_the_plane_and_its_clearance_is_tiny() {
    let t = Triangle::new([Vec3::ONE, Vec3::new(4.0, 2.0, 0.0), Vec3::new(0.0, 5.0, 3.0)]);
    let p = t.surface_point(0.3, 0.2);
    let plane_distance = (p.position - t.corners[0].as_dvec3()).dot(p.normal.normalize());
    assert!(plane_distance.abs() < 1e-12);
    assert!(p.clearance > 0.0 && p.clearance < 1e-4);
}

#[test]
fn sixteen_rays_find_what_each_of_them_finds() {
    let corners = [Vec3::new(-2.0, -1.0, 0.0), Vec3::X, Vec3::splat(1.5)];
    assert_same_bits(&Single::Triangle(Triangle::new(corners)));
}
