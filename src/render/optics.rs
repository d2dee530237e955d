//! Mirror reflection and refraction: directions, and the share of light that is reflected.

use glam::Vec3;

/// The mirror direction of a direction `dir` at a surface with unit normal `normal`.
#[inline]
pub(super) fn mirror(dir: Vec3, normal: Vec3) -> Vec3 {
    dir - 2.0 * dir.dot(normal) * normal
}

/// Light at the border of two transparent media.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Refraction {
    /// The share that is reflected, from 0 to 1: the rest goes through.
    pub(super) reflected: f32,
    /// The direction behind the border; `None` where all is reflected.
    pub(super) dir: Option<Vec3>,
}

/// Snell's law and Fresnel's equations for unpolarised light (Born, Wolf: *Principles of Optics*,
/// section 1.5).
///
/// `dir` is a unit vector towards the surface, `normal` its unit normal on the side that `dir`
/// comes from; `eta` is the index of refraction on that side divided by that on the other.
pub(super) fn refract(dir: Vec3, normal: Vec3, eta: f32) -> Refraction {
    if eta == 1.0 {
        return Refraction { reflected: 0.0, dir: Some(dir) };
    }
    let cos_in = -dir.dot(normal);
    let sin_out_squared = eta * eta * (1.0 - cos_in * cos_in);
    if sin_out_squared >= 1.0 {
        return Refraction { reflected: 1.0, dir: None };
    }
    let cos_out = (1.0 - sin_out_squared).sqrt();
    let perpendicular = (eta * cos_in - cos_out) / (eta * cos_in + cos_out);
    let parallel = (cos_in - eta * cos_out) / (cos_in + eta * cos_out);
    let reflected = 0.5 * (perpendicular * perpendicular + parallel * parallel);
    let dir = eta * dir + (eta * cos_in - cos_out) * normal;
    Refraction { reflected: reflected.clamp(0.0, 1.0), dir: Some(dir) }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at_angle(degrees: f32) -> Vec3 {
        let (sin, cos) = degrees.to_radians().sin_cos();
        Vec3::new(sin, 0.0, -cos)
    }

    #[test]
    fn mirror_angles_are_equal() {
        let out = mirror(at_angle(30.0), Vec3::Z);
        assert!((out - Vec3::new(0.5, 0.0, 0.75f32.sqrt())).length() < 1e-6);
    }

    #[test]
    fn glass_seen_straight_on_reflects_four_percent() {
        let r = refract(-Vec3::Z, Vec3::Z, 1.0 / 1.5);
        assert!((r.reflected - 0.04).abs() < 1e-6);
        assert!((r.dir.unwrap() + Vec3::Z).length() < 1e-6);
    }

    #[test]
    fn refracted_directions_obey_snell() {
        for degrees in [10.0, 40.0, 80.0] {
            let r = refract(at_angle(degrees), Vec3::Z, 1.0 / 1.33);
            let sine = r.dir.unwrap().x;
            assert!((sine * 1.33 - degrees.to_radians().sin()).abs() < 1e-5);
            assert!((r.dir.unwrap().length() - 1.0).abs() < 1e-5);
        }
    }

    #[test]
    fn beyond_the_critical_angle_all_is_reflected() {
        let critical = (1.0f32 / 1.5).asin().to_degrees();
        assert!(refract(at_angle(critical - 0.5), Vec3::Z, 1.5).dir.is_some());
        let beyond = refract(at_angle(critical + 0.5), Vec3::Z, 1.5);
        assert_eq!(beyond, Refraction { reflected: 1.0, dir: None });
    }

    #[test]
    fn at_brewsters_angle_the_parallel_share_vanishes() {
        let brewster = 1.5f32.atan().to_degrees();
        let r = refract(at_angle(brewster), Vec3::Z, 1.0 / 1.5);
        // What is left is half the perpendicular share, ((n² − 1)/(n² + 1))² = (1.25/3.25)².
        assert!((r.reflected - 0.5 * (1.25f32 / 3.25).powi(2)).abs() < 1e-5);
    }

    #[test]
    fn without_a_change_of_index_light_goes_straight_on() {
        let dir = at_angle(70.0);
        assert_eq!(refract(dir, Vec3::Z, 1.0), Refraction { reflected: 0.0, dir: Some(dir) });
    }
}
