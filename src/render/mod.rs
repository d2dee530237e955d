//! From a scene and a structure to an image.
//!
//! Rays travel in waves. A batch of view rays is traced, what it hits is shaded together, its shadow
//! rays are traced together, and mirrored and refracted rays make the next wave. Nothing is
//! recursive. The order of rays in a wave never changes a result: the colour of a sample is the sum
//! of its own contributions, in an order of their own.
//!
//! | file | what it does |
//! |---|---|
//! | `rendering.rs`, `image.rs` | a whole picture, from tiles to an image |
//! | `renderer.rs` | pieces of a picture to threads, and to whoever wants them |
//! | `tile_renderer.rs`, `tiles.rs` | a thread's part: pixels to batches |
//! | `hit_views.rs`, `cells/` | what a pixel hit, instead of its colour; the cells of a structure |
//! | `batch.rs` | a batch of view samples, wave by wave |
//! | `view_rays.rs`, `secondary_rays.rs`, `path.rs`, `wave.rs`, `optics.rs` | rays and their paths |
//! | `shading.rs`, `shading_material.rs`, `exponent.rs` | hits to colours |
//! | `direct_light/`, `light_samples.rs` | lights and shadow rays |
//! | `measured_tracer.rs`, `stats.rs`, `times.rs`, `stopwatch.rs` | tracing, counted and timed |
//! | `settings.rs`, `sampling.rs`, `view.rs` | what is to be rendered |
//! | `color_map.rs`, `shown.rs` | scalars to colours; what was rendered to what is shown |
//!
//! Knows no file format and no terminal. Progress goes to an [`Observer`].

mod batch;
mod cells;
mod color_map;
mod direct_light;
mod exponent;
mod frame;
mod hit_views;
mod image;
mod light_samples;
mod measured_tracer;
mod observer;
mod optics;
mod path;
mod renderer;
mod rendering;
mod sampling;
mod secondary_rays;
mod settings;
mod shading;
mod shading_material;
mod shown;
mod stats;
mod stopwatch;
mod tile_renderer;
mod tiles;
mod times;
mod view;
mod view_rays;
mod wave;

pub use cells::CellView;
pub use color_map::{Scale, heat_picture};
pub use image::Image;
pub use light_samples::{LightSamples, SampleAssignment};
pub use observer::{Observer, Silent};
pub use renderer::{Kept, Renderer};
pub use rendering::{Rendering, render};
pub use sampling::Sampling;
pub use settings::Settings;
pub use shown::{legend, picture_for};
pub use stats::{ClassStats, RenderStats};
pub use tiles::pixel_order;
pub use times::{Stage, StageTimes};
pub use view::View;

pub use crate::film::Crop;
pub use crate::record::{RayClass, Spacing};
