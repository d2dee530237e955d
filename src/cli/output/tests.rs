//! Outputs of every kind.

use std::fs;
use std::io;
use std::path::Path;

use super::*;
use crate::image_io::Format;

fn write(path: &Path, bytes: &[u8]) -> Result<(), OutputError> {
    Output::prepare(path)?.write(|to| to.write_all(bytes))
}

/// The names in a folder.
fn names(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).unwrap();
    let mut names: Vec<_> =
        entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    names.sort();
    names
}

#[test]
fn a_file_appears_whole() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.ppm");
    write(&path, b"one").unwrap();
    write(&path, b"two").unwrap();
    assert_eq!(fs::read(&path).unwrap(), b"two");
    assert_eq!(names(folder.path()), ["a.ppm"]);
}

#[test]
fn a_check_leaves_nothing() {
    let folder = tempfile::tempdir().unwrap();
    let output = Output::prepare(&folder.path().join("a.ppm")).unwrap();
    assert!(output.file().is_some() && !output.is_stdout());
    assert!(names(folder.path()).is_empty());
}

#[test]
fn a_failed_write_leaves_the_old_file() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.ppm");
    fs::write(&path, b"old").unwrap();
    let failed = Output::prepare(&path).unwrap().write(|to| {
        to.write_all(&[0; 1 << 20])?;
        Err(io::Error::other("no more"))
    });
    assert!(matches!(failed, Err(OutputError::Io { .. })));
    assert_eq!(fs::read(&path).unwrap(), b"old");
    assert_eq!(names(folder.path()), ["a.ppm"]);
}

#[test]
fn folders_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let refused = |path: &Path| Output::prepare(path).unwrap_err();
    assert!(matches!(refused(folder.path()), OutputError::IsFolder { .. }));
    assert!(matches!(refused(&folder.path().join("new/")), OutputError::IsFolder { .. }));
    assert!(matches!(refused(&folder.path().join("no/a.ppm")), OutputError::NoFolder { .. }));
    fs::write(folder.path().join("file"), b"").unwrap();
    assert!(Output::prepare(&folder.path().join("file/a.ppm")).is_err());
}

#[test]
fn the_extension_decides_the_format_unless_one_is_given() {
    let folder = tempfile::tempdir().unwrap();
    let format = |name: &str, given| prepare_picture(&folder.path().join(name), given).map(|p| p.1);
    assert_eq!(format("a.PNG", None).unwrap(), Format::Png);
    assert_eq!(format("a.png", Some(Format::Tga)).unwrap(), Format::Tga);
    assert_eq!(format("a.jpg", Some(Format::Exr)).unwrap(), Format::Exr);
    let message = format("a.jpg", None).unwrap_err().to_string();
    assert!(message.contains(".jpg") && message.contains(".tga, .png, .ppm"), "{message}");
    assert!(format("a", None).unwrap_err().to_string().contains("no extension"));
}

#[cfg(unix)]
mod unix {
    use std::os::unix::fs::{PermissionsExt, symlink};

    use super::*;

    fn mode(path: &Path) -> u32 {
        fs::metadata(path).unwrap().permissions().mode() & 0o7777
    }

    #[test]
    fn permissions_are_those_of_any_new_file_or_of_the_old_one() {
        let folder = tempfile::tempdir().unwrap();
        let (plain, path) = (folder.path().join("plain"), folder.path().join("a.ppm"));
        fs::write(&plain, b"").unwrap();
        write(&path, b"one").unwrap();
        assert_eq!(mode(&path), mode(&plain));
        fs::set_permissions(&path, fs::Permissions::from_mode(0o640)).unwrap();
        write(&path, b"two").unwrap();
        assert_eq!(mode(&path), 0o640);
    }

    #[test]
    fn links_stay_and_their_target_is_replaced() {
        let folder = tempfile::tempdir().unwrap();
        let at = |name: &str| folder.path().join(name);
        fs::create_dir(at("sub")).unwrap();
        symlink("second", at("first")).unwrap();
        symlink("sub/target.ppm", at("second")).unwrap();
        for text in [b"one", b"two"] {
            // The first time the last link leads nowhere.
            write(&at("first"), text).unwrap();
            assert_eq!(fs::read(at("sub/target.ppm")).unwrap(), text);
        }
        assert!(fs::symlink_metadata(at("first")).unwrap().is_symlink());
        assert!(fs::symlink_metadata(at("second")).unwrap().is_symlink());
        symlink("ring", at("ring")).unwrap();
        assert!(Output::prepare(&at("ring")).is_err());
    }

    #[test]
    fn devices_are_written_to() {
        let (output, format) = prepare_picture(Path::new("/dev/null"), None).unwrap();
        assert!(output.file().is_none());
        assert_eq!(format, Format::Ppm);
        output.write(|to| to.write_all(b"gone")).unwrap();
        assert!(!fs::metadata("/dev/null").unwrap().is_file());
        // A link to a device is a device.
        let folder = tempfile::tempdir().unwrap();
        let link = folder.path().join("a.png");
        symlink("/dev/null", &link).unwrap();
        let (output, format) = prepare_picture(&link, None).unwrap();
        assert!(output.file().is_none());
        assert_eq!(format, Format::Png);
    }

    #[test]
    fn pipes_are_written_to_and_stay() {
        let folder = tempfile::tempdir().unwrap();
        let pipe = folder.path().join("pipe");
        let made = std::process::Command::new("mkfifo").arg(&pipe).status();
        if !made.is_ok_and(|status| status.success()) {
            return;
        }
        let reader = std::thread::spawn({
            let pipe = pipe.clone();
            move || fs::read(pipe).unwrap()
        });
        let (output, format) = prepare_picture(&pipe, None).unwrap();
        assert_eq!(format, Format::Ppm);
        output.write(|to| to.write_all(b"through")).unwrap();
        assert_eq!(reader.join().unwrap(), b"through");
        assert_eq!(names(folder.path()), ["pipe"]);
        assert!(!fs::metadata(&pipe).unwrap().is_file());
    }

    #[test]
    fn standard_output_has_many_names() {
        let folder = tempfile::tempdir().unwrap();
        let link = folder.path().join("a.png");
        symlink("/dev/stdout", &link).unwrap();
        for name in ["-", "/dev/stdout", "/dev/fd/1", link.to_str().unwrap()] {
            assert!(Output::prepare(Path::new(name)).unwrap().is_stdout(), "{name}");
        }
    }
}
