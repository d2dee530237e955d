use glam::Vec3;

use super::*;

fn program() -> Program {
    Program { version: "1.2.3".to_owned(), sources: [7; 32] }
}

fn scene() -> BuiltScene {
    let square = vec![Vec3::ZERO, Vec3::X, Vec3::Y, Vec3::ONE];
    let averaged = MeshData::with_averaged_normals(square.clone(), vec![[0, 1, 2], [3, 2, 1]]);
    let own =
        MeshData::with_normals(square, vec![[0, 1, 2]], vec![Vec3::Z, Vec3::Z], vec![[0, 1, 1]]);
    let [averaged, own] = [averaged, own].map(Arc::new);
    BuiltScene {
        structure: "bvh8:leaf=4".to_owned(),
        quality: "medium".to_owned(),
        lenient: true,
        moves: true,
        frame: 12,
        hash: [1; 32],
        fingerprint: [2; 32],
        text: b"sce1.0\n# caf\xe9\nend".to_vec(),
        meshes: vec![Arc::clone(&averaged), own, averaged],
    }
}

fn written(scene: &BuiltScene) -> Vec<u8> {
    let mut bytes = Vec::new();
    scene.write(&program(), &mut bytes).unwrap();
    bytes
}

fn read(mut bytes: &[u8]) -> Result<BuiltScene, BuiltFileError> {
    let size = bytes.len() as u64;
    BuiltScene::read(&program(), &mut bytes, size)
}

#[test]
fn what_is_written_is_read_and_nothing_behind_it() {
    let scene = scene();
    let mut bytes = written(&scene);
    assert!(BuiltScene::begins(&bytes) && !BuiltScene::begins(b"sce1.0\n\n"));
    bytes.extend(b"the structure");
    let mut rest = &bytes[..];
    let read = BuiltScene::read(&program(), &mut rest, 1 << 20).unwrap();
    assert_eq!((&read, rest), (&scene, &b"the structure"[..]));
    assert!(Arc::ptr_eq(&read.meshes[0], &read.meshes[2]), "what is the same is one");
}

#[test]
fn every_byte_counts() {
    let bytes = written(&scene());
    for place in 0..bytes.len() {
        for change in [0x01, 0x80, 0xFF] {
            let mut altered = bytes.clone();
            altered[place] ^= change;
            assert!(read(&altered).is_err(), "byte {place}");
        }
        assert!(read(&bytes[..place]).is_err(), "{place} bytes");
    }
}

#[test]
fn what_is_wrong_is_named() {
    let bytes = written(&scene());
    let error = |bytes: &[u8]| read(bytes).unwrap_err().to_string();
    let place = |what: &[u8]| bytes.windows(what.len()).position(|own| own == what).unwrap();
    let altered = |place: usize| {
        let mut bytes = bytes.clone();
        bytes[place] ^= 1;
        error(&bytes)
    };
    assert_eq!(error(b"v 0 0 0\nv 1 0 0\n"), "it is not a built scene");
    assert_eq!(altered(8), "it has version 0 of the form, and only 1 can be read: build it again");
    assert_eq!(
        altered(place(b"leaf")),
        "the head in it was altered: the checksum of numbers is wrong"
    );
    assert_eq!(
        altered(place(b"caf")),
        "the scene's text in it was altered: the checksum of letters is wrong"
    );
    let one = place(&1f32.to_le_bytes());
    assert_eq!(altered(one), "mesh 1 in it was altered: the checksum of vertices is wrong");
    assert_eq!(error(&bytes[..one]), "it is cut off in mesh 1");
    let size = bytes.len() as u64;
    let other = Program { version: "1.2.4".to_owned(), ..program() };
    let message = BuiltScene::read(&other, &mut &bytes[..], size).unwrap_err().to_string();
    assert_eq!(
        message,
        "it was built by another version of srt, 1.2.3 of sources 07070707…, and this is 1.2.4 of sources \
         07070707…: build it again"
    );
}

/// What was made to be read: the checksums are right, and the meshes are not.
#[test]
fn meshes_that_cannot_be_traced_are_refused() {
    let error = |change: &dyn Fn(&mut MeshData)| {
        let mut scene = scene();
        let mut mesh = MeshData::clone(&scene.meshes[1]);
        change(&mut mesh);
        scene.meshes[1] = Arc::new(mesh);
        read(&written(&scene)).unwrap_err().to_string()
    };
    let wrong = |what: &str| format!("mesh 2 in it is wrong: {what}");
    assert_eq!(
        error(&|mesh| mesh.triangles[0][2] = 4),
        wrong("a triangle has a vertex that is not there")
    );
    assert_eq!(
        error(&|mesh| mesh.normal_indices[0][2] = 2),
        wrong("a triangle has a normal that is not there")
    );
    assert_eq!(
        error(&|mesh| mesh.normals[0].x = f32::NAN),
        wrong("a vertex or a normal is not finite")
    );
    assert_eq!(
        error(&|mesh| mesh.normal_indices.clear()),
        wrong("it has no triangles, or other indices of normals")
    );
}
