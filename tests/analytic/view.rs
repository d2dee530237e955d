//! The camera of the tests, in double precision and on its own: the directions of the format's
//! definition, not those of the library.

use glam::DVec3;

/// A camera as a scene file describes it.
#[derive(Clone, Copy)]
pub(crate) struct View {
    pub(crate) eye: DVec3,
    pub(crate) dir: DVec3,
    pub(crate) up: DVec3,
    pub(crate) fovy_degrees: f64,
    pub(crate) width: u32,
    pub(crate) height: u32,
}

impl View {
    /// Its commands.
    pub(crate) fn commands(&self) -> String {
        let v = |v: DVec3| format!("{:e} {:e} {:e}", v.x, v.y, v.z);
        format!(
            "eyepos {}\neyedir {}\neyeup {}\nwdist 1\nfovy_deg {}\nnx {}\nny {}\n",
            v(self.eye),
            v(self.dir),
            v(self.up),
            self.fovy_degrees,
            self.width,
            self.height,
        )
    }

    /// Unit direction through the centre of each pixel, row by row from the top left.
    pub(crate) fn directions(&self) -> Vec<DVec3> {
        let w = -self.dir.normalize();
        let u = self.up.cross(w).normalize();
        let v = w.cross(u);
        let (nx, ny) = (f64::from(self.width), f64::from(self.height));
        let top = (0.5 * self.fovy_degrees.to_radians()).tan();
        let right = top * nx / ny;
        let pixels = (0..self.height).flat_map(|y| (0..self.width).map(move |x| (x, y)));
        pixels
            .map(|(x, y)| {
                let (i, j) = (f64::from(x), f64::from(self.height - 1 - y));
                let s = -right + 2.0 * right * (i + 0.5) / nx;
                let t = -top + 2.0 * top * (j + 0.5) / ny;
                (s * u + t * v - w).normalize()
            })
            .collect()
    }
}
