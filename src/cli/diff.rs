//! `srt diff`: whether two pictures are equal, and where they differ. The layer `image_io` compares;
//! this file reads, prints and exits.

use std::io::ErrorKind;
use std::path::Path;

use super::args::DiffArguments;
use super::exit::{CommandResult, Exit, Failure};
use super::inputs::refuse_to_replace;
use super::output::{Output, prepare_picture, print};
use super::terminal::print_message;
use crate::assets::read_file;
use crate::image_io::{Difference, Format, Picture, compare, decode, difference_picture, encode};

/// Compares two pictures: [`Exit::Fine`] if they are equal, [`Exit::Negative`] if not.
pub(super) fn run(arguments: &DiffArguments) -> CommandResult {
    // The place of the result is checked before the work.
    let output = arguments.output.as_deref().map(|path| prepare_picture(path, None)).transpose()?;
    if let Some((output, _)) = &output {
        for compared in [&arguments.a, &arguments.b] {
            refuse_to_replace(output, "the picture of the difference", "the picture", compared)?;
        }
    }
    let (a, b) = (read(&arguments.a)?, read(&arguments.b)?);
    let compared = compare(&a, &b);
    if !arguments.quiet && !output.as_ref().is_some_and(|(output, _)| output.is_stdout()) {
        print(&match &compared {
            Ok(difference) => verdict(difference, &a),
            Err(sizes) => format!("different: {sizes}\n"),
        })?;
    }
    if compared.is_ok_and(|difference| difference.differing == 0) {
        return Ok(Exit::Fine);
    }
    if let Some((output, format)) = output {
        match difference_picture(&a, &b) {
            Ok(picture) => write(&picture, output, format)?,
            // Pictures of different sizes are different: a result, and no error.
            Err(_) => {
                print_message("no difference picture was written: it takes pictures of one size");
            }
        }
    }
    Ok(Exit::Negative)
}

fn read(path: &Path) -> Result<Picture, Failure> {
    let trouble = |why: &dyn std::fmt::Display| {
        Failure::new(format_args!("cannot read `{}`: {why}", path.display()))
    };
    // The file first: if it is missing, its extension matters less.
    let bytes = read_file(path).map_err(|error| match error.kind() {
        ErrorKind::NotFound => trouble(&"there is no such file"),
        _ => trouble(&error),
    })?;
    let format = Format::from_path(path).map_err(|error| trouble(&error))?;
    decode(&bytes, format).map_err(|error| trouble(&error))
}

fn write(picture: &Picture, output: Output, format: Format) -> Result<(), Failure> {
    let bytes = encode(picture, format).map_err(Failure::new)?;
    output.write(|to| to.write_all(&bytes)).map_err(Failure::from)
}

/// What is printed about two pictures of the same size.
fn verdict(difference: &Difference, picture: &Picture) -> String {
    let pixels = u64::from(picture.width) * u64::from(picture.height);
    let size = format!("{} × {} pixels", picture.width, picture.height);
    if difference.differing == 0 {
        return format!("equal: {size}\n");
    }
    let share = 100.0 * difference.differing as f64 / pixels as f64;
    let first =
        difference.first.map_or(String::new(), |(x, y)| format!(", the first at ({x}, {y})"));
    format!(
        "different: {} of {pixels} pixels ({share:.3} %) of {size}{first}\n\
         largest difference {:.6}, mean {:.3e}, root mean square {:.3e}\n",
        difference.differing, difference.largest, difference.mean, difference.rmse,
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    fn picture() -> Picture {
        Picture { width: 20, height: 10, pixels: vec![crate::math::Color::ZERO; 200] }
    }

    #[test]
    fn equal_pictures() {
        assert_eq!(verdict(&Difference::default(), &picture()), "equal: 20 × 10 pixels\n");
    }

    #[test]
    fn different_pictures() {
        let difference = Difference {
            differing: 3,
            largest: 0.5,
            mean: 0.00125,
            rmse: 0.025,
            first: Some((4, 7)),
        };
        assert_eq!(
            verdict(&difference, &picture()),
            "different: 3 of 200 pixels (1.500 %) of 20 × 10 pixels, the first at (4, 7)\n\
             largest difference 0.500000, mean 1.250e-3, root mean square 2.500e-2\n"
        );
    }
}
