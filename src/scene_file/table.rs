//! The commands of the scene format, one row each.
//!
//! The parser, its messages and the documents read this table; to add a command, add a row here
//! and the function that it names. The order is that of the format's description.

use super::camera;
use super::command::{Command, Group, Kind, Value};
use super::entities;
use super::repeat;
use super::scopes;
use super::state;
use crate::description::{Camera, Options};

/// Every command, in the order of the format's description.
pub const COMMANDS: &[Command] = &[
    Command {
        keyword: "eyepos",
        group: Group::Camera,
        values: &[number("x"), number("y"), number("z")],
        summary: "the eye",
        example: "eyepos 0 -5 1.5",
        also_called: &["eye", "camera", "lookfrom"],
        apply: camera::eye_position,
    },
    Command {
        keyword: "eyedir",
        group: Group::Camera,
        values: &[number("x"), number("y"), number("z")],
        summary: "the direction of view, of any length",
        example: "eyedir 0 1 -0.2",
        also_called: &["lookat"],
        apply: camera::eye_direction,
    },
    Command {
        keyword: "eyeup",
        group: Group::Camera,
        values: &[number("x"), number("y"), number("z")],
        summary: "what is up in the picture, of any length, not parallel to eyedir",
        example: "eyeup 0 0 1",
        also_called: &["up", "sky"],
        apply: camera::eye_up,
    },
    Command {
        keyword: "wdist",
        group: Group::Camera,
        values: &[value("distance", Kind::Positive)],
        summary: "the distance from the eye to the image plane",
        example: "wdist 1",
        also_called: &[],
        apply: camera::distance,
    },
    Command {
        keyword: "fovy_deg",
        group: Group::Camera,
        values: &[value("angle", Kind::FieldOfView)],
        summary: "the full vertical field of view in degrees",
        example: "fovy_deg 40",
        also_called: &["fov", "fovx_deg", "angle"],
        apply: camera::field_of_view,
    },
    Command {
        keyword: "nx",
        group: Group::Camera,
        values: &[value("width", Kind::Whole(1, Camera::MAX_SIDE))],
        summary: "the width of the picture in pixels",
        example: "nx 600",
        also_called: &["width"],
        apply: camera::width,
    },
    Command {
        keyword: "ny",
        group: Group::Camera,
        values: &[value("height", Kind::Whole(1, Camera::MAX_SIDE))],
        summary: "the height of the picture in pixels",
        example: "ny 400",
        also_called: &["height"],
        apply: camera::height,
    },
    Command {
        keyword: "max_recursion",
        group: Group::Options,
        values: &[value("bounces", Kind::Whole(0, Options::MAX_RECURSION))],
        summary: "how many mirror bounces a view ray may take; 1 where nothing is said",
        example: "max_recursion 4",
        also_called: &["maxdepth", "max_depth", "recursion"],
        apply: camera::max_recursion,
    },
    Command {
        keyword: "aasample",
        group: Group::Options,
        values: &[value("n", Kind::Whole(0, Options::MAX_AA))],
        summary: "n × n samples a pixel, or one ray through its centre for 0, as where nothing is said",
        example: "aasample 4",
        also_called: &["samples"],
        apply: camera::aa_samples,
    },
    Command {
        keyword: "background",
        group: Group::Options,
        values: COLOR,
        summary: "what a ray that hits nothing sees; black where nothing is said",
        example: "background 0.5 0.7 1",
        also_called: &["bg"],
        apply: camera::background,
    },
    Command {
        keyword: "{",
        group: Group::Structure,
        values: &[],
        summary: "saves the material and the transform",
        example: "{",
        also_called: &[],
        apply: scopes::open_brace,
    },
    Command {
        keyword: "}",
        group: Group::Structure,
        values: &[],
        summary: "restores the material and the transform",
        example: "}",
        also_called: &[],
        apply: scopes::close_brace,
    },
    Command {
        keyword: "push_matrix",
        group: Group::Structure,
        values: &[],
        summary: "saves the transform",
        example: "push_matrix",
        also_called: &["push"],
        apply: scopes::push_matrix,
    },
    Command {
        keyword: "pop_matrix",
        group: Group::Structure,
        values: &[],
        summary: "restores the transform",
        example: "pop_matrix",
        also_called: &["pop"],
        apply: scopes::pop_matrix,
    },
    Command {
        keyword: "repeat",
        group: Group::Structure,
        values: &[value("turns", Kind::Whole(1, repeat::MOST_OBJECTS))],
        summary: "carries out the lines up to its end_repeat so many times; the transform goes on from turn to turn",
        example: "repeat 1000",
        also_called: &["for", "loop", "times"],
        apply: repeat::acted_on_by_the_recorder,
    },
    Command {
        keyword: "end_repeat",
        group: Group::Structure,
        values: &[],
        summary: "ends the lines of the innermost repeat",
        example: "end_repeat",
        also_called: &["endrepeat", "end_for", "end_loop"],
        apply: repeat::acted_on_by_the_recorder,
    },
    Command {
        keyword: "end",
        group: Group::Structure,
        values: &[],
        summary: "ends the scene; what follows is not read",
        example: "end",
        also_called: &["quit", "exit"],
        apply: scopes::end,
    },
    Command {
        keyword: "ca",
        group: Group::Material,
        values: COLOR,
        summary: "the ambient light's colour",
        example: "ca 0.1 0.1 0.1",
        also_called: &["ambient"],
        apply: state::ambient_light,
    },
    Command {
        keyword: "cr",
        group: Group::Material,
        values: COLOR,
        summary: "the diffuse and ambient reflectance",
        example: "cr 0.8 0.3 0.2",
        also_called: &["diffuse", "color", "colour"],
        apply: state::reflectance,
    },
    Command {
        keyword: "cp",
        group: Group::Material,
        values: COLOR,
        summary: "the specular reflectance; black means neither highlight nor mirror",
        example: "cp 0.5 0.5 0.5",
        also_called: &["specular"],
        apply: state::specular,
    },
    Command {
        keyword: "shininess",
        group: Group::Material,
        values: &[value("exponent", Kind::NotNegative)],
        summary: "the Phong exponent",
        example: "shininess 50",
        also_called: &["phong"],
        apply: state::shininess,
    },
    Command {
        keyword: "alpha",
        group: Group::Material,
        values: &[value("opacity", Kind::Share)],
        summary: "the opacity, from 0 (clear) to 1 (opaque)",
        example: "alpha 0.3",
        also_called: &["opacity"],
        apply: state::alpha,
    },
    Command {
        keyword: "ri",
        group: Group::Material,
        values: &[value("index", Kind::Positive)],
        summary: "the index of refraction of the inside",
        example: "ri 1.5",
        also_called: &["ior"],
        apply: state::refractive_index,
    },
    Command {
        keyword: "translate",
        group: Group::Transform,
        values: &[number("x"), number("y"), number("z")],
        summary: "moves what follows",
        example: "translate 0 0 1",
        also_called: &["move"],
        apply: state::translate,
    },
    Command {
        keyword: "rotate",
        group: Group::Transform,
        values: &[number("degrees"), number("x"), number("y"), number("z")],
        summary: "turns what follows about an axis through the origin, of any length",
        example: "rotate 90 0 0 1",
        also_called: &[],
        apply: state::rotate,
    },
    Command {
        keyword: "scale",
        group: Group::Transform,
        values: &[
            value("x", Kind::ScaleFactor),
            value("y", Kind::ScaleFactor),
            value("z", Kind::ScaleFactor),
        ],
        summary: "stretches what follows along the axes",
        example: "scale 1 1 0.5",
        also_called: &[],
        apply: state::scale,
    },
    Command {
        keyword: "ball",
        group: Group::Object,
        values: &[value("radius", Kind::Positive), number("x"), number("y"), number("z")],
        summary: "a ball about a point",
        example: "ball 0.5 0 0 1",
        also_called: &["sphere"],
        apply: entities::ball,
    },
    Command {
        keyword: "cylinder",
        group: Group::Object,
        values: &[],
        summary: "the cylinder of radius 1 about the z axis from z = 0 to z = 1, with both caps",
        example: "cylinder",
        also_called: &["tube"],
        apply: entities::cylinder,
    },
    Command {
        keyword: "triangle",
        group: Group::Object,
        values: &[
            number("x0"),
            number("y0"),
            number("z0"),
            number("x1"),
            number("y1"),
            number("z1"),
            number("x2"),
            number("y2"),
            number("z2"),
        ],
        summary: "one triangle",
        example: "triangle 0 0 0  1 0 0  0 1 0",
        also_called: &["face", "polygon"],
        apply: entities::triangle,
    },
    Command {
        keyword: "object_flat",
        group: Group::Object,
        values: &[value("file", Kind::Name)],
        summary: "a Wavefront OBJ mesh, one normal a face",
        example: "object_flat bunny.obj",
        also_called: &["mesh", "object", "obj", "model"],
        apply: entities::mesh_flat,
    },
    Command {
        keyword: "object_phong",
        group: Group::Object,
        values: &[value("file", Kind::Name)],
        summary: "a Wavefront OBJ mesh, its normals interpolated over each face",
        example: "object_phong bunny.obj",
        also_called: &["object_smooth"],
        apply: entities::mesh_phong,
    },
    Command {
        keyword: "pointlight",
        group: Group::Light,
        values: &[number("x"), number("y"), number("z"), number("r"), number("g"), number("b")],
        summary: "light from one point",
        example: "pointlight 2 -3 5  1 1 1",
        also_called: &["light", "point_light"],
        apply: entities::point_light,
    },
    Command {
        keyword: "arealight",
        group: Group::Light,
        values: &[value("h", Kind::Positive), number("r"), number("g"), number("b")],
        summary: "light from the square [−h, h]² of the plane z = 0",
        example: "arealight 0.5 1 1 1",
        also_called: &["area_light"],
        apply: entities::area_light,
    },
];

/// The values of a colour. Any finite number will do: lights may be brighter than 1, and the
/// original accepts lights that darken.
const COLOR: &[Value] = &[number("r"), number("g"), number("b")];

const fn number(name: &'static str) -> Value {
    value(name, Kind::Number)
}

const fn value(name: &'static str, kind: Kind) -> Value {
    Value { name, kind }
}

/// The command with a keyword.
pub(super) fn find(keyword: &str) -> Option<&'static Command> {
    COMMANDS.iter().find(|c| c.keyword == keyword)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keywords_are_different_and_examples_are_of_their_command() {
        for (i, command) in COMMANDS.iter().enumerate() {
            assert!(COMMANDS[..i].iter().all(|c| c.keyword != command.keyword));
            let words: Vec<_> = command.example.split_whitespace().collect();
            assert_eq!(words[0], command.keyword);
            assert_eq!(words.len() - 1, command.values.len(), "{}", command.example);
            assert!(command.also_called.iter().all(|word| find(word).is_none()));
        }
    }
}
