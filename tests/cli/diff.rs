//! `srt diff`: 0 equal, 1 different, 2 trouble.

use crate::support::{folder, names, picture, rendered, run_in};

#[test]
fn equal_pictures_in_different_formats() {
    let folder = folder();
    rendered(folder.path(), "a.png", &[]);
    rendered(folder.path(), "b.tga", &["--accel", "ball"]);
    let run = run_in(folder.path(), &["diff", "a.png", "b.tga", "-o", "d.png"]);
    assert_eq!((run.code, run.stdout.as_str()), (0, "equal: 40 × 30 pixels\n"), "{}", run.stderr);
    assert_eq!(names(folder.path()), ["a.png", "b.tga", "scene.sce"], "no difference, no picture");
}

#[test]
fn different_pictures_and_where_they_differ() {
    let folder = folder();
    rendered(folder.path(), "a.png", &["--aa", "0"]);
    rendered(folder.path(), "b.png", &["--aa", "0", "--max-recursion", "0"]);
    let run = run_in(folder.path(), &["diff", "a.png", "b.png", "-o", "d.png"]);
    assert_eq!(run.code, 1, "{}", run.stderr);
    assert!(run.stdout.starts_with("different: "), "{}", run.stdout);
    for part in [" of 1200 pixels (", "the first at (", "largest difference 0.", "mean "] {
        assert!(run.stdout.contains(part), "{part}: {}", run.stdout);
    }
    let difference = picture(&folder.path().join("d.png"));
    assert_eq!(difference.get(0, 0).unwrap().max_element(), 0.0, "the sky is no mirror");
    assert!(difference.pixels.iter().any(|p| p.max_element() > 0.9), "scaled to be seen");
    let quiet = run_in(folder.path(), &["diff", "a.png", "b.png", "--quiet"]);
    assert_eq!((quiet.code, quiet.stdout.as_str(), quiet.stderr.as_str()), (1, "", ""));
}

#[test]
fn pictures_of_different_sizes_are_different() {
    let folder = folder();
    rendered(folder.path(), "a.png", &[]);
    rendered(folder.path(), "b.png", &["--size", "30x40"]);
    let run = run_in(folder.path(), &["diff", "a.png", "b.png", "-o", "d.png"]);
    assert_eq!(run.code, 1);
    assert!(run.stdout.contains("differ in size: 40 × 30 and 30 × 40"), "{}", run.stdout);
    assert!(run.stderr.contains("no difference picture was written"), "{}", run.stderr);
    assert_eq!(names(folder.path()), ["a.png", "b.png", "scene.sce"]);
}

#[test]
fn what_is_no_picture_is_trouble() {
    let folder = folder();
    rendered(folder.path(), "a.png", &[]);
    std::fs::write(folder.path().join("b.png"), "no picture").unwrap();
    for (name, part) in [
        ("b.png", "cannot read `b.png`: not a .png picture"),
        ("missing.png", "cannot read `missing.png`: "),
        ("scene.sce", "cannot read `scene.sce`: unknown picture format `.sce`"),
    ] {
        let run = run_in(folder.path(), &["diff", "a.png", name]);
        assert_eq!(run.code, 2, "{}", run.stdout);
        assert!(run.stderr.contains(part), "{}", run.stderr);
    }
}

#[test]
fn no_picture_that_is_compared_is_replaced() {
    let folder = folder();
    let a = rendered(folder.path(), "a.png", &[]);
    let b = rendered(folder.path(), "b.png", &["--max-recursion", "0"]);
    for name in ["a.png", "b.png"] {
        let run = run_in(folder.path(), &["diff", "a.png", "b.png", "-o", name]);
        assert_eq!(run.code, 2, "{}", run.stdout);
        let reason = format!("would replace the picture `{name}`");
        assert!(run.stderr.contains(&reason), "{}", run.stderr);
    }
    let read = |name: &str| std::fs::read(folder.path().join(name)).unwrap();
    assert!(read("a.png") == a && read("b.png") == b);
}

#[test]
fn the_formats_of_difference_pictures_are_named_without_an_option() {
    let folder = folder();
    rendered(folder.path(), "a.png", &[]);
    let run = run_in(folder.path(), &["diff", "a.png", "a.png", "-o", "d.jpg"]);
    assert_eq!(run.code, 2);
    assert!(run.stderr.contains("unknown picture format `.jpg`"), "{}", run.stderr);
    assert!(!run.stderr.contains("--format"), "{}", run.stderr);
}
