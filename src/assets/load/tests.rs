//! Files, folders and recipes: what is shared, and the errors when something is missing.

use std::fs;

use super::*;

const TRIANGLE: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

fn references(names: &[&str]) -> Vec<MeshReference> {
    names.iter().map(|name| MeshReference::new(*name)).collect()
}

fn folder_with(files: &[(&str, &[u8])]) -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    for (name, bytes) in files {
        fs::write(folder.path().join(name), bytes).unwrap();
    }
    folder
}

#[test]
fn names_of_one_mesh_share_it() {
    let folder = folder_with(&[("a.obj", TRIANGLE.as_bytes()), ("b.ob", TRIANGLE.as_bytes())]);
    let names =
        ["a.obj", "./a.obj", "b.ob", "generate:soup:9", "generate:soup:9:0", "generate:soup:9:1"];
    let meshes = load_meshes(&references(&names), folder.path()).unwrap();
    assert!(Arc::ptr_eq(&meshes[0], &meshes[1]) && !Arc::ptr_eq(&meshes[0], &meshes[2]));
    assert!(Arc::ptr_eq(&meshes[3], &meshes[4]) && !Arc::ptr_eq(&meshes[3], &meshes[5]));
    assert_eq!(meshes[0], meshes[2]);
    assert_eq!(meshes[5].triangles.len(), 9);
}

#[test]
fn every_mesh_that_cannot_be_loaded_is_an_error() {
    let folder = folder_with(&[
        ("bunny.obj", TRIANGLE.as_bytes()),
        ("bad.obj", b"v 0 0 0\nf 1 2 3\n"),
        ("empty.obj", b"\n"),
        ("points.obj", b"v 0 0 0\n"),
        ("flat.obj", b"v 0 0 0\nv 1 1 1\nf 1 2 2\n"),
        ("latin.obj", b"v 0 0 0\n# cr\xe9\xe9\n"),
    ]);
    fs::create_dir(folder.path().join("meshes")).unwrap();
    let names = [
        "bunny.obj",
        "buny.obj",
        "nothing/x.obj",
        "meshes",
        "bad.obj",
        "empty.obj",
        "points.obj",
        "flat.obj",
        "latin.obj",
        "generate:hal:10",
        "generate:hall:0",
        "zzz.obj",
        "bad.obj",
    ];
    let errors = load_meshes(&references(&names), folder.path()).unwrap_err();
    assert_eq!(check_meshes(&references(&names), folder.path()), errors);
    let LoadedMeshes { meshes, .. } = load_each_mesh(&references(&names), folder.path());
    assert!(meshes[0].is_some() && meshes[1..].iter().all(Option::is_none));
    let messages: Vec<String> = errors
        .iter()
        .map(|error| {
            let place = error.place.as_ref().map(|p| format!(" [{}: {}]", p.line, p.text));
            let help = error.help.as_deref().unwrap_or_default();
            format!("{} {error}{} ({help})", error.reference, place.unwrap_or_default())
        })
        .collect();
    let root = format!("{}{}", folder.path().display(), std::path::MAIN_SEPARATOR);
    insta::assert_snapshot!(messages.join("\n").replace(&root, ""));
}

#[test]
fn a_check_generates_nothing() {
    let folder = folder_with(&[]);
    let names = references(&["generate:icosphere:1k", "generate:hall:none", "generate:soup:2"]);
    let bytes = |source: &Source<'_>| source.bytes();
    let (done, errors) = each(&names, folder.path().into(), bytes, |source| source.check());
    assert_eq!(done, [Some(()), None, Some(())]);
    assert_eq!(errors[0].reference, 1);
}

#[test]
fn the_word_that_is_wrong_is_marked() {
    let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    let marked = |line: &str| {
        let folder = folder_with(&[("a.obj", format!("{text}{line}\nf 1 2 -1\n").as_bytes())]);
        let errors = load_meshes(&references(&["a.obj"]), folder.path()).unwrap_err();
        let place = errors[0].place.as_ref().unwrap();
        assert_eq!(place.line, 4, "{line}");
        place.wrong.clone().map(|wrong| place.text[wrong].to_owned())
    };
    for (line, word) in [
        ("v 1 zero 0", "zero"),
        ("  v 0 1 nan # nan", "nan"),
        ("v 0 0 1 w", "w"),
        ("f 1 1 4 4", "4"),
        ("f 1 2 0/0 3", "0/0"),
        ("f 1//1 2 3", "1//1"),
        ("f 1 2 -9", "-9"),
        ("f 1 /2 3", "/2"),
        ("vn 0 é 0", "é"),
    ] {
        assert_eq!(marked(line).as_deref(), Some(word), "{line}");
    }
    for line in ["f 1 2", "v 0 0", "v 1 2 3 4 5", "f 1 2 \\\n 9"] {
        assert_eq!(marked(line), None, "{line}");
    }
}

#[test]
fn meshes_of_other_formats_are_recognized() {
    let mut binary = vec![0; 84];
    binary[80] = 2;
    binary.resize(84 + 2 * 50, 0xff);
    let folder = folder_with(&[
        ("a.ply", b"ply\nformat ascii 1.0\n"),
        ("b.stl", b"solid b\nfacet normal 0 0 1\n"),
        ("c.STL", &binary),
        ("d.obj", b"glTF\x02\x00\x00\x00"),
        ("e.stl", TRIANGLE.as_bytes()),
    ]);
    let problem = |name: &str| {
        let loaded = load_meshes(&references(&[name]), folder.path());
        loaded.err().map(|errors| match errors.into_iter().next() {
            Some(AssetError { problem: Problem::OtherFormat { format, .. }, .. }) => format,
            other => panic!("{name}: {other:?}"),
        })
    };
    let found = ["a.ply", "b.stl", "c.STL", "d.obj", "e.stl"].map(problem);
    assert_eq!(found, [Some("PLY"), Some("STL"), Some("STL"), Some("glTF"), None]);
}
