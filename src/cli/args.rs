//! What was typed: the command's one definition, from which help, completions and the man page
//! are made too. Knows no rule that takes two options to check; see `options.rs`.

use std::path::PathBuf;

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use clap::{Args, Parser, Subcommand, ValueEnum, value_parser};

use super::exit::EXIT_CODES;
use super::pending::{Format, Kind, STRUCTURES};
use super::values::{Crop, Size};
use crate::accel::Quality;

const EXAMPLES: &str = "\
Examples:
  srt scene.sce picture.tga                      render
  srt scene.sce picture.png --accel none --stats  the same picture without a structure, and figures
  srt scene.sce detail.png --crop 100,50,200,150 --aa 8
  srt scene.sce tests.png --view heatmap         what each pixel's rays cost
  srt scene.sce - --format png | viewer -        to a pipe
  srt check scenes/*.sce                         validate without rendering
  srt diff old.png new.png -o difference.png

A scene whose file is named like a subcommand is written with its folder: `srt ./check picture.tga`.";

/// Renders a scene to a picture.
#[derive(Debug, Parser)]
#[command(
    name = "srt",
    version,
    about = "Ray tracer: renders a scene with the acceleration structure of your choice",
    long_about = "Ray tracer: renders a scene (sce1.0) to a picture, with the acceleration structure \
        of your choice. The picture is the same, bit for bit, whatever the structure and the number \
        of threads; the speed is not, and that is what srt shows.",
    after_help = format!("{EXAMPLES}\n\n{EXIT_CODES}"),
    args_conflicts_with_subcommands = true,
    subcommand_negates_reqs = true,
    max_term_width = 100
)]
pub(crate) struct Arguments {
    /// What to do instead of rendering.
    #[command(subcommand)]
    pub(crate) command: Option<Command>,
    /// What to render.
    #[command(flatten)]
    pub(crate) render: RenderArguments,
}

/// The subcommands.
#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    /// Validate scenes without rendering and tell what is in them
    Check(CheckArguments),
    /// Compare two pictures
    Diff(DiffArguments),
    /// Generate a mesh as a Wavefront OBJ file
    Mesh(MeshArguments),
    /// Print the completions of a shell
    Completions(CompletionsArguments),
    /// Print the man page, or write it and those of the subcommands into a folder
    Man(ManArguments),
}

/// The default command: rendering.
#[derive(Debug, Args)]
pub(crate) struct RenderArguments {
    /// The scene file (sce1.0)
    #[arg(value_name = "SCENE", required = true)]
    pub(crate) scene: Option<PathBuf>,

    /// The picture to write; `-` is standard output
    ///
    /// The format goes by the extension. A file appears whole or not at all; a pipe or device is
    /// written to. A pipe or device without a known extension, and `-`, get ppm.
    #[arg(value_name = "OUTPUT", required = true)]
    pub(crate) output: Option<PathBuf>,

    /// The acceleration structure
    #[arg(long, value_name = "NAME", default_value = "bvh", value_parser = structure_names(),
        help_heading = "Structure")]
    pub(crate) accel: String,

    /// How long a build may take for a better tree
    #[arg(long, value_name = "QUALITY", default_value = "medium", value_parser = qualities(),
        help_heading = "Structure")]
    pub(crate) build: Quality,

    /// Threads that render [default: one a processor]
    #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = value_parser!(u16).range(1..=1024),
        help_heading = "Structure")]
    pub(crate) threads: Option<u16>,

    /// Width and height in pixels [default: as the scene says]
    #[arg(long, value_name = "WxH", help_heading = "Picture")]
    pub(crate) size: Option<Size>,

    /// Render only the columns x0 to x1 and rows y0 to y1, counted from the top left
    ///
    /// x1 and y1 are the first column and row outside: 0,0,320,240 is the top left corner, 320
    /// pixels wide and 240 high. The picture holds these pixels alone, with the values that they
    /// have in the whole one.
    #[arg(long, value_name = "x0,y0,x1,y1", help_heading = "Picture")]
    pub(crate) crop: Option<Crop>,

    /// N × N samples a pixel; 0 is one ray through its centre [default: as the scene says]
    #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = value_parser!(u32).range(0..=1024),
        help_heading = "Picture")]
    pub(crate) aa: Option<u32>,

    /// How the samples of lights are made
    #[arg(long, value_enum, value_name = "WAY", default_value_t, help_heading = "Picture")]
    pub(crate) sampling: Sampling,

    /// N × N samples of each area light for each sample of a pixel
    #[arg(long, value_name = "N", allow_negative_numbers = true, default_value_t = 1,
        value_parser = value_parser!(u32).range(1..=1024), help_heading = "Picture")]
    pub(crate) light_samples: u32,

    /// How many mirror bounces and refractions a ray may take [default: as the scene says]
    #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = value_parser!(u32).range(0..=1000),
        help_heading = "Picture")]
    pub(crate) max_recursion: Option<u32>,

    /// Where the random numbers of the samples start
    #[arg(
        long,
        value_name = "N",
        allow_negative_numbers = true,
        default_value_t = 0,
        help_heading = "Picture"
    )]
    pub(crate) seed: u64,

    /// What the pixels show
    #[arg(long, value_enum, value_name = "WHAT", default_value_t, help_heading = "Picture")]
    pub(crate) view: View,

    /// The picture's format, whatever the extension
    #[arg(long, value_name = "FORMAT", value_parser = formats(), help_heading = "Output")]
    pub(crate) format: Option<Format>,

    /// Take unknown commands of the scene as warnings
    #[arg(long, help_heading = "Output")]
    pub(crate) lenient: bool,

    /// After Ctrl-C, write what has been rendered so far
    #[arg(long, help_heading = "Output")]
    pub(crate) keep_partial: bool,

    /// Count, and print the figures of the structure and the rays
    ///
    /// The table goes to standard error. JSON goes to standard output, unless the picture does.
    /// Counting takes some time; the picture stays the same.
    #[arg(long, value_enum, value_name = "FORM", num_args = 0..=1, require_equals = true,
        default_missing_value = "table", help_heading = "Output")]
    pub(crate) stats: Option<StatsForm>,

    /// Print errors, and what --stats asks for, but nothing else
    #[arg(long, short, help_heading = "Output")]
    pub(crate) quiet: bool,
}

/// How the samples of lights are made.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(crate) enum Sampling {
    /// made once, then shuffled for each pixel and light
    Shuffled,
    /// made on the fly for each sample
    #[default]
    Independent,
}

/// What the pixels show.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(crate) enum View {
    /// the shaded scene
    #[default]
    Color,
    /// the normal of the surface
    Normal,
    /// the distance from the eye
    Depth,
    /// which object was hit, a colour each
    Object,
    /// which primitive was hit, a colour each
    Primitive,
    /// how many boxes and primitives the rays tested
    Heatmap,
}

/// The forms of `--stats`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum StatsForm {
    /// for people
    Table,
    /// for programs
    Json,
}

/// `srt check`.
#[derive(Debug, Args)]
#[command(
    after_help = "Exit codes: 0 all are valid, 1 a scene is invalid, 2 a file cannot be read.\n\n\
    Example:\n  srt check scenes/*.sce"
)]
pub(crate) struct CheckArguments {
    /// The scene files
    #[arg(value_name = "SCENE", required = true)]
    pub(crate) scenes: Vec<PathBuf>,

    /// Take unknown commands of the scenes as warnings
    #[arg(long)]
    pub(crate) lenient: bool,
}

/// `srt diff`.
#[derive(Debug, Args)]
#[command(after_help = "Exit codes: 0 the pictures are equal, 1 they differ, 2 trouble.\n\n\
    Example:\n  srt diff old.png new.png -o difference.png")]
pub(crate) struct DiffArguments {
    /// A picture
    #[arg(value_name = "A")]
    pub(crate) a: PathBuf,

    /// Another picture
    #[arg(value_name = "B")]
    pub(crate) b: PathBuf,

    /// Write a picture of where they differ, unless they are equal
    #[arg(long, short, value_name = "FILE")]
    pub(crate) output: Option<PathBuf>,

    /// Print nothing but errors; the exit code tells
    #[arg(long, short)]
    pub(crate) quiet: bool,
}

/// `srt mesh`.
#[derive(Debug, Args)]
#[command(
    after_help = "The number of triangles is approximate where the form does not allow every number.\n\n\
    Example:\n  srt mesh terrain --triangles 70000 --seed 7 -o terrain.obj"
)]
pub(crate) struct MeshArguments {
    /// The form
    #[arg(value_name = "KIND", value_parser = kinds())]
    pub(crate) kind: Kind,

    /// How many triangles
    #[arg(long, short = 'n', value_name = "N", allow_negative_numbers = true,
        value_parser = value_parser!(u32).range(1..=100_000_000))]
    pub(crate) triangles: u32,

    /// Where the random numbers start
    #[arg(long, value_name = "S", default_value_t = 0)]
    pub(crate) seed: u64,

    /// The file to write; `-` is standard output
    #[arg(long, short, value_name = "FILE", default_value = "-")]
    pub(crate) output: PathBuf,
}

/// `srt completions`.
#[derive(Debug, Args)]
#[command(
    after_help = "Example:\n  srt completions bash > ~/.local/share/bash-completion/completions/srt"
)]
pub(crate) struct CompletionsArguments {
    /// The shell
    #[arg(value_enum, value_name = "SHELL")]
    pub(crate) shell: clap_complete::Shell,
}

/// `srt man`.
#[derive(Debug, Args)]
#[command(after_help = "Examples:\n  srt man | man -l -\n  srt man ~/.local/share/man/man1")]
pub(crate) struct ManArguments {
    /// The folder to write srt.1, srt-check.1, … into; without it, srt.1 is printed
    #[arg(value_name = "DIR")]
    pub(crate) folder: Option<PathBuf>,
}

/// The names of the structures, with what they are.
fn structure_names() -> PossibleValuesParser {
    STRUCTURES.iter().map(|s| PossibleValue::new(s.name).help(s.summary)).into()
}

fn qualities() -> impl TypedValueParser<Value = Quality> {
    named(&Quality::ALL, Quality::name)
}

fn formats() -> impl TypedValueParser<Value = Format> {
    named(&Format::ALL, Format::name)
}

fn kinds() -> impl TypedValueParser<Value = Kind> {
    named(&Kind::ALL, Kind::name)
}

/// Takes the name of one of a set of things.
fn named<T: Copy + Send + Sync + 'static>(
    all: &'static [T],
    name: fn(T) -> &'static str,
) -> impl TypedValueParser<Value = T> {
    PossibleValuesParser::new(all.iter().map(|&thing| name(thing))).try_map(move |typed| {
        let found = all.iter().copied().find(|&thing| name(thing) == typed);
        found.ok_or_else(|| format!("there is no `{typed}`"))
    })
}
