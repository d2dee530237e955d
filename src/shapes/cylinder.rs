//! The canonical cylinder: radius 1 about the z axis, from z = 0 to z = 1, with both caps.

use glam::{DVec2, DVec3, Vec3A};

use crate::math::{Aabb, Hit, Lanes, Lanes3, Mask as _, Ray, UNIT_ROUNDOFF};
use crate::simd::Simd;

use super::SurfacePoint;
use super::ball::{Approach, in_order, met};
use super::ray_group::RayGroup;
use super::single_shape::{Found, SingleShape, hit_of_part};

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
}

impl SingleShape for Cylinder {
    const NAME: &'static str = "cylinder";

    fn bounds(&self) -> Aabb {
        Aabb { min: Vec3A::new(-1.0, -1.0, 0.0), max: Vec3A::ONE }
    }

    #[inline]
    fn offer_hits(&self, ray: &Ray, mut take: impl FnMut(Hit) -> bool) {
        let Some([enter, leave]) = Self::crossing(ray) else { return };
        let _ = take(hit_of_part(enter.0, enter.1)) || take(hit_of_part(leave.0, leave.1));
    }

    #[inline(always)]
    fn first_hits<S: Simd>(&self, rays: &RayGroup<S>) -> Found<S::F16> {
        let (zero, one) = (S::F16::splat(0.0), S::F16::splat(1.0));
        let (before, behind) = (S::F16::splat(f32::NEG_INFINITY), S::F16::splat(f32::INFINITY));
        // The column; for lines along the axis it is everywhere or nowhere.
        let line = approach_column(rays.origin, rays.dir);
        let (column_in, column_out) = in_order::<S>(line.roots());
        let along = line.a.le(zero).bits();
        let column_in = before.select(along, column_in);
        let column_out = behind.select(along, column_out);
        let in_column = (met::<S>(&line) & !along) | (line.c.le(zero).bits() & along);
        // The slab between the caps; for lines across it is everywhere or nowhere.
        let (z, dz) = (rays.origin[2], rays.dir[2]);
        let (bottom, top) = ((zero - z) / dz, (one - z) / dz);
        let across = dz.abs().le(zero).bits();
        let down = dz.le(zero).bits();
        let slab_in = before.select(across, top.select(down, bottom));
        let slab_out = behind.select(across, bottom.select(down, top));
        let in_slab = !across | (zero.le(z) & z.le(one)).bits();
        // The solid is where both are.
        let side_in = slab_in.le(column_in).bits();
        let side_out = column_out.le(slab_out).bits();
        let enter = column_in.select(side_in, slab_in);
        let leave = column_out.select(side_out, slab_out);
        let first = rays.accepts(enter);
        let hit = first | rays.accepts(leave);
        let lanes = hit & in_column & in_slab & enter.le(leave).bits();
        // Upwards a line enters by the bottom and leaves by the top.
        let cap = (first & !side_in) | (!first & !side_out);
        let at_bottom = cap & (first ^ down);
        Found {
            t: enter.select(first, leave),
            u: zero,
            v: zero,
            lanes,
            part: [at_bottom, cap & !at_bottom],
        }
    }

    /// The point of the part that is nearest to the ray's point at the hit's parameter.
    fn surface_point(&self, ray: &Ray, hit: &Hit) -> SurfacePoint {
        let p = ray.origin.as_dvec3() + f64::from(hit.t) * ray.dir.as_dvec3();
        let (position, normal) = match hit.prim {
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
    use glam::Vec3;

    use super::*;
    use crate::shapes::Single;
    use crate::shapes::single_many::tests::assert_same_bits;

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
        let p = Cylinder.surface_point(&ray, &hit_of_part(t, part));
        assert!((p.position.truncate().length() - 1.0).abs() < 1e-12);
        assert!(p.normal.x < -0.9);
    }

    #[test]
    fn sixteen_rays_find_what_each_of_them_finds() {
        assert_same_bits(&Single::Cylinder(Cylinder));
    }
}
