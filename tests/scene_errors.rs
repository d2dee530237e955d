//! Every bad scene has its messages. A case is a file in `tests/bad_scenes`; its expected text, a
//! file in `tests/snapshots`, is written by `INSTA_UPDATE=always cargo test --test scene_errors`
//! and read by a person before it is committed.

use std::path::Path;

use srt::scene_file::{
    Diagnostic, ParseOptions, parse, parse_to_meshes, render_diagnostics, summarize,
};

#[test]
fn every_bad_scene_has_its_messages() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/bad_scenes");
    let mut cases: Vec<_> = std::fs::read_dir(folder).unwrap().map(|e| e.unwrap().path()).collect();
    cases.sort();
    assert!(cases.len() > 30);
    for case in cases {
        let name = case.file_stem().unwrap().to_str().unwrap().to_owned();
        let source = std::fs::read_to_string(&case).unwrap();
        insta::with_settings!({ prepend_module_to_snapshot => false, omit_expression => true }, {
            insta::assert_snapshot!(name.clone(), report(&source, &format!("{name}.sce")));
        });
    }
}

#[test]
fn unknown_commands_are_warnings_in_lenient_mode() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/bad_scenes");
    let source = std::fs::read_to_string(folder.join("unknown_command.sce")).unwrap();
    // Its `pushmatrix` is skipped, so its `pop_matrix` has nothing to restore.
    let source = source.replace("pop_matrix\n", "");
    let parsed =
        parse(&source, &ParseOptions { lenient: true, ..ParseOptions::default() }).unwrap();
    let text = render_diagnostics(&parsed.warnings, &source, "lenient.sce", false);
    insta::with_settings!({ prepend_module_to_snapshot => false, omit_expression => true }, {
        insta::assert_snapshot!("lenient", text);
    });
    assert_eq!(parsed.description.objects.len(), 1);
}

#[test]
fn the_meshes_of_a_bad_scene_are_known_where_their_lines_can_be_read() {
    let source = "sce1.0
object_flat a.obj
object_flat b.obj c.obj
object_phong \"d.obj
object_flt \"e f.obj\"
object_phong a.obj
bal 1 0 0 0
repeat 3
    scale 0 1 1
    object_flat g.obj
end_repeat
repeat 2
    object_flat h.obj
end
object_flat i.obj
";
    let invalid = parse_to_meshes(source, &ParseOptions::default()).unwrap_err();
    let names: Vec<_> = invalid.meshes.iter().map(|mesh| &mesh.name[..]).collect();
    assert_eq!(names, ["a.obj", "e f.obj", "g.obj", "h.obj"]);
    let places: Vec<_> = invalid.meshes.iter().map(|mesh| &source[mesh.span.clone()]).collect();
    assert_eq!(places, ["a.obj", "\"e f.obj\"", "g.obj", "h.obj"]);
    let no_scene = parse_to_meshes("v 0 0 0\nobject_flat a.obj\n", &ParseOptions::default());
    assert!(no_scene.unwrap_err().meshes.is_empty());
}

#[test]
fn what_is_skipped_leniently_names_no_mesh() {
    let options = ParseOptions { lenient: true, ..ParseOptions::default() };
    let invalid = parse_to_meshes("sce1.0\nobject_flt a.obj\nball\n", &options).unwrap_err();
    assert!(invalid.meshes.is_empty());
}

#[test]
fn colour_changes_nothing_but_colour() {
    let source = "sce1.0\nbal\n";
    let diagnostics = parse(source, &ParseOptions::default()).unwrap_err();
    let colored = render_diagnostics(&diagnostics, source, "a.sce", true);
    assert!(colored.contains("\u{1b}["));
    let plain = render_diagnostics(&diagnostics, source, "a.sce", false);
    assert!(!plain.contains('\u{1b}'));
}

/// What a user reads of a scene: its diagnostics, and how many they are.
fn report(source: &str, name: &str) -> String {
    let diagnostics: Vec<Diagnostic> = match parse(source, &ParseOptions::default()) {
        Ok(parsed) => parsed.warnings,
        Err(diagnostics) => diagnostics,
    };
    assert!(!diagnostics.is_empty(), "{name} is not a bad scene");
    let text = render_diagnostics(&diagnostics, source, name, false);
    format!("{text}\n{name}: {}\n", summarize(&diagnostics))
}
