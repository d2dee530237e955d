//! From a scene and a structure to a picture.
//!
//! Rays travel in waves: a batch of view rays finds its hits, what was hit is shaded together, all
//! shadow rays of a batch are asked together, and mirrored and refracted rays make the next wave.
//! Nothing is recursive, and the order of rays in a wave never changes a result: a sample's colour
//! is the sum of its own contributions in an order of their own.
//!
//! Knows no file format and no terminal; what it reports on the way goes to an [`Observer`].

mod batch;
mod color_map;
mod finish;
mod incidence;
mod light_samples;
mod observer;
mod optics;
mod receivers;
mod settings;
mod shadows;
mod stats;
mod tiles;
mod times;
mod view_rays;
mod views;

pub use color_map::{Scale, Spacing, heat_picture};
pub use light_samples::{Dealt, LightSamples};
pub use observer::{Observer, Silent};
pub use settings::{Crop, Sampling, Settings, View};
pub use stats::{ClassStats, RayClass, RenderStats};
pub use tiles::{Rendering, Sight, pixel_order, render};
pub use times::{Stage, StageTimes};
