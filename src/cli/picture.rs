//! What was rendered → the file of the picture, and what there is to say of it.

use std::path::Path;

use super::clipping::ClippingWarning;
use super::exit::Failure;
use super::output::{Output, OutputError, prepare_picture};
use super::render_args::PictureArguments;
use super::terminal::{print_message, print_warning};
use crate::image_io::{Format, Tone, encode};
use crate::render::{Image, Scale, View, legend, picture_for};

/// Where a picture goes, and how its light is fitted into it.
#[derive(Debug)]
pub(crate) struct PictureTarget {
    /// Where it goes.
    pub(crate) output: Output,
    /// In which format.
    pub(crate) format: Format,
    /// How its light is fitted into bytes.
    pub(crate) tone: Tone,
}

/// What there is to say of a picture that was written.
#[derive(Debug)]
pub(crate) struct Remarks {
    view: View,
    /// The scale of its colours, if it shows numbers.
    pub(crate) scale: Option<Scale>,
    clipping: Option<ClippingWarning>,
}

impl PictureTarget {
    /// Checks the place, and the format.
    pub(crate) fn new(path: &Path, typed: &PictureArguments) -> Result<Self, Failure> {
        let (output, format) =
            prepare_picture(path, typed.format).map_err(|error| match error {
                OutputError::UnknownFormat { .. } => {
                    Failure::new(format_args!("{error}; or choose a format with --format"))
                }
                _ => error.into(),
            })?;
        let tone = Tone { exposure: typed.exposure, curve: typed.tone_curve };
        Ok(Self { output, format, tone })
    }

    /// Exposure and tone curve are for the light of the scene, and for formats that cannot hold all of it.
    pub(crate) fn check_tone(&self, view: View) -> Result<(), Failure> {
        if self.tone.is_neutral() {
            return Ok(());
        }
        if view != View::Color {
            return Err(Failure::new(format_args!(
                "--exposure and --tone-curve change the light of a picture, and --view {} shows none: \
                 leave them out",
                view.name(),
            )));
        }
        if self.format.is_linear() {
            return Err(Failure::new(format_args!(
                "--exposure and --tone-curve are for .tga, .png and .ppm: .{} holds the light as it \
                 is, and what shows it chooses the exposure",
                self.format,
            )));
        }
        Ok(())
    }

    /// Writes the picture.
    pub(crate) fn write(&self, image: Image, view: View) -> Result<Remarks, Failure> {
        let (mut picture, scale) = picture_for(image, view, self.format);
        let clipping = ClippingWarning::of(&picture, self.tone, self.format);
        let clipping = clipping.filter(|_| view == View::Color);
        self.tone.apply(&mut picture);
        let bytes = encode(&picture, self.format).map_err(Failure::new)?;
        self.output.write_once_more(|to| to.write_all(&bytes))?;
        Ok(Remarks { view, scale, clipping })
    }
}

impl Remarks {
    /// Prints them on standard error.
    pub(crate) fn print(&self) {
        if let Some(clipping) = self.clipping {
            print_warning(clipping);
        }
        if let Some(scale) = self.scale {
            print_message(legend(self.view, scale));
        }
    }
}
