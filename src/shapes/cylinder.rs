//! The canonical cylinder: radius 1 about the z axis, from z = 0 to z = 1, with both caps.

use glam::{DVec2, DVec3, Vec3A};

use crate::math::{Aabb, Lanes, Lanes3, Ray, UNIT_ROUNDOFF};

use super::SurfacePoint;
use super::ball::Approach;

/// The cylinder. It has no parameters: its object's transform gives it a place and a form.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Cylinder;

/// The parts of a cylinder, as hits number them.
impl Cylinder {
    /// The round side.
    pub const SIDE: u32 = 0;
    /// The cap at z = 0.
    pub const BOTTOM: u32 = 1;
    /// The cap at z = 1.
    pub const TOP: u32 = 2;

    /// The parameters, and the parts, at which a line enters and leaves the cylinder.
    ///
    /// The solid is the round column cut by the slab between the caps; the line is inside of it
    /// where it is inside of both. So side and caps meet without a gap, whatever is rounded.
    #[inline]
    #[must_use]
    pub fn crossing(ray: &Ray) -> Option<[(f32, u32); 2]> {
        let (column_in, column_out) = column(ray)?;
        let ((slab_in, cap_in), (slab_out, cap_out)) = slab(ray)?;
        let enter = if column_in >= slab_in { (column_in, Self::SIDE) } else { (slab_in, cap_in) };
        let leave =
            if column_out <= slab_out { (column_out, Self::SIDE) } else { (slab_out, cap_out) };
        (enter.0 <= leave.0).then_some([enter, leave])
    }

    /// The box around the cylinder.
    #[must_use]
    pub fn bounds() -> Aabb {
        Aabb { min: Vec3A::new(-1.0, -1.0, 0.0), max: Vec3A::ONE }
    }

    /// The point of a part of the surface that is nearest to the ray's point at `t`.
    #[must_use]
    pub fn surface_point(ray: &Ray, t: f32, part: u32) -> SurfacePoint {
        let p = ray.origin.as_dvec3() + f64::from(t) * ray.dir.as_dvec3();
        let (position, normal) = match part {
            Self::SIDE => {
                let radial = p.truncate().normalize_or(DVec2::X);
                (radial.extend(p.z), radial.extend(0.0))
            }
            Self::BOTTOM => (p.with_z(0.0), DVec3::NEG_Z),
            _ => (p.with_z(1.0), DVec3::Z),
        };
        // As for the ball, with radius 1.
        SurfacePoint { position, normal, clearance: 16.0 * UNIT_ROUNDOFF }
    }
}

/// How a line comes by the column x² + y² ≤ 1: the ball's formula in the plane.
#[inline(always)]
pub(super) fn approach_column<L: Lanes>(origin: Lanes3<L>, dir: Lanes3<L>) -> Approach<L> {
    let (zero, one) = (L::splat(0.0), L::splat(1.0));
    let to_axis = [zero - origin[0], zero - origin[1], zero];
    Approach::new(to_axis, [dir[0], dir[1], zero], one)
}

/// Where a line is inside the endless column.
#[inline]
fn column(ray: &Ray) -> Option<(f32, f32)> {
    let line = approach_column(ray.origin.to_array(), ray.dir.to_array());
    if line.a == 0.0 {
        return (line.c <= 0.0).then_some((f32::NEG_INFINITY, f32::INFINITY));
    }
    let (t0, t1) = line.roots_if_met()?;
    Some(if t0 <= t1 { (t0, t1) } else { (t1, t0) })
}

/// Where a line is between the planes z = 0 and z = 1, and which of them it crosses.
#[inline]
fn slab(ray: &Ray) -> Option<((f32, u32), (f32, u32))> {
    let (z, dz) = (ray.origin.z, ray.dir.z);
    if dz == 0.0 {
        let inside = (0.0..=1.0).contains(&z);
        return inside
            .then_some(((f32::NEG_INFINITY, Cylinder::BOTTOM), (f32::INFINITY, Cylinder::TOP)));
    }
    let bottom = ((0.0 - z) / dz, Cylinder::BOTTOM);
    let top = ((1.0 - z) / dz, Cylinder::TOP);
    Some(if dz > 0.0 { (bottom, top) } else { (top, bottom) })
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::Vec3;

    #[test]
    fn lines_cross_side_and_caps_where_they_should() {
        let across = Ray::new(Vec3::new(-3.0, 0.0, 0.5), Vec3::X);
        assert_eq!(
            Cylinder::crossing(&across),
            Some([(2.0, Cylinder::SIDE), (4.0, Cylinder::SIDE)])
        );
        let along = Ray::new(Vec3::new(0.5, 0.5, 3.0), -Vec3::Z);
        assert_eq!(
            Cylinder::crossing(&along),
            Some([(2.0, Cylinder::TOP), (3.0, Cylinder::BOTTOM)])
        );
        let slanted = Ray::new(Vec3::new(-2.0, 0.0, 0.5), Vec3::new(1.0, 0.0, 0.25));
        let [enter, leave] = Cylinder::crossing(&slanted).unwrap();
        assert_eq!((enter, leave), ((1.0, Cylinder::SIDE), (2.0, Cylinder::TOP)));
    }

    #[test]
    fn lines_beside_above_and_parallel_miss() {
        for (o, d) in [
            ([-3.0, 1.5, 0.5], [1.0, 0.0, 0.0]),
            ([-3.0, 0.0, 1.5], [1.0, 0.0, 0.0]),
            ([1.5, 0.0, 3.0], [0.0, 0.0, -1.0]),
        ] {
            assert_eq!(Cylinder::crossing(&Ray::new(o.into(), d.into())), None, "{o:?}");
        }
    }

    #[test]
    fn rim_rays_have_no_gap_between_side_and_cap() {
        // Towards points on the upper rim from many directions outside: all must enter.
        for i in 0..2000 {
            let angle = i as f32 * 0.003;
            let rim = Vec3::new(0.999_999 * angle.cos(), 0.999_999 * angle.sin(), 0.999_999);
            let origin = 5.0 * Vec3::new(angle.cos(), angle.sin(), 1.0);
            assert!(Cylinder::crossing(&Ray::new(origin, rim - origin)).is_some());
        }
    }

    #[test]
    fn surface_points_lie_on_their_part() {
        let ray = Ray::new(Vec3::new(-3.0, 0.3, 0.5), Vec3::X);
        let [(t, part), _] = Cylinder::crossing(&ray).unwrap();
        let p = Cylinder::surface_point(&ray, t, part);
        assert!((p.position.truncate().length() - 1.0).abs() < 1e-12);
        assert!(p.normal.x < -0.9);
    }
}
