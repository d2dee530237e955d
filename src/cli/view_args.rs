//! The definition of `srt view`.

use std::net::{IpAddr, Ipv4Addr};
use std::path::PathBuf;

use clap::Args;

use super::values::{address, whole};
use super::work_args::WorkArguments;

/// `srt view`.
#[derive(Debug, Args)]
#[command(after_help = "\
Prints the address of a page, to be opened in a browser. The picture refines while one looks, and\n\
in the end it is that of `srt SCENE OUTPUT`, bit for bit. The page moves the camera, exchanges\n\
structures, lets two of them race, and follows the scene and its meshes whenever they are saved.\n\
Ctrl-C ends it.\n\n\
Only this machine is listened to, unless --listen says otherwise, and only whoever knows the\n\
address, which has a token that is new each time. What is sent is not encrypted.\n\n\
Exit codes: 2 trouble, 130 ended by Ctrl-C.\n\n\
Examples:\n  \
srt view scene.sce\n  \
srt view scene.sce --size 640x360 --port 8000\n  \
srt view scene.sce --listen 0.0.0.0   for a telephone in the same network")]
pub(crate) struct ViewArguments {
    /// The scene file (sce1.0)
    #[arg(value_name = "SCENE")]
    pub(crate) scene: PathBuf,

    /// The port to listen on; 0 is any that is free
    #[arg(long, value_name = "PORT", allow_negative_numbers = true, default_value_t = 0,
        value_parser = whole::<u16>(0, u64::from(u16::MAX)), help_heading = "Page")]
    pub(crate) port: u16,

    /// The address of this machine to listen on; 0.0.0.0 is all of them, for other machines to look
    #[arg(long, value_name = "ADDRESS", default_value_t = IpAddr::V4(Ipv4Addr::LOCALHOST),
        value_parser = address, help_heading = "Page")]
    pub(crate) listen: IpAddr,

    /// What is rendered beside the scene, and by what.
    #[command(flatten)]
    pub(crate) work: WorkArguments,

    /// Treat unknown commands of the scene as warnings
    #[arg(long, help_heading = "Page")]
    pub(crate) lenient: bool,

    /// Print nothing but the address and errors
    #[arg(long, short, help_heading = "Page")]
    pub(crate) quiet: bool,
}
