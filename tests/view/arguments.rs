//! What is wrong with the command line, or with the scene at the beginning.

use std::fs;
use std::net::TcpListener;

use crate::support::{Server, command, folder};

fn refused(arguments: &[&str], parts: &[&str]) {
    let folder = folder();
    fs::write(folder.path().join("bad.sce"), "sce1.0\nballl\nend\n").unwrap();
    let output = command(folder.path(), &[&["view"], arguments].concat()).output().unwrap();
    let stderr = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(2), "{arguments:?}: {stderr}");
    assert!(output.stdout.is_empty());
    for part in parts {
        assert!(stderr.contains(part), "{arguments:?}: {part}\n{stderr}");
    }
}

#[test]
fn what_is_wrong_is_said() {
    refused(&["-"], &["standard input can be read only once: name a file"]);
    refused(&["scene.sce", "--crop", "0,0,9,9"], &["leave --crop out"]);
    refused(&["scene.sce", "--port", "65536"], &["from 0 to 65535"]);
    refused(&["scene.sce", "--listen", "example.org"], &["--listen", "example.org"]);
    let expected = "expected an address in digits, such as 127.0.0.1 for this machine alone";
    refused(&["scene.sce", "--listen", "localhost"], &["--listen", "localhost", expected]);
    refused(&["scene.sce", "--listen", "127.0.0.1:80"], &["the port is given by --port"]);
    refused(&["scene.sce", "--listen", "192.0.2.1"], &["cannot listen on 192.0.2.1:0"]);
    refused(&["scene.sce", "--size", "9000x9000"], &["9000x9000 pixels are too many to look at"]);
    refused(&["bad.sce"], &["unknown command `balll`", "bad.sce:2:1"]);
    refused(&["missing.sce"], &["cannot read the scene `missing.sce`"]);
    let taken = TcpListener::bind("127.0.0.1:0").unwrap();
    let port = taken.local_addr().unwrap().port().to_string();
    let message = format!("cannot listen on 127.0.0.1:{port}");
    refused(&["scene.sce", "--port", &port], &[&message, "--port 0 takes a free port"]);
}

#[test]
fn it_listens_where_it_is_told_to() {
    let folder = folder();
    let free = TcpListener::bind("127.0.0.1:0").unwrap().local_addr().unwrap().port().to_string();
    let server = Server::start(folder.path(), &["--port", &free]);
    assert_eq!(server.host, format!("127.0.0.1:{free}"));
    let server = Server::start(folder.path(), &["--listen", "0.0.0.0"]);
    assert!(server.host.starts_with("127.0.0.1:"), "{}", server.host);
    assert_eq!(server.get("").status, 200);
    // For other machines any address in digits is a host, and no name.
    let path = format!("/{}/", server.token);
    assert_eq!(server.ask("GET", &path, &[("Host", "192.168.7.7:80")]).status, 200);
    assert_eq!(server.ask("GET", &path, &[("Host", "example.org:80")]).status, 403);
}
