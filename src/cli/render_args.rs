//! The definition of rendering. Rules about several options together are checked in `options.rs`.

use std::path::PathBuf;

use clap::{Args, ValueEnum};

use super::choice::{described, named};
use super::structures::Structures;
use super::values::{self, Size, whole};
use crate::accel::Quality;
use crate::description::Options;
use crate::image_io::{Format, ToneCurve};
use crate::render::{Crop, Sampling, Settings, View};
use crate::scene::Structure;

/// The default command: rendering.
#[derive(Debug, Args)]
pub(crate) struct RenderArguments {
    /// The scene file (sce1.0); `-` is standard input
    ///
    /// Meshes of a scene from standard input are searched for in the working folder.
    #[arg(value_name = "SCENE", required = true)]
    pub(crate) scene: Option<PathBuf>,

    /// The picture to write; `-` is standard output
    ///
    /// The extension decides the format. A file appears whole or not at all; a pipe or a device is
    /// written to directly. A pipe or a device without a known extension, and `-`, get ppm.
    #[arg(value_name = "OUTPUT", required = true)]
    pub(crate) output: Option<PathBuf>,

    /// The acceleration structure
    #[arg(long, value_name = "NAME", default_value = "bvh8", value_parser = Structures::default().parser(),
        help_heading = "Structure")]
    pub(crate) accel: Structure,

    /// The quality of the build: slower builds make better trees
    #[arg(long, value_name = "QUALITY", default_value = Quality::default().name(),
        value_parser = named(&Quality::ALL, Quality::name), help_heading = "Structure")]
    pub(crate) build: Quality,

    /// Threads that build and render, at most four a processor [default: one a processor]
    #[arg(long, value_name = "N", allow_negative_numbers = true,
        value_parser = whole::<u16>(1, 1024), help_heading = "Structure")]
    pub(crate) threads: Option<u16>,

    /// Width and height in pixels [default: those of the scene]
    #[arg(long, value_name = "WxH", allow_hyphen_values = true, help_heading = "Picture")]
    pub(crate) size: Option<Size>,

    /// Render only the columns x0 to x1 and rows y0 to y1, counted from the top left
    ///
    /// x1 and y1 are the first column and row outside: 0,0,320,240 is the top left corner, 320
    /// pixels wide and 240 high. The picture has these pixels alone, with the values that they have
    /// in the whole picture.
    #[arg(long, value_name = "x0,y0,x1,y1", allow_hyphen_values = true, value_parser = values::crop,
        help_heading = "Picture")]
    pub(crate) crop: Option<Crop>,

    /// N × N samples a pixel; 0 is one ray through its centre [default: that of the scene]
    #[arg(long, value_name = "N", allow_negative_numbers = true,
        value_parser = whole::<u32>(0, u64::from(Options::MAX_AA)), help_heading = "Picture")]
    pub(crate) aa: Option<u32>,

    /// How the samples of lights are made
    #[arg(long, value_name = "METHOD", default_value = Sampling::default().name(),
        value_parser = described(&Sampling::ALL, Sampling::name, Sampling::summary),
        help_heading = "Picture")]
    pub(crate) sampling: Sampling,

    /// N × N samples of each area light for each sample of a pixel
    #[arg(long, value_name = "N", allow_negative_numbers = true, default_value_t = 1,
        value_parser = whole::<u32>(1, u64::from(Settings::MAX_LIGHT_SIDE)),
        help_heading = "Picture")]
    pub(crate) light_samples: u32,

    /// How many times a ray may be mirrored or refracted [default: that of the scene]
    #[arg(long, value_name = "N", allow_negative_numbers = true,
        value_parser = whole::<u32>(0, u64::from(Options::MAX_RECURSION)),
        help_heading = "Picture")]
    pub(crate) max_recursion: Option<u32>,

    /// The seed of the random numbers
    #[arg(
        long,
        value_name = "N",
        allow_negative_numbers = true,
        default_value_t = 0,
        value_parser = whole::<u64>(0, u64::MAX),
        help_heading = "Picture"
    )]
    pub(crate) seed: u64,

    /// What the pixels show
    ///
    /// Depths (in steps of equal factors) and heatmaps are coloured, and the scale is printed on
    /// standard error; exr and hdr hold the numbers themselves.
    #[arg(long, value_name = "WHAT", default_value = View::default().name(),
        value_parser = described(&View::ALL, View::name, View::summary),
        help_heading = "Picture")]
    pub(crate) view: View,

    /// How many stops brighter the picture is written: 1 doubles the light, -1 halves it
    ///
    /// For tga, png and ppm: exr and hdr hold the light as it is, and viewers choose the exposure.
    #[arg(long, value_name = "EV", allow_negative_numbers = true, default_value_t = 0.0,
        value_parser = values::stops, help_heading = "Picture")]
    pub(crate) exposure: f32,

    /// How light above 1 is fitted into the picture, after the exposure
    ///
    /// For tga, png and ppm, as --exposure.
    #[arg(long, value_name = "CURVE", default_value = ToneCurve::default().name(),
        value_parser = described(&ToneCurve::ALL, ToneCurve::name, ToneCurve::summary),
        help_heading = "Picture")]
    pub(crate) tone_curve: ToneCurve,

    /// The picture's format, regardless of the extension
    #[arg(long, value_name = "FORMAT", value_parser = named(&Format::ALL, Format::name),
        help_heading = "Output")]
    pub(crate) format: Option<Format>,

    /// Treat unknown commands of the scene as warnings
    #[arg(long, help_heading = "Output")]
    pub(crate) lenient: bool,

    /// After Ctrl-C or another signal to end, write what has been rendered so far
    ///
    /// Missing pixels are black, or grey in coloured depths and heatmaps.
    #[arg(long, help_heading = "Output")]
    pub(crate) keep_partial: bool,

    /// Count tests, and print the figures of the structure and the rays
    ///
    /// The table goes to standard error. JSON goes to standard output, unless the picture does.
    /// Counting takes some time; the picture stays the same.
    ///
    /// The JSON is one object of `version` 1 with scene, width, height, view, scale (of depths and
    /// heatmaps: low, high, spacing), partial, rendered_pixels, threads, structure, render_seconds,
    /// thread_seconds, rays, rays_per_second and classes. Means of nothing are null.
    ///
    /// structure: name, build, build_seconds, build_stages (stage, seconds), objects and meshes (bytes,
    /// nodes, leaves, depth, leaf_sizes), triangles, triangle_bytes, bytes_per_triangle.
    ///
    /// thread_seconds, added up over the threads: total, tracing, making_rays, shading, rest,
    /// outside_tracing; and outside_tracing_share.
    ///
    /// classes: class, rays, hits, trace_seconds, boxes, primitives, boxes_per_ray,
    /// primitives_per_ray.
    #[arg(long, value_enum, value_name = "FORM", num_args = 0..=1, require_equals = true,
        default_missing_value = "table", help_heading = "Output")]
    pub(crate) stats: Option<StatsForm>,

    /// Print nothing but errors and the figures of --stats
    #[arg(long, short, help_heading = "Output")]
    pub(crate) quiet: bool,
}

/// The forms of `--stats`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum StatsForm {
    /// for people
    Table,
    /// for programs
    Json,
}
