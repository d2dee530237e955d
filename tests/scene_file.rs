//! Good scenes are read as they are meant, and no text whatever makes the parser or its messages panic.

use glam::{DAffine3, DVec3, Vec3};
use proptest::prelude::*;

use srt::description::{
    Camera, Light, Material, MeshReference, Normals, Object, Options, SceneDescription, Shape, Span,
};
use srt::scene_file::{Diagnostic, ParseOptions, Severity, commands, parse, render_diagnostics};
use srt::shapes::{Ball, Cylinder, Single, Triangle};

/// Every command, and everything that the format allows.
const FULL: &str = "\u{feff}sce1.0 # a scene with everything\r
# the camera\r
\teyepos 9 9 9\r
eyepos 0 -2 1.5    // e\r
eyedir 0 2. -.5#d
   eyeup +0 -0 1e-3
wdist 1
fovy_deg 40.5

nx 600
ny 4e2 // pixels
max_recursion 3
aasample 4.0
background .1 .2 .3
pointlight 1 2 3 1 1 1
ball 0.5 1 2 3
{  // a group
  cr 1 0 0
  cp 0.5 0.5 0.5
  ca 0 0 0
  shininess 20
  alpha 0.25
  ri 1.5
  translate 10 0 0
  push_matrix
    rotate 90 0 0 2
    scale 2 1 -1
    cylinder
    arealight 0.5 2 2 2
    triangle 0 0 0  1 0 0  0 1 0
    cr 0 1 0
  pop_matrix
  object_flat meshes//a#1.ob // a mesh
  object_phong \"my mesh.obj\"# another
} # end of the group
cr 1 1 1
object_phong meshes//a#1.ob
end
this is not read {";

#[test]
fn a_scene_with_everything_is_read_as_it_is_meant() {
    let parsed = parse(FULL, &ParseOptions::default()).unwrap();
    let warnings: Vec<_> = parsed.warnings.iter().map(|warning| &warning.message[..]).collect();
    assert_eq!(warnings, ["what follows `end` is not read"]);
    assert_eq!(FULL[parsed.warnings[0].span.clone()], *"this");
    let mut found = parsed.description;
    round(&mut found);
    assert_eq!(found, expected());
}

fn expected() -> SceneDescription {
    let moved = DAffine3::from_translation(DVec3::X * 10.0);
    let turned = DAffine3::from_cols(
        DVec3::new(0.0, 2.0, 0.0),
        DVec3::new(-1.0, 0.0, 0.0),
        DVec3::new(0.0, 0.0, -1.0),
        DVec3::new(10.0, 0.0, 0.0),
    );
    let corners = [Vec3::new(10.0, 0.0, 0.0), Vec3::new(10.0, 2.0, 0.0), Vec3::new(9.0, 0.0, 0.0)];
    let object = |shape, transform, material, text: &str| {
        let span = span_of(text);
        Object { shape, transform, material, span }
    };
    let red = Material {
        ambient_light: Vec3::ZERO,
        reflectance: Vec3::X,
        specular: Vec3::splat(0.5),
        shininess: 20.0,
        alpha: 0.25,
        refractive_index: 1.5,
    };
    let last = FULL.rfind("object_phong").expect("it is in the scene");
    SceneDescription {
        camera: Camera {
            eye: DVec3::new(0.0, -2.0, 1.5),
            direction: DVec3::new(0.0, 2.0, -0.5),
            up: DVec3::new(0.0, 0.0, 1e-3),
            distance: 1.0,
            fovy_degrees: 40.5,
            width: 600,
            height: 400,
        },
        options: Options { max_recursion: 3, aa: 4, background: Vec3::new(0.1, 0.2, 0.3) },
        materials: vec![Material::default(), red, Material { reflectance: Vec3::Y, ..red }],
        meshes: vec![
            MeshReference {
                span: span_of("meshes//a#1.ob"),
                ..MeshReference::new("meshes//a#1.ob")
            },
            MeshReference { span: span_of("\"my mesh.obj\""), ..MeshReference::new("my mesh.obj") },
        ],
        objects: vec![
            object(
                Single::Ball(Ball { radius: 0.5, center: Vec3::new(1.0, 2.0, 3.0) }).into(),
                DAffine3::IDENTITY,
                0,
                "ball 0.5 1 2 3",
            ),
            object(Single::Cylinder(Cylinder).into(), turned, 1, "cylinder"),
            object(
                Single::Triangle(Triangle::new(corners)).into(),
                DAffine3::IDENTITY,
                1,
                "triangle 0 0 0  1 0 0  0 1 0",
            ),
            // pop_matrix restores the transform, not the colour.
            object(
                Shape::Mesh { mesh: 0, normals: Normals::Flat },
                moved,
                2,
                "object_flat meshes//a#1.ob",
            ),
            object(
                Shape::Mesh { mesh: 1, normals: Normals::Interpolated },
                moved,
                2,
                "object_phong \"my mesh.obj\"",
            ),
            Object {
                shape: Shape::Mesh { mesh: 0, normals: Normals::Interpolated },
                transform: DAffine3::IDENTITY,
                material: 0,
                span: last..last + "object_phong meshes//a#1.ob".len(),
            },
        ],
        lights: vec![
            Light::Point { position: DVec3::new(1.0, 2.0, 3.0), color: Vec3::ONE },
            Light::Area {
                center: DVec3::new(10.0, 0.0, 0.0),
                half_u: DVec3::new(0.0, 1.0, 0.0),
                half_v: DVec3::new(-0.5, 0.0, 0.0),
                color: Vec3::splat(2.0),
            },
        ],
    }
}

/// The first place of a text in the scene with everything.
fn span_of(text: &str) -> Span {
    let start = FULL.find(text).expect("it is in the scene");
    start..start + text.len()
}

/// Rounds away what is left of the sine of a right angle.
fn round(scene: &mut SceneDescription) {
    let near = |v: &mut DVec3| *v = (*v * 1e12).round() * 1e-12;
    for object in &mut scene.objects {
        let columns = object.transform.to_cols_array().map(|x| (x * 1e12).round() * 1e-12);
        object.transform = DAffine3::from_cols_array(&columns);
        if let Shape::Single(Single::Triangle(Triangle { corners })) = &mut object.shape {
            for v in corners {
                *v = (*v * 1e6).round() * 1e-6;
            }
        }
    }
    for light in &mut scene.lights {
        if let Light::Area { half_u, half_v, .. } = light {
            near(half_u);
            near(half_v);
        }
    }
}

/// The objects of a scene of which the text is given without camera and light.
fn objects_of(text: &str) -> Vec<Object> {
    let camera = "eyepos 0 -5 1\neyedir 0 1 0\neyeup 0 0 1\nwdist 1\nfovy_deg 40\nnx 4\nny 3\n";
    let source = format!("sce1.0\n{camera}pointlight 0 0 5 1 1 1\n{text}");
    let parsed = parse(&source, &ParseOptions::default())
        .unwrap_or_else(|d| panic!("{}", render_diagnostics(&d, &source, "repeat.sce", false)));
    assert_eq!(parsed.warnings, []);
    parsed.description.objects
}

#[test]
fn what_is_repeated_equals_what_is_written_as_often() {
    let repeated = objects_of(
        "repeat 3\n translate 1 0 0\n repeat 2 # twice\n rotate 90 0 0 1\n {\n cr 1 0 0\n \
         scale 2 2 2\n cylinder\n }\n end_repeat\n cr 0 1 0\nball 1 0 0 0\nend_repeat\n\
         push_matrix\nrepeat 1\ntranslate 0 1 0\nend_repeat\npop_matrix\ncylinder\n",
    );
    let turn = "rotate 90 0 0 1\n{\ncr 1 0 0\nscale 2 2 2\ncylinder\n}\n".repeat(2);
    let once = format!("translate 1 0 0\n{turn}cr 0 1 0\nball 1 0 0 0\n");
    let written = objects_of(&format!("{}cylinder\n", once.repeat(3)));
    let without_place = |objects: Vec<Object>| -> Vec<Object> {
        objects.into_iter().map(|object| Object { span: 0..0, ..object }).collect()
    };
    assert_eq!(without_place(repeated), without_place(written));
}

#[test]
fn a_million_objects_take_few_lines() {
    let objects = objects_of(
        "repeat 1000\npush_matrix\nrepeat 1000\ntranslate 1 0 0\nball .1 0 0 0\nend_repeat\n\
         pop_matrix\ntranslate 0 1 0\nend_repeat\n",
    );
    assert_eq!(objects.len(), 1_000_000);
    let last = Ball { radius: 0.1, center: Vec3::new(1000.0, 999.0, 0.0) };
    assert_eq!(objects[999_999].shape, Single::Ball(last).into());
}

#[test]
fn options_left_out_have_their_defaults_and_the_end_may_lack() {
    let source = "sce1.0\neyepos 0 0 0\neyedir 0 1 0\neyeup 0 0 1\nwdist 1\nfovy_deg 40\nnx 6\nny 4\n\
                  ball 1 0 5 0\npointlight 0 0 0 -1 2 0";
    let parsed = parse(source, &ParseOptions::default()).unwrap();
    let options = Options { max_recursion: 1, aa: 0, background: Vec3::ZERO };
    assert_eq!(parsed.description.options, options);
    assert_eq!(parsed.warnings, []);
    let light = Light::Point { position: DVec3::ZERO, color: Vec3::new(-1.0, 2.0, 0.0) };
    assert_eq!(parsed.description.lights, [light]);
    // The same with the line ends of old, and of none at all.
    assert!(parse(&source.replace('\n', "\r"), &ParseOptions::default()).is_ok());
}

#[test]
fn materials_are_shared_across_scopes() {
    let source = FULL.replace("cr 0 1 0", "cr 1 -0 0");
    let parsed = parse(&source, &ParseOptions::default()).unwrap();
    assert_eq!(parsed.description.materials.len(), 2);
}

#[test]
fn the_formats_description_has_every_command() {
    let page = include_str!("../docs/scene-format.md");
    for command in commands() {
        let keyword = command.keyword;
        let alone = format!("`{keyword}`");
        assert!(page.contains(&alone) || page.contains(&format!("`{keyword} ")), "{alone}");
    }
}

/// Parses, and shows what there is to be shown.
fn survives(text: &str) {
    for lenient in [false, true] {
        match parse(text, &ParseOptions { lenient, ..ParseOptions::default() }) {
            Ok(parsed) => {
                assert!(parsed.warnings.iter().all(|w| !w.is_error()));
                let _ = render_diagnostics(&parsed.warnings, text, "a.sce", lenient);
            }
            Err(diagnostics) => {
                assert!(diagnostics.iter().any(Diagnostic::is_error));
                assert!(diagnostics.is_sorted_by_key(|d| d.span.start));
                for Diagnostic { span, .. } in &diagnostics {
                    assert!(text.get(span.clone()).is_some(), "{span:?} is no part of the text");
                }
                let _ = render_diagnostics(&diagnostics, text, "a.sce", lenient);
            }
        }
    }
}

/// A scene with one stretch of it replaced by something that belongs elsewhere, or nowhere.
fn mutated() -> impl Strategy<Value = String> {
    let words = prop::sample::select(vec![
        "",
        " ",
        "\n",
        "\r\n",
        "\r",
        "\t",
        "{",
        "}",
        "push_matrix",
        "pop_matrix\n",
        "end",
        "#",
        "//",
        "\"",
        "nan",
        "-1e999",
        "0",
        "1e-300",
        "scale 0 0 0\n",
        "scale 1e30 1e30 1e30\n",
        "translate 3e38 0 0\n",
        "rotate 1e30 0 1e-300 0\n",
        "ball 1 0 0 0\n",
        "cylinder\n",
        "é",
        "\u{feff}",
        "\u{0}",
        "sce1.0",
        "object_flat \"",
    ]);
    prop::collection::vec((any::<prop::sample::Index>(), 0..12_usize, words), 1..6).prop_map(
        |changes| {
            let mut text: Vec<char> = FULL.chars().collect();
            for (at, length, by) in changes {
                let at = at.index(text.len() + 1);
                let end = (at + length).min(text.len());
                text.splice(at..end, by.chars());
            }
            text.into_iter().collect()
        },
    )
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn no_text_stops_the_parser(text in any::<String>(), header in any::<bool>()) {
        survives(&if header { format!("sce1.0\n{text}") } else { text });
    }

    #[test]
    fn no_lines_of_words_stop_the_parser(text in "(sce1.0\n)?([a-z_{}#/\"\\-0-9. ]{0,9}[ \t\r\n]?){0,60}") {
        survives(&text);
    }

    #[test]
    fn no_mutation_stops_the_parser(text in mutated()) {
        survives(&text);
    }

    #[test]
    fn no_span_stops_the_messages(
        text in prop_oneof![any::<String>(), "[a\t\r\n é漢\u{301}\u{1b}]{0,400}"],
        spans in prop::collection::vec((0..500_usize, 0..500_usize), 1..5),
        message in any::<String>(),
        color in any::<bool>(),
    ) {
        let mut diagnostic = Diagnostic::error(spans[0].0..spans[0].1, message.clone());
        diagnostic.severity = if color { Severity::Error } else { Severity::Warning };
        let labels = diagnostic.clone().with_label(message.clone()).with_help(message.clone());
        let related = spans[1..].iter().fold(labels, |d, span| {
            d.with_related(span.0..span.1, message.clone())
        });
        let shown = render_diagnostics(&[diagnostic, related], &text, &message, color);
        let escapes = shown.contains('\u{1b}');
        prop_assert!(color || !escapes);
    }
}
