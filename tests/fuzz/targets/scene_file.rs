//! Text → description → compiled scene, or diagnostics that point into the text.
#![no_main]

use std::sync::{Arc, LazyLock};

use glam::Vec3;
use libfuzzer_sys::{Corpus, fuzz_mutator, fuzz_target};
use srt::assets::MeshData;
use srt::description::{
    Camera, Deformation, Light, MeshReference, Options, SceneDescription, Shape,
};
use srt::scene::Scene;
use srt::scene_file::{
    Diagnostic, ParseOptions, Parsed, commands, line_column, parse, render_diagnostics, summarize,
};
use srt_fuzz::is_one_of;

/// A `repeat` may do this much, and all that are nested in each other together. The library's own limit is reached in
/// seconds, too slow to try here.
const MOST_STEPS: f64 = 256.0;

/// For the objects and lights of a `repeat`.
const MEMORY: u64 = 1 << 16;

/// What every scene needs.
const CAMERA: &str =
    "sce1.0\neyepos 0 -5 1\neyedir 0 1 0\neyeup 0 0 1\nwdist 1\nfovy_deg 40\nnx 4\nny 3\n";

/// The example of each command.
static EXAMPLES: LazyLock<Vec<&str>> =
    LazyLock::new(|| commands().map(|command| command.example).collect());

fuzz_mutator!(|data: &mut [u8], size: usize, max_size: usize, seed: u32| {
    srt_fuzz::mutate_lines(data, (size, max_size, seed), CAMERA, &EXAMPLES)
});

fuzz_target!(|data: &[u8]| -> Corpus {
    let text = String::from_utf8_lossy(data);
    if steps(&text) > MOST_STEPS {
        return Corpus::Reject;
    }
    let parsed = parse(&text, &strictly());
    match &parsed {
        Ok(parsed) => check_scene(&text, parsed),
        Err(diagnostics) => check_errors(&text, diagnostics),
    }
    srt_fuzz::count(parsed.is_ok());
    Corpus::Keep
});

/// In a frame that lies between the keys of the examples.
fn strictly() -> ParseOptions {
    ParseOptions { lenient: false, memory: Some(MEMORY), frame: 7 }
}

/// A bound on the iterations of all `repeat`s, as if each were within the one before.
fn steps(text: &str) -> f64 {
    let count = |line: &str| {
        let number = line.trim_start().strip_prefix("repeat")?.trim_start();
        let end = number.find(|c: char| !matches!(c, '0'..='9' | '.' | 'e' | 'E' | '+' | '-'));
        number[..end.unwrap_or(number.len())].parse::<f64>().ok()
    };
    text.split(['\n', '\r']).filter_map(count).map(|count| count.max(1.0)).product()
}

fn check_errors(text: &str, diagnostics: &[Diagnostic]) {
    assert!(
        diagnostics.iter().any(Diagnostic::is_error),
        "nothing is wrong, and there is no scene"
    );
    check_diagnostics(text, diagnostics);
    if !is_one_of(4, text.as_bytes()) {
        return;
    }
    // What is read leniently alone has an unknown command. Other errors may follow from that: one that is nearly
    // `repeat` is taken for one.
    if let Ok(parsed) = parse(text, &ParseOptions { lenient: true, ..strictly() }) {
        assert!(diagnostics.iter().any(|error| error.message.starts_with("unknown command")));
        check_description(&parsed.description);
    }
}

/// Each is in one line, and its places are places of the text; shown, they cannot control a terminal.
fn check_diagnostics(text: &str, diagnostics: &[Diagnostic]) {
    for diagnostic in diagnostics {
        let places = diagnostic.related.iter().map(|(span, _)| span).chain([&diagnostic.span]);
        for span in places {
            assert!(text.get(span.clone()).is_some(), "{span:?} is no place of the text");
            let (line, column) = line_column(text, span.start);
            assert!(line >= 1 && column >= 1);
        }
        assert!(!diagnostic.message.is_empty() && !diagnostic.message.contains(['\n', '\r']));
    }
    assert!(diagnostics.is_sorted_by_key(|diagnostic| diagnostic.span.start));
    assert_eq!(summarize(diagnostics).is_empty(), diagnostics.is_empty());
    // It takes fifty times as long as all the rest.
    if !is_one_of(64, text.as_bytes()) {
        return;
    }
    let shown = render_diagnostics(diagnostics, text, "fuzz.sce", false);
    assert!(!shown.contains(|c: char| c.is_control() && c != '\n' && c != '\t'), "{shown:?}");
    assert_eq!(shown.is_empty(), diagnostics.is_empty());
}

fn check_scene(text: &str, parsed: &Parsed) {
    assert!(!parsed.warnings.iter().any(Diagnostic::is_error));
    check_diagnostics(text, &parsed.warnings);
    check_description(&parsed.description);
    check_compiled(&parsed.description);
    if !is_one_of(4, text.as_bytes()) {
        return;
    }
    // Lines that are set in mean the same, and so does what is read leniently.
    let set_in = text.replace('\n', "\n \t");
    for (text, lenient) in [(set_in.as_str(), false), (text, true)] {
        let again = parse(text, &ParseOptions { lenient, ..strictly() });
        let again = again.unwrap_or_else(|errors| panic!("another reading fails: {errors:?}"));
        assert_eq!(without_places(&again.description), without_places(&parsed.description));
    }
}

/// What stands at the fields of a description.
fn check_description(description: &SceneDescription) {
    let SceneDescription { camera, options, materials, meshes, objects, lights } = description;
    let sides = 1..=Camera::MAX_SIDE;
    assert!(sides.contains(&camera.width) && sides.contains(&camera.height));
    assert!(camera.distance > 0.0 && camera.fovy_degrees > 0.0 && camera.fovy_degrees < 180.0);
    assert!(camera.eye.is_finite() && camera.direction.is_finite() && camera.up.is_finite());
    assert!(camera.direction.cross(camera.up).length() > 0.0 || camera.direction.length() < 1e-100);
    assert!(options.max_recursion <= Options::MAX_RECURSION && options.aa <= Options::MAX_AA);
    assert!(options.background.is_finite());
    for (i, material) in materials.iter().enumerate() {
        let colors = [material.ambient_light, material.reflectance, material.specular];
        assert!(colors.iter().all(|color| color.is_finite()));
        assert!(material.shininess >= 0.0 && material.shininess.is_finite());
        assert!((0.0..=1.0).contains(&material.alpha));
        assert!(material.refractive_index > 0.0 && material.refractive_index.is_finite());
        assert!(!materials[..i].contains(material), "a material twice");
    }
    for (i, mesh) in meshes.iter().enumerate() {
        let same = |other: &MeshReference| {
            other.name == mesh.name && other.deformation.key() == mesh.deformation.key()
        };
        assert!(!meshes[..i].iter().any(same), "a mesh twice");
        let Deformation { twist, wave, explosion } = mesh.deformation;
        assert!(twist.is_finite() && explosion >= 0.0 && wave.length > 0.0);
        assert!(wave.amplitude.is_finite() && wave.phase.is_finite());
    }
    for object in objects {
        assert!(object.material < materials.len());
        if let Shape::Mesh { mesh, .. } = object.shape {
            assert!(mesh < meshes.len());
        }
    }
    for light in lights {
        let (Light::Point { color, .. } | Light::Area { color, .. }) = light;
        assert!(color.is_finite());
    }
}

fn without_places(description: &SceneDescription) -> SceneDescription {
    let mut description = description.clone();
    description.objects.iter_mut().for_each(|object| object.span = 0..0);
    description.meshes.iter_mut().for_each(|mesh| mesh.span = 0..0);
    description
}

/// With one triangle for each mesh, it compiles, or says which of its objects and lights does not.
fn check_compiled(description: &SceneDescription) {
    let positions = vec![Vec3::ZERO, Vec3::X, Vec3::Y];
    let mesh = Arc::new(MeshData::with_averaged_normals(positions, vec![[0, 1, 2]]));
    match Scene::new(description, vec![mesh; description.meshes.len()]) {
        Ok(scene) => {
            assert_eq!(scene.objects.len(), description.objects.len());
            assert!(scene.objects.is_empty() || !scene.bounds().is_empty());
        }
        Err(errors) => assert!(!errors.is_empty()),
    }
}
