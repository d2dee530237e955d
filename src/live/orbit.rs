//! The camera as a person moves it: about the point that is looked at, along the picture, nearer and farther.

use glam::{DMat3, DVec3};

use crate::description::Camera;

/// The camera stays this far, in radians, from looking along up or down, where nothing says what is up.
const FROM_THE_POLES: f64 = 0.02;

/// The point that is looked at stays within these multiples of its first distance.
const DISTANCES: [f64; 2] = [1e-4, 1e4];

/// A camera that turns about a point.
#[derive(Clone, Debug)]
pub(super) struct Orbit {
    /// As the scene has it.
    home: Camera,
    /// From its eye to the point that is looked at.
    home_distance: f64,
    /// Where it was moved to; `None` as long as it is at home, so that it is there to the bit.
    pose: Option<Pose>,
}

/// Where a camera is.
#[derive(Clone, Copy, Debug)]
struct Pose {
    eye: DVec3,
    /// Of unit length.
    direction: DVec3,
    /// From the eye to the point that is looked at.
    distance: f64,
}

impl Orbit {
    /// A camera at home, which looks at a point at some distance in its direction.
    pub(super) fn new(home: Camera, distance: f64) -> Self {
        let distance = if distance.is_finite() && distance > 0.0 { distance } else { 1.0 };
        Self { home, home_distance: distance, pose: None }
    }

    /// Whether it is not where the scene has it.
    pub(super) fn is_moved(&self) -> bool {
        self.pose.is_some()
    }

    /// Back to where the scene has it.
    pub(super) fn reset(&mut self) {
        self.pose = None;
    }

    /// The same place, if it was moved, in a scene that was saved again and still has the same camera; its picture may
    /// have another size.
    pub(super) fn carried_to(&self, home: Camera, distance: f64) -> Self {
        let of_size = Camera { width: self.home.width, height: self.home.height, ..home.clone() };
        let pose = self.pose.filter(|_| of_size == self.home);
        Self { pose, ..Self::new(home, distance) }
    }

    /// Turns the scene as if it were taken at the point that is looked at and moved by a part of the picture's height,
    /// to the right and down. A whole height is half a turn.
    pub(super) fn turn(&mut self, [right, down]: [f64; 2]) {
        let mut pose = self.pose();
        let center = pose.center();
        let up = self.home.up.normalize_or_zero();
        let turned = DMat3::from_axis_angle(up, -right * std::f64::consts::PI) * pose.direction;
        let side = turned.cross(up).normalize_or_zero();
        // From up to the direction of view.
        let angle = turned.dot(up).clamp(-1.0, 1.0).acos();
        let (least, most) = (FROM_THE_POLES, std::f64::consts::PI - FROM_THE_POLES);
        let wanted = (angle + down * std::f64::consts::PI).clamp(least, most);
        pose.direction = (DMat3::from_axis_angle(side, angle - wanted) * turned).normalize();
        pose.eye = center - pose.distance * pose.direction;
        self.pose = Some(pose);
    }

    /// Moves the scene by a part of the picture's height, to the right and down, where the point that is looked at is.
    pub(super) fn pan(&mut self, [right, down]: [f64; 2]) {
        let mut pose = self.pose();
        let side = pose.direction.cross(self.home.up).normalize_or_zero();
        let above = side.cross(pose.direction);
        let half = (0.5 * self.home.fovy_degrees.to_radians()).tan();
        let height = 2.0 * pose.distance * half;
        pose.eye += height * (down * above - right * side);
        self.pose = Some(pose);
    }

    /// Brings the point that is looked at nearer, by a factor.
    pub(super) fn zoom(&mut self, factor: f64) {
        let mut pose = self.pose();
        let center = pose.center();
        let [least, most] = DISTANCES.map(|multiple| multiple * self.home_distance);
        pose.distance = (pose.distance / factor).clamp(least, most);
        pose.eye = center - pose.distance * pose.direction;
        self.pose = Some(pose);
    }

    /// The camera, whose numbers have so few digits that what [`lines`](Self::lines) shows is all of them.
    pub(super) fn camera(&self) -> Camera {
        let Some(pose) = self.pose else { return self.home.clone() };
        let size = pose.eye.abs().max_element().max(pose.distance);
        let eye = rounded(pose.eye, step_below(size.min(1e3 * pose.distance)));
        let direction = rounded(pose.direction, 1e-7);
        Camera { eye, direction, ..self.home.clone() }
    }

    /// Its commands, to be copied into a scene.
    pub(super) fn lines(&self) -> String {
        let Camera { eye, direction, up, distance, fovy_degrees, .. } = self.camera();
        let vector = |DVec3 { x, y, z }| format!("{x} {y} {z}");
        format!(
            "eyepos {}\neyedir {}\neyeup {}\nwdist {distance}\nfovy_deg {fovy_degrees}",
            vector(eye),
            vector(direction),
            vector(up)
        )
    }

    fn pose(&self) -> Pose {
        self.pose.unwrap_or_else(|| Pose {
            eye: self.home.eye,
            direction: self.home.direction.normalize_or_zero(),
            distance: self.home_distance,
        })
    }
}

impl Pose {
    fn center(&self) -> DVec3 {
        self.eye + self.distance * self.direction
    }
}

/// A power of ten that is seven digits below a size: about as far as single precision reaches.
fn step_below(size: f64) -> f64 {
    10f64.powi(size.log10().floor() as i32 - 7)
}

/// The nearest multiples of a power of ten, as they are read from their digits.
fn rounded(vector: DVec3, step: f64) -> DVec3 {
    let digits = (-step.log10()).round().max(0.0) as usize;
    let one = |x: f64| {
        let text = format!("{:.digits$}", (x / step).round() * step);
        // What was written as digits reads back; −0 becomes 0.
        text.parse().unwrap_or(x) + 0.0
    };
    DVec3::from_array(vector.to_array().map(one))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn orbit() -> Orbit {
        let home = Camera {
            eye: DVec3::new(1.0, -5.0, 2.0),
            direction: DVec3::new(0.0, 3.0, 0.0),
            up: DVec3::new(0.0, 0.3, 2.0),
            distance: 1.0,
            fovy_degrees: 90.0,
            width: 60,
            height: 40,
        };
        Orbit::new(home, 4.0)
    }

    fn center(orbit: &Orbit) -> DVec3 {
        orbit.pose().center()
    }

    #[test]
    fn it_is_at_home_to_the_bit_until_it_is_moved() {
        let mut orbit = orbit();
        assert_eq!(orbit.camera(), orbit.home);
        orbit.turn([0.1, 0.0]);
        assert!(orbit.is_moved());
        orbit.reset();
        assert_eq!(orbit.camera(), orbit.home);
    }

    #[test]
    fn turning_keeps_the_point_that_is_looked_at_and_its_distance() {
        let mut orbit = orbit();
        for step in [[0.3, 0.1], [-0.2, 0.4], [1.7, -3.0], [0.0, 9.0]] {
            orbit.turn(step);
            assert!((center(&orbit) - DVec3::new(1.0, -1.0, 2.0)).length() < 1e-9);
            let pose = orbit.pose();
            assert!((pose.direction.length() - 1.0).abs() < 1e-12);
            let from_up = pose.direction.angle_between(orbit.home.up);
            assert!((0.019..3.13).contains(&from_up), "{from_up}");
            assert!(crate::scene::Camera::new(&orbit.camera()).is_ok());
        }
    }

    #[test]
    fn the_scene_follows_the_hand() {
        // Taken to the right, the scene is seen from further left; taken down, from above.
        let mut right = orbit();
        right.home.up = DVec3::Z;
        let mut down = right.clone();
        right.turn([0.1, 0.0]);
        assert!(right.camera().eye.x < 0.9);
        down.turn([0.0, 0.1]);
        assert!(down.camera().eye.z > 2.1 && down.camera().direction.z < 0.0);
        let mut panned = orbit();
        panned.home.up = DVec3::Z;
        // The plane of what is looked at is 8 high: a tenth of that.
        panned.pan([0.1, 0.2]);
        let moved = panned.camera().eye - DVec3::new(1.0, -5.0, 2.0);
        assert!((moved - DVec3::new(-0.8, 0.0, 1.6)).length() < 1e-5, "{moved}");
    }

    #[test]
    fn zooming_goes_to_the_point_and_never_through_it() {
        let mut orbit = orbit();
        orbit.zoom(2.0);
        assert_eq!(orbit.camera().eye, DVec3::new(1.0, -3.0, 2.0));
        for _ in 0..100 {
            orbit.zoom(100.0);
        }
        assert!(orbit.pose().distance >= 1e-4);
        assert!((center(&orbit) - DVec3::new(1.0, -1.0, 2.0)).length() < 1e-9);
    }

    #[test]
    fn what_is_shown_is_the_camera_to_the_bit() {
        let mut orbit = orbit();
        orbit.turn([0.123, -0.05]);
        orbit.pan([0.02, 0.7]);
        orbit.zoom(1.37);
        let Camera { eye, direction, up, distance, fovy_degrees, .. } = orbit.camera();
        let shown: Vec<f64> =
            orbit.lines().split_whitespace().filter_map(|word| word.parse().ok()).collect();
        let vectors = [eye, direction, up].map(|vector| vector.to_array()).concat();
        assert_eq!(shown, [&vectors[..], &[distance, fovy_degrees]].concat());
        assert!(orbit.lines().lines().all(|line| line.len() < 50), "{}", orbit.lines());
    }

    #[test]
    fn a_saved_scene_keeps_the_place_unless_its_camera_is_another() {
        let mut orbit = orbit();
        orbit.turn([0.2, 0.0]);
        let larger = Camera { width: 120, height: 80, ..orbit.home.clone() };
        let carried = orbit.carried_to(larger, 4.0);
        assert_eq!(carried.camera().eye, orbit.camera().eye);
        assert_eq!(carried.camera().width, 120);
        let other = Camera { fovy_degrees: 30.0, ..orbit.home.clone() };
        assert!(!orbit.carried_to(other, 4.0).is_moved());
    }
}
