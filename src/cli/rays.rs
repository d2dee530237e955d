//! `srt rays`: what is in a file of rays, and other programs' rays. What the bytes mean is for
//! [`ray_file`](crate::ray_file) to say.

use std::path::Path;

use super::exit::{CommandResult, Exit, Failure};
use super::inputs::{refuse_to_replace, refuse_to_replace_a_mesh};
use super::load::{load, print_load_error};
use super::output::{Output, print};
use super::ray_files::read;
use super::rays_args::{ExportArguments, Format, ImportArguments, RaysArguments, RaysCommand};
use super::terminal::print_message;
use crate::assets::read_file;
use crate::compare::answered_rays;
use crate::math::Ray;
use crate::ray_file::{ClassRays, RayFile, rodent, tinybvh};
use crate::report::terminal_table;
use crate::report::{Cell, Table, numbers};
use crate::sealed::hexadecimal;

/// Does what was typed.
pub(super) fn run(arguments: &RaysArguments) -> CommandResult {
    match &arguments.command {
        RaysCommand::Info(info) => {
            print(&listing(&read(&info.file)?))?;
            Ok(Exit::Fine)
        }
        RaysCommand::Export(arguments) => export(arguments),
        RaysCommand::Import(arguments) => import(arguments),
    }
}

/// The classes and the hashes of a file.
fn listing(file: &RayFile) -> String {
    let mut table = Table::new("", "", &["class", "query", "#rays", "#hits", "#t from", "#t to"]);
    table.rows = file.classes.iter().map(row).collect();
    let classes = terminal_table(&table).replace(['\u{a0}', '\u{202f}'], " ");
    format!(
        "{classes}\nrays      SHA-256 {}\ngeometry  SHA-256 {}\n",
        hexadecimal(&file.hash()),
        hexadecimal(&file.geometry)
    )
}

fn row(own: &ClassRays) -> Vec<Cell> {
    let least = own.rays.iter().map(|ray| ray.t_min).reduce(f32::min);
    let most = own.rays.iter().map(|ray| ray.t_max).reduce(f32::max);
    let number = |number: Option<f32>| number.map_or_else(String::new, |t| format!("{t:?}"));
    let cells = [
        own.class.name().to_owned(),
        own.answers.query().to_owned(),
        numbers::whole(own.rays.len() as u64),
        numbers::whole(own.answers.hit_count() as u64),
        number(least),
        number(most),
    ];
    cells.map(Cell::text).into()
}

/// Writes a class in another program's form.
fn export(arguments: &ExportArguments) -> CommandResult {
    let output = Output::prepare(&arguments.output)?;
    refuse_to_replace(&output, "the output", "the rays", &arguments.file)?;
    let file = read(&arguments.file)?;
    let own = chosen(arguments, &file)?;
    let name = arguments.format.name();
    let trouble = |error: &dyn std::fmt::Display| {
        Failure::new(format_args!("cannot write the {} rays for {name}: {error}", own.class.name()))
    };
    let bytes = match arguments.format {
        Format::Rodent => {
            let (bytes, [t_min, t_max]) =
                rodent::encode(&own.rays).map_err(|error| trouble(&error))?;
            let any = if own.answers.query() == "any hit" { "-any " } else { "" };
            print_message(format_args!("for rodent: {any}--tmin {t_min:?} --tmax {t_max:?}"));
            if own.rays.len() % rodent::LARGEST_PACKET != 0 {
                print_message(
                    "note: their number is no multiple of 8: rodent's packets leave the last ones out",
                );
            }
            bytes
        }
        Format::TinyBvh => tinybvh::encode(&own.rays).map_err(|error| trouble(&error))?,
    };
    output.write(|to| to.write_all(&bytes))?;
    Ok(Exit::Fine)
}

/// The class that was named, or the only one.
fn chosen<'a>(arguments: &ExportArguments, file: &'a RayFile) -> Result<&'a ClassRays, Failure> {
    let names = || file.classes.iter().map(|own| own.class.name()).collect::<Vec<_>>().join(", ");
    let path = arguments.file.display();
    match (arguments.class, &file.classes[..]) {
        (Some(class), _) => file.class(class).ok_or_else(|| {
            Failure::new(format_args!("`{path}` has no {} rays; it has: {}", class.name(), names()))
        }),
        (None, [only]) => Ok(only),
        (None, []) => Err(Failure::new(format_args!("`{path}` has no rays"))),
        (None, _) => Err(Failure::new(format_args!(
            "`{path}` has rays of several classes, and {} holds one: give --class; it has: {}",
            arguments.format.name(),
            names()
        ))),
    }
}

/// Reads another program's rays, traces them, and writes them.
fn import(arguments: &ImportArguments) -> CommandResult {
    let output = Output::prepare(&arguments.output)?;
    refuse_to_replace(&output, "the output", "the rays", &arguments.input)?;
    refuse_to_replace(&output, "the output", "the scene", &arguments.scene)?;
    let rays = foreign_rays(arguments)?;
    if rays.is_empty() {
        let path = arguments.input.display();
        return Err(Failure::new(format_args!("`{path}` has no rays: there is nothing to import")));
    }
    let loaded = match load(&arguments.scene, false) {
        Ok(described) => described.loaded,
        Err(error) => {
            print_load_error(&error);
            return Ok(Exit::Trouble);
        }
    };
    refuse_to_replace_a_mesh(&output, "the output", &loaded)?;
    let count = rays.len();
    let classes = vec![(arguments.class, arguments.query, rays)];
    let file = answered_rays(&loaded.scene, classes).map_err(Failure::new)?;
    output.write(|to| to.write_all(&file.encode()))?;
    let hits: usize = file.classes.iter().map(|own| own.answers.hit_count()).sum();
    let hash = hexadecimal(&file.hash());
    print_message(format_args!("{count} rays, {hits} of them hit something; SHA-256 {hash}"));
    Ok(Exit::Fine)
}

fn foreign_rays(arguments: &ImportArguments) -> Result<Vec<Ray>, Failure> {
    let path: &Path = &arguments.input;
    let trouble = |why: &dyn std::fmt::Display| {
        let name = arguments.format.name();
        Failure::new(format_args!("cannot read the rays `{}` as {name}'s: {why}", path.display()))
    };
    let bytes = read_file(path).map_err(|error| trouble(&error))?;
    let interval = [arguments.t_min, arguments.t_max.unwrap_or(f32::MAX)];
    match arguments.format {
        Format::Rodent => rodent::decode(&bytes, interval).map_err(|error| trouble(&error)),
        Format::TinyBvh => tinybvh::decode(&bytes).map_err(|error| trouble(&error)),
    }
}
