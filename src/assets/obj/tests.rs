//! What is read, what is refused, and that nothing panics.

use proptest::prelude::*;

use super::*;
use crate::assets::generate::{MeshKind, generate};

const TRIANGLE: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

fn mesh(text: &str) -> MeshData {
    read(text).unwrap_or_else(|fault| panic!("{text}\n{fault:?}"))
}

/// Line and message of what is wrong with a text.
fn fault(text: &str) -> (usize, String) {
    read(text).map_or_else(|fault| (fault.line, fault.what), |mesh| panic!("{text}\n{mesh:?}"))
}

/// The corners of every triangle, whatever the numbers of the vertices.
fn corners(mesh: &MeshData) -> Vec<[[Vec3; 2]; 3]> {
    let both = |t: &[u32; 3], n: &[u32; 3]| {
        [0, 1, 2].map(|i| [mesh.positions[t[i] as usize], mesh.normals[n[i] as usize]])
    };
    mesh.triangles.iter().zip(&mesh.normal_indices).map(|(t, n)| both(t, n)).collect()
}

#[test]
fn polygons_become_fans_and_negative_indices_count_back() {
    let square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
    let expected = mesh(&format!("{square}f 1 2 3\nf 1 3 4\n"));
    assert_eq!(expected.triangles, [[0, 1, 2], [0, 2, 3]]);
    for face in ["f 1 2 3 4", "f -4 -3 -2 -1", "f 1/7 2/8 3/9 4/1", "f 1 2 \\\n 3 4 # comment"] {
        assert_eq!(mesh(&format!("{square}{face}")), expected, "{face}");
    }
    let late = format!("f 1 2 3 4\n{square}");
    assert_eq!(mesh(&late), expected, "faces may come before their vertices");
    assert_eq!(mesh(&late.replace('\n', "\r\n")), expected);
    let pentagon = format!("{square}v -1 0.5 0\nf 1 2 3 4 5\n");
    assert_eq!(mesh(&pentagon).triangles.len(), 3);
}

#[test]
fn groups_share_their_vertices_and_lines_are_no_triangles() {
    let text = format!(
        "mtllib none.mtl\no a\n{TRIANGLE}v 1 1 1\nvt 0 0\nusemtl red\ng one\nf 1 2 3\n\
         usemtl blue\ng two\ns 1\nf 2/1 4/1 3/1\nl 1 2 3\np 1\n"
    );
    let mesh = mesh(&text);
    assert_eq!((mesh.positions.len(), mesh.triangles.len()), (4, 2));
    assert_ne!(mesh.normals[1], Vec3::Z, "smoothed over both groups");
}

#[test]
fn colours_and_weights_of_vertices_are_understood() {
    let colours = "v 0 0 0 1 0 0\nv 2 0 0 2\nv 0 1 0 0 0 1 # blue\nf 1 2 3";
    assert_eq!(mesh(colours).positions, [Vec3::ZERO, Vec3::X, Vec3::Y]);
}

#[test]
fn normals_of_the_file_are_kept_and_missing_ones_averaged() {
    let text = format!("{TRIANGLE}vn 0 0 2\nvn 1 0 0\nvn 0 0 0\n");
    let all = mesh(&format!("{text}f 1//2 2//1 3//-2"));
    let normal = |m: &MeshData, i: usize| m.normals[m.normal_indices[0][i] as usize];
    assert_eq!([0, 1, 2].map(|i| normal(&all, i)), [Vec3::X, Vec3::Z, Vec3::X]);
    // tobj alone would repeat the first normal in the places of the missing ones.
    for face in ["f 1//2 2 3", "f 1/1/2 2/1 3/1/", "f 1//2 2//3 3//3"] {
        let some = mesh(&format!("{text}{face}"));
        assert_eq!([0, 1, 2].map(|i| normal(&some, i)), [Vec3::X, Vec3::Z, Vec3::Z], "{face}");
    }
    let none = mesh(&format!("{text}f 1 2 3"));
    assert_eq!([0, 1, 2].map(|i| normal(&none, i)), [Vec3::Z; 3]);
}

#[test]
fn wrong_indices_are_found_with_their_line() {
    let cases = [
        ("f 0 1 2", "the vertex index is 0: indices start at 1"),
        ("f 1 2 -0", "the vertex index is 0: indices start at 1"),
        ("f 1 2 4", "the vertex index 4 is out of range: there are 3 in the file"),
        ("f 1 2 -4", "the vertex index -4 points 4 back, where there are 3 so far"),
        ("f 1 2 -5", "the vertex index -5 points 5 back, where there are 3 so far"),
        ("f 1 2 18446744073709551617", "the index 18446744073709551617 is out of range"),
        (
            "f 1 2 9999999999",
            "the vertex index 9999999999 is out of range: there are 3 in the file",
        ),
        ("f 1//0 2//1 3//1", "the normal index is 0: indices start at 1"),
        ("f 1//-2 2//1 3//1", "the normal index -2 points 2 back, where there is 1 so far"),
        ("f 1//2 2//1 3//1", "the normal index 2 is out of range: there is 1 in the file"),
        ("f 1//9223372036854775807 2 3", "the index 9223372036854775807 is out of range"),
        ("f /1/1 2 3", "the corner `/1/1` has no vertex"),
        (
            "f 1/2/3/4 2 3",
            "the corner `1/2/3/4` has more than a vertex, a texture and a normal index",
        ),
        ("f 1 2 x", "`x` is not an index"),
        ("f 1 2 3.5", "`3.5` is not an index"),
        ("f 1 2 3\u{a0}1", "`3\u{a0}1` is not an index"),
        ("f 1 2", "a face needs three corners, here are 2"),
        ("f 1", "a face needs three corners, here is 1"),
        ("f", "a face needs three corners, here are none"),
    ];
    for (face, what) in cases {
        let text = format!("{TRIANGLE}vn 0 0 1\nf 1 2 3\n{face}\nf 3 2 1\n");
        assert_eq!(fault(&text), (6, what.to_owned()), "{face}");
    }
}

#[test]
fn wrong_numbers_are_found_with_their_line() {
    let cases = [
        ("v 0 0", "three numbers expected, 2 found"),
        ("v", "three numbers expected, 0 found"),
        ("v 0 1,5 0", "`1,5` is not a number"),
        ("v 0 nan 0", "the coordinate nan is not finite"),
        ("v -inf 0 0", "the coordinate -inf is not finite"),
        ("v 0 0 1e39", "the coordinate 1e39 is too large: at most 3.4e38 fits"),
        ("v 0 0 1e999", "the coordinate 1e999 is too large: at most 3.4e38 fits"),
        ("v 1 0 0 0", "the coordinates divided by w = 0 are not finite"),
        ("v 1 0 0 nan", "the coordinates divided by w = nan are not finite"),
        ("v 1 0 0 1 2", "five values: neither a vertex, nor one with w or with a colour"),
        ("vn 0 0", "three numbers expected, 2 found"),
        ("vn 0 0 up", "`up` is not a number"),
    ];
    for (line, what) in cases {
        let text = format!("# made by hand\n{line}\n{TRIANGLE}f 1 2 3 -1");
        let good_vertex = format!("{TRIANGLE}v 5 5 5\n");
        assert_eq!(fault(&text), (2, what.to_owned()), "{line}");
        assert_eq!(fault(&format!("{good_vertex}{line}\nf 1 2 -1 -2\n")).1, what, "{line}");
    }
}

#[test]
fn a_text_without_faces_is_an_empty_mesh() {
    for text in ["", "\n\n", "# only a comment", "v 0 0 0\n", "ply\nformat ascii 1.0\n", "\u{feff}"]
    {
        assert_eq!(mesh(text), MeshData::default(), "{text:?}");
    }
    let flat = mesh("v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\nf 1 1 2\n");
    assert_eq!((flat.triangles.len(), flat.dropped), (0, 2));
}

#[test]
fn what_is_written_reads_back_bit_for_bit() {
    for kind in MeshKind::ALL {
        let made = generate(kind, 2000, 5);
        let mut file = Vec::new();
        made.to_obj(&mut file).unwrap();
        let back = mesh(std::str::from_utf8(&file).unwrap());
        assert_eq!(corners(&back), corners(&made), "{kind}");
        let mut again = Vec::new();
        back.to_obj(&mut again).unwrap();
        assert_eq!(mesh(std::str::from_utf8(&again).unwrap()), back, "{kind}");
    }
}

/// Everything that a mesh promises.
fn assert_valid(mesh: &MeshData) {
    assert_eq!(mesh.triangles.len(), mesh.normal_indices.len());
    assert!(mesh.triangles.iter().flatten().all(|&i| (i as usize) < mesh.positions.len()));
    assert!(mesh.normal_indices.iter().flatten().all(|&i| (i as usize) < mesh.normals.len()));
    assert!(mesh.positions.iter().all(|p| p.is_finite()));
    assert!(mesh.normals.iter().all(|n| n.is_normalized()), "{mesh:?}");
}

fn word() -> impl Strategy<Value = String> {
    prop_oneof![
        4 => (1..7i32).prop_map(|i| i.to_string()),
        2 => (-7..1i32).prop_map(|i| i.to_string()),
        2 => (0..5i32, -2..5i32).prop_map(|(v, n)| format!("{v}//{n}")),
        1 => any::<f32>().prop_map(|x| x.to_string()),
        1 => any::<i64>().prop_map(|i| format!("1//{i}")),
        1 => "[-+0-9./eE\\\\#a-z]{0,6}",
        1 => prop::sample::select(vec!["nan", "1e39", "1e-45", "\\", "/", "//"]).prop_map(str::to_owned),
    ]
}

fn obj_line() -> impl Strategy<Value = String> {
    let keyword = prop::sample::select(vec![
        "v", "v", "v", "f", "f", "f", "vn", "vt", "o", "g", "l", "usemtl", "\tf", "#",
    ]);
    let end = prop::sample::select(vec!["\n", "\n", "\n", "\r\n", "\\\n", "\r", " # end\n"]);
    (keyword, prop::collection::vec(word(), 0..7), end)
        .prop_map(|(keyword, words, end)| format!("{keyword} {}{end}", words.join(" ")))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn arbitrary_text_never_panics(text in any::<String>()) {
        let _ = read(&text).map(|mesh| assert_valid(&mesh));
    }

    #[test]
    fn text_made_of_objs_words_never_panics(lines in prop::collection::vec(obj_line(), 0..20)) {
        let text = format!("{TRIANGLE}v 1 2 3\nv 3 1 2\n{}", lines.concat());
        match read(&text) {
            Ok(mesh) => assert_valid(&mesh),
            Err(fault) => prop_assert!(fault.line <= text.lines().count()),
        }
    }
}
