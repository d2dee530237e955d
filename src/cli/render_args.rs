//! The definition of rendering. Rules about several options together are checked in `options.rs`.

use std::path::PathBuf;
use std::time::Duration;

use clap::{Args, ValueEnum};

use super::choice::{described, named};
use super::frames::FrameRange;
use super::values;
use super::work_args::WorkArguments;
use crate::image_io::{Format, ToneCurve};

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
    /// The extension decides the format. `####` in its name stands for the number of a frame. A file appears whole or
    /// not at all; a pipe or a device is written to directly. A pipe or a device without a known extension, and `-`,
    /// get ppm.
    #[arg(value_name = "OUTPUT", required = true)]
    pub(crate) output: Option<PathBuf>,

    /// What is rendered beside the scene, and by what.
    #[command(flatten)]
    pub(crate) work: WorkArguments,

    /// How its light is fitted into the picture, and in which format.
    #[command(flatten)]
    pub(crate) picture: PictureArguments,

    /// Render these frames of a scene that moves, both ends included, each to a picture of its own: 0..60
    ///
    /// The name of the output has a place for the number: `####`, or any number of `#`, which is filled up with
    /// zeros. Standard output gets one picture after the other. The folder is made if it is missing. After Ctrl-C or
    /// another signal to end, the frames that are there are whole.
    #[arg(long, value_name = "FIRST..LAST", allow_hyphen_values = true, value_parser = values::frames,
        conflicts_with_all = ["frame", "progressive", "time", "noise", "checkpoint", "keep_partial"],
        help_heading = "Output")]
    pub(crate) frames: Option<FrameRange>,

    /// Treat unknown commands of the scene as warnings
    #[arg(long, help_heading = "Output")]
    pub(crate) lenient: bool,

    /// Render in passes: a first picture soon, then better ones in its place
    ///
    /// Each pass has as many samples as those before it, at most 256. The picture is written after the first pass and
    /// then after passes that are at least a second apart, always whole; when all samples are there it is that of a
    /// rendering in one go, bit for bit. After Ctrl-C or another signal to end, what there is is written.
    #[arg(long, help_heading = "Refinement")]
    pub(crate) progressive: bool,

    /// Stop after this time of rendering, such as 30s, 5m or 2h; implies --progressive
    #[arg(long, value_name = "TIME", allow_negative_numbers = true, value_parser = values::time,
        help_heading = "Refinement")]
    pub(crate) time: Option<Duration>,

    /// Stop when the noise is at most this, such as 0.01; implies --progressive
    ///
    /// The noise is the standard error of a pixel's luminance, from 0 to 1 as a screen shows it, as the root of its
    /// mean square over all pixels. It is looked at after each pass, from four samples a pixel on.
    #[arg(long, value_name = "ERROR", allow_negative_numbers = true, value_parser = values::noise,
        help_heading = "Refinement")]
    pub(crate) noise: Option<f64>,

    /// Save what is rendered to this file from time to time, for --resume to go on with
    ///
    /// It appears whole or not at all, and is written once more at the end or at a signal to end.
    #[arg(long, value_name = "FILE", help_heading = "Refinement")]
    pub(crate) checkpoint: Option<PathBuf>,

    /// How often: at most so much is lost when the command is killed
    #[arg(long, value_name = "TIME", allow_negative_numbers = true, default_value = "30s",
        value_parser = values::time, requires = "checkpoint", help_heading = "Refinement")]
    pub(crate) checkpoint_interval: Duration,

    /// Go on from the file of --checkpoint, or begin if there is none yet
    ///
    /// A file of another scene, of other settings or of another version is refused. Structure, threads and instruction
    /// set may be others. The picture is that of a rendering that was never stopped, bit for bit.
    #[arg(long, requires = "checkpoint", help_heading = "Refinement")]
    pub(crate) resume: bool,

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
    /// The JSON is one object of `version` 1 with scene, frame, width, height, view, scale (of depths and
    /// heatmaps: low, high, spacing), partial, stopped_by (signal, time, noise or null), rendered_pixels,
    /// samples_per_pixel (on average), noise (of --progressive and --checkpoint), threads, structure,
    /// render_seconds, thread_seconds, rays, rays_per_second and classes. Means of nothing are null.
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

/// How light becomes the picture that is written.
#[derive(Clone, Debug, Args)]
pub(crate) struct PictureArguments {
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
}

/// The forms of `--stats`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum StatsForm {
    /// for people
    Table,
    /// for programs
    Json,
}
