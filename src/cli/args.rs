//! The definition of the command, from which the help, the completions and the man pages are made
//! too. The options of rendering are in `render_args.rs`, those of comparing in `compare_args.rs`.

use std::path::PathBuf;

use clap::{Args, Parser, Subcommand};

use super::animate_args::AnimateArguments;
use super::choice::{described, named};
use super::compare_args::{CompareArguments, ConformanceArguments, ReportArguments};
use super::exit::EXIT_CODES;
use super::frames::LAST_FRAME;
use super::part_args::{AssembleArguments, PartArguments};
use super::rays_args::RaysArguments;
use super::render_args::RenderArguments;
use super::show_args::ShowArguments;
use super::structures::Structures;
use super::values;
use super::view_args::ViewArguments;
use super::work_args::USUAL_STRUCTURE;
use crate::accel::Quality;
use crate::assets::generate::MeshKind;
use crate::scene::Structure;

const EXAMPLES: &str = "\
Examples:
  srt scene.sce picture.tga                        render
  srt scene.sce picture.png --accel none --stats   without a structure, and with figures
  srt scene.sce detail.png --crop 90,50,190,150 --aa 8
  srt scene.sce cost.png --view heatmap            what the rays of each pixel tested
  srt scene.sce - --format png | display -         write to a pipe
  sed 's/^nx .*/nx 99/' scene.sce | srt - a.png    read from a pipe
  srt scene.sce picture.png --progressive --time 30s
  srt scene.sce picture.png --checkpoint scene.srtc --resume
  srt view scene.sce                               look at it in a browser while editing it
  srt show bvh scene.sce -o bvh.html               the tree over the scene, level by level
  srt part scene.sce --part 3/7 -o part-3.srtp     one of seven machines' parts
  srt assemble part-*.srtp -o picture.png          the same picture
  srt build scene.sce -o scene.srtb                built once, for all parts
  srt compare scenes/hall.sce                      how fast each structure is, as a report
  srt scene.sce frames/####.png --frames 0..60     the frames of a scene that moves
  srt animate scene.sce --frames 0..60             what it costs to follow it
  srt conformance --accel bvh8:leaf=4              whether its hits equal those of no structure
  srt check scenes/*.sce                           validate without rendering
  srt diff old.png new.png -o difference.png       compare two pictures

A scene whose file has the name of a subcommand needs its folder: `srt ./check out.tga`.

Environment:
  SRT_ISA=portable|avx2|avx512   the instruction set of the kernels, instead of the widest";

/// Renders a scene to a picture.
#[derive(Debug, Parser)]
#[command(
    name = "srt",
    version,
    about = "Ray tracer: renders a scene with the acceleration structure of your choice",
    long_about = "Ray tracer: renders a scene (sce1.0) to a picture, with the acceleration \
        structure of your choice. The picture is the same, bit for bit, whatever the structure, \
        the number of threads or the instruction set; the speed is not, and srt compares it.",
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
    /// Look at a scene in a browser: move the camera, exchange structures, edit the scene
    View(ViewArguments),
    /// Draw a structure over a scene, level by level, as a page with a slider
    Show(ShowArguments),
    /// Render a part of a picture, for another machine to put together
    Part(PartArguments),
    /// Put the parts of a picture together
    Assemble(AssembleArguments),
    /// Put a scene and all files that it names into one file, for another machine
    Pack(PackArguments),
    /// Build the structure over a scene, and put both into one file that need not be built again
    Build(BuildArguments),
    /// Validate scenes without rendering, and list what is in them
    Check(CheckArguments),
    /// Compare acceleration structures, prove their results equal, and write a report
    Compare(CompareArguments),
    /// Measure how structures follow a scene that moves: rebuilt, refitted or both, frame by frame
    Animate(AnimateArguments),
    /// Check that acceleration structures give equal hits, bit for bit
    Conformance(ConformanceArguments),
    /// Write the report of a comparison again, from its report.json
    Report(ReportArguments),
    /// Look into files of rays, and exchange rays with other programs
    Rays(RaysArguments),
    /// Compare two pictures
    Diff(DiffArguments),
    /// Generate a mesh as a Wavefront OBJ file
    Mesh(MeshArguments),
    /// List the acceleration structures with their options
    Accels,
    /// Print the completions of a shell
    Completions(CompletionsArguments),
    /// Print the man page, or write it and those of the subcommands into a folder
    Man(ManArguments),
}

/// `srt pack`.
#[derive(Debug, Args)]
#[command(after_help = "\
A pack is read wherever a scene is: `srt scene.srtpack picture.png`. It is a tar archive with the SHA-256 of\n\
each file, which are checked as it is read; docs/pack-file.md describes it.\n\n\
Exit codes: 0 done, 2 trouble.\n\n\
Examples:\n  \
srt pack scenes/dice.sce -o dice.srtpack\n  \
srt pack scenes/dice.sce -o - | ssh host srt - - --format png > dice.png")]
pub(crate) struct PackArguments {
    /// The scene file (sce1.0); `-` is standard input
    #[arg(value_name = "SCENE")]
    pub(crate) scene: PathBuf,

    /// The file to write; `-` is standard output
    #[arg(long, short, value_name = "FILE")]
    pub(crate) output: PathBuf,

    /// Treat unknown commands of the scene as warnings
    #[arg(long)]
    pub(crate) lenient: bool,

    /// Print nothing but errors
    #[arg(long, short)]
    pub(crate) quiet: bool,
}

/// `srt build`.
#[derive(Debug, Args)]
#[command(after_help = "\
A built scene is read wherever a scene is, by the same version of srt, and starts at once: its meshes are not\n\
parsed, and its structure is not built again. docs/built-file.md describes it.\n\n\
Exit codes: 0 done, 2 trouble.\n\n\
Examples:\n  \
srt build scenes/terrain.sce -o terrain.srtb\n  \
srt part terrain.srtb --part 3/7 -o part-3.srtp")]
pub(crate) struct BuildArguments {
    /// The scene file (sce1.0), or a pack; `-` is standard input
    #[arg(value_name = "SCENE")]
    pub(crate) scene: PathBuf,

    /// The file to write; `-` is standard output
    #[arg(long, short, value_name = "FILE")]
    pub(crate) output: PathBuf,

    /// The acceleration structure
    #[arg(long, value_name = "NAME", default_value = USUAL_STRUCTURE,
        value_parser = Structures::default().parser())]
    pub(crate) accel: Structure,

    /// The quality of the build: slower builds make better trees
    #[arg(long, value_name = "QUALITY", default_value = Quality::default().name(),
        value_parser = named(&Quality::ALL, Quality::name))]
    pub(crate) build: Quality,

    /// Threads that build, at most four a processor [default: one a processor]
    #[arg(long, value_name = "N", allow_negative_numbers = true,
        value_parser = values::whole::<u16>(1, 1024))]
    pub(crate) threads: Option<u16>,

    /// The frame of a scene that moves [default: 0]
    #[arg(long, value_name = "N", allow_negative_numbers = true,
        value_parser = values::whole::<u32>(0, u64::from(LAST_FRAME)))]
    pub(crate) frame: Option<u32>,

    /// Treat unknown commands of the scene as warnings
    #[arg(long)]
    pub(crate) lenient: bool,

    /// Print nothing but errors
    #[arg(long, short)]
    pub(crate) quiet: bool,
}

/// `srt check`.
#[derive(Debug, Args)]
#[command(
    after_help = "Exit codes: 0 all scenes are valid, 1 a scene is invalid, 2 a file cannot be read.\n\n\
    Of a scene that moves, frames from its first key to its last are looked at: all, or some that are evenly\n\
    spread where there are more than 5000 or the scene is large.\n\n\
    Example:\n  srt check scenes/*.sce"
)]
pub(crate) struct CheckArguments {
    /// The scene files; `-` is standard input
    #[arg(value_name = "SCENE", required = true)]
    pub(crate) scenes: Vec<PathBuf>,

    /// Treat unknown commands of the scenes as warnings
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

    /// Print nothing but errors; the exit code is the result
    #[arg(long, short)]
    pub(crate) quiet: bool,
}

/// `srt mesh`.
#[derive(Debug, Args)]
#[command(
    after_help = "If the shape does not allow every number of triangles, the mesh has about as \
    many.\n\n\
    Example:\n  srt mesh terrain --triangles 70k --seed 7 -o terrain.obj"
)]
pub(crate) struct MeshArguments {
    /// The shape
    #[arg(value_name = "KIND", value_parser = described(&MeshKind::ALL, MeshKind::name, MeshKind::description))]
    pub(crate) kind: MeshKind,

    /// How many triangles, such as 70000, 70k or 1M
    #[arg(long, short = 'n', value_name = "N", allow_negative_numbers = true,
        value_parser = values::triangles)]
    pub(crate) triangles: u32,

    /// The seed of the random numbers
    #[arg(long, value_name = "S", allow_negative_numbers = true, default_value_t = 0,
        value_parser = values::whole::<u64>(0, u64::MAX))]
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
    /// The folder to write srt.1, srt-check.1, … into, created if it is missing; without it, srt.1
    /// is printed
    #[arg(value_name = "DIR")]
    pub(crate) folder: Option<PathBuf>,
}
