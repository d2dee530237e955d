//! The definition of `srt rays`.

use std::path::PathBuf;

use clap::{Args, Subcommand};

use super::choice::{described, named};
use super::values::ray_end;
use crate::accel::QueryKind;
use crate::record::RayClass;

/// `srt rays`.
#[derive(Debug, Args)]
#[command(after_help = "\
Files of rays (.srtrays) are written by `srt compare --save-rays DIR` and measured by `srt compare\n\
--rays FILE`. They hold the rays of a scene, class by class in their order, and what each finds; a\n\
SHA-256 of all of that, by which they are cited; and one of the geometry that they are for.\n\n\
Exit codes: 0 done, 2 trouble.\n\n\
Examples:\n  \
srt rays info hall.srtrays\n  \
srt rays export hall.srtrays hall-view.rays --format rodent --class view\n  \
srt rays import sponza-primary.rays sponza.srtrays --format rodent --scene sponza.sce --t-max 5000")]
pub(crate) struct RaysArguments {
    /// What to do.
    #[command(subcommand)]
    pub(crate) command: RaysCommand,
}

/// What to do with rays.
#[derive(Debug, Subcommand)]
pub(crate) enum RaysCommand {
    /// List the classes of a file of rays, their answers, and the hashes
    Info(InfoArguments),
    /// Write the rays of a class in the form of another program
    Export(ExportArguments),
    /// Read rays in the form of another program, and write them with their answers in a scene
    Import(ImportArguments),
}

/// `srt rays info`.
#[derive(Debug, Args)]
pub(crate) struct InfoArguments {
    /// A file of rays
    #[arg(value_name = "FILE")]
    pub(crate) file: PathBuf,
}

/// `srt rays export`.
#[derive(Debug, Args)]
pub(crate) struct ExportArguments {
    /// A file of rays
    #[arg(value_name = "FILE")]
    pub(crate) file: PathBuf,

    /// The file to write; `-` is standard output
    #[arg(value_name = "OUTPUT")]
    pub(crate) output: PathBuf,

    /// The form to write
    #[arg(long, value_name = "FORMAT",
        value_parser = described(&Format::ALL, Format::name, Format::description))]
    pub(crate) format: Format,

    /// The class of rays [default: the only one]
    #[arg(long, value_name = "CLASS", value_parser = named(&RayClass::ALL, RayClass::name))]
    pub(crate) class: Option<RayClass>,
}

/// `srt rays import`.
#[derive(Debug, Args)]
pub(crate) struct ImportArguments {
    /// The file to read
    #[arg(value_name = "INPUT")]
    pub(crate) input: PathBuf,

    /// The file of rays to write; `-` is standard output
    #[arg(value_name = "OUTPUT")]
    pub(crate) output: PathBuf,

    /// The form to read
    #[arg(long, value_name = "FORMAT",
        value_parser = described(&Format::ALL, Format::name, Format::description))]
    pub(crate) format: Format,

    /// The scene that the rays are for (sce1.0)
    #[arg(long, value_name = "SCENE")]
    pub(crate) scene: PathBuf,

    /// What the rays are called
    #[arg(long, value_name = "CLASS", default_value = RayClass::View.name(),
        value_parser = named(&RayClass::ALL, RayClass::name))]
    pub(crate) class: RayClass,

    /// What they are to find
    #[arg(long, value_name = "QUERY", default_value = "closest",
        value_parser = described(&QUERIES, query_name, query_description))]
    pub(crate) query: QueryKind,

    /// Where all rays begin, of rodent's
    #[arg(long, value_name = "T", allow_negative_numbers = true, default_value = "0",
        value_parser = ray_end)]
    pub(crate) t_min: f32,

    /// Where all rays end, of rodent's [default: nowhere]
    #[arg(long, value_name = "T", allow_negative_numbers = true, value_parser = ray_end)]
    pub(crate) t_max: Option<f32>,
}

/// The form of another program's rays.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Format {
    /// Rodent's `.rays`.
    Rodent,
    /// tinybvh's records.
    TinyBvh,
}

impl Format {
    const ALL: [Self; 2] = [Self::Rodent, Self::TinyBvh];

    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Rodent => "rodent",
            Self::TinyBvh => "tinybvh",
        }
    }

    fn description(self) -> &'static str {
        match self {
            Self::Rodent => "rodent's .rays: origin and direction of each, six 32-bit floats",
            Self::TinyBvh => "the 64 bytes of each ray that tinybvh's kernels read",
        }
    }
}

const QUERIES: [QueryKind; 2] = [QueryKind::ClosestHit, QueryKind::AnyHit];

fn query_name(query: QueryKind) -> &'static str {
    match query {
        QueryKind::ClosestHit => "closest",
        QueryKind::AnyHit => "any",
    }
}

fn query_description(query: QueryKind) -> &'static str {
    match query {
        QueryKind::ClosestHit => "the first hit",
        QueryKind::AnyHit => "whether there is any hit",
    }
}
