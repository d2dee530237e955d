use super::*;

fn packed(files: &[(&str, &[u8])]) -> Vec<u8> {
    let mut bytes = Vec::new();
    Pack::write(files, &mut bytes).unwrap();
    bytes
}

const FILES: [(&str, &[u8]); 3] =
    [("scenes/a.sce", b"mesh ../meshes/m.obj\n"), ("meshes/m.obj", b"v 0 0 0\n"), ("n.obj", b"")];

#[test]
fn what_is_packed_is_read() {
    let bytes = packed(&FILES);
    assert_eq!(bytes, packed(&FILES), "the same files give the same bytes");
    assert!(Pack::is_archive(&bytes) && !Pack::is_archive(b"eye 1 2 3"));
    let pack = Pack::read(bytes).unwrap();
    assert_eq!(pack.scene(), FILES[0]);
    assert_eq!(pack.names().collect::<Vec<_>>(), FILES.map(|file| file.0));
    assert_eq!(pack.file("../meshes/m.obj"), Some(FILES[1].1));
    assert_eq!(pack.file("./../scenes/..//n.obj"), Some(FILES[2].1));
    for nothing in ["m.obj", "../../meshes/m.obj", "/meshes/m.obj", "../scenes/a.sce"] {
        assert_eq!(pack.file(nothing), None, "{nothing}");
    }
}

#[test]
fn every_byte_of_a_file_and_of_the_list_is_checked() {
    let bytes = packed(&FILES);
    // Each member's header takes a block of 512 bytes, then come its contents.
    let contents = |start: usize, length: usize| start..start + length;
    let list = contents(512, 3 * 66 + 12 + 12 + 5);
    for at in list.chain(contents(3 * 512, 21)).chain(contents(5 * 512, 8)) {
        let mut altered = bytes.clone();
        altered[at] ^= 0x11;
        assert!(Pack::read(altered).is_err(), "byte {at}");
    }
    let mut altered = bytes.clone();
    altered[5 * 512] = b'#';
    let message = Pack::read(altered).unwrap_err().to_string();
    assert!(message.starts_with("`meshes/m.obj` in it was altered: its SHA-256 is "), "{message}");
}

#[test]
fn what_is_cut_off_is_named() {
    let bytes = packed(&FILES);
    let of = |length: usize| Pack::read(bytes[..length].to_vec()).map_err(|e| e.to_string());
    // The two empty blocks at the end, and the blocks' own filling, hold nothing.
    for length in 0..6 * 512 + 512 {
        assert!(of(length).is_err(), "{length} bytes");
    }
    assert_eq!(
        of(5 * 512 + 3).unwrap_err(),
        "`meshes/m.obj` is missing in it: it is cut off or altered"
    );
    assert!(of(bytes.len()).is_ok());
}

#[test]
fn names_that_no_archive_has_are_refused() {
    let refused = |names: &[&str]| {
        let files: Vec<(&str, &[u8])> = names.iter().map(|&name| (name, &b"x"[..])).collect();
        Pack::write(&files, &mut Vec::new()).unwrap_err().to_string()
    };
    assert_eq!(refused(&["a", "b", "a"]), "the name `a` is there twice");
    assert_eq!(refused(&[SUMS]), "the name `SHA256SUMS` is there twice");
    assert_eq!(refused(&["a\nb"]), "the name `a\\nb` has control characters");
    for name in ["", "../a", "/a", "./a", "a/../b", "a//b", "a/"] {
        let message = refused(&[name]);
        assert!(message.ends_with("is not a plain path from the root of the pack"), "{message}");
    }
    let message = refused(&[&"a".repeat(256)]);
    assert!(message.contains("long"), "{message}");
}

#[test]
fn other_archives_are_refused() {
    let refused = |files: &[(&str, &[u8])]| {
        let mut archive = tar::Builder::new(Vec::new());
        for (name, contents) in files {
            let mut header = tar::Header::new_ustar();
            header.set_size(contents.len() as u64);
            header.set_cksum();
            archive.append_data(&mut header, name, *contents).unwrap();
        }
        Pack::read(archive.into_inner().unwrap()).unwrap_err().to_string()
    };
    let hash = "a".repeat(64);
    let line = |name: &str| format!("{hash}  {name}\n").into_bytes();
    assert_eq!(refused(&[]), PackError::NoSums.to_string());
    assert_eq!(refused(&[("a.sce", b"")]), PackError::NoSums.to_string());
    assert_eq!(refused(&[(SUMS, b"\n")]), PackError::NoScene.to_string());
    assert_eq!(refused(&[(SUMS, b"\nabc a.sce")]), PackError::Sums(2).to_string());
    assert_eq!(
        refused(&[(SUMS, &[line("a"), line("a")].concat())]),
        PackError::Sums(2).to_string()
    );
    assert_eq!(refused(&[(SUMS, &line("a"))]), PackError::Missing("a".into()).to_string());
    let unexpected = PackError::Unexpected("b".into()).to_string();
    assert_eq!(refused(&[(SUMS, &line("a")), ("b", b"")]), unexpected);
}

#[test]
fn files_are_called_from_the_nearest_folder_that_holds_them_all() {
    let of = |files: &[&str]| locate("/home/me/scenes", "a.sce", files);
    let located = |scene: &str, files: &[&str]| {
        let files = files.iter().map(|&file| file.to_owned()).collect();
        Ok(Located { scene: scene.to_owned(), files })
    };
    assert_eq!(of(&[]), located("a.sce", &[]));
    assert_eq!(of(&["m/b.obj", "./c.obj"]), located("a.sce", &["m/b.obj", "c.obj"]));
    let up = ["../meshes/b.obj", "x/../../d.obj", "c.obj"];
    assert_eq!(of(&up), located("scenes/a.sce", &["meshes/b.obj", "d.obj", "scenes/c.obj"]));
    assert_eq!(of(&["/b.obj"]), Err(NameError::Absolute("/b.obj".into())));
    assert_eq!(of(&["../../../../b.obj"]), Err(NameError::Outside("../../../../b.obj".into())));
}
