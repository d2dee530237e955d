//! What is served, and who is refused.

use crate::support::{Server, folder};

#[test]
fn the_page_and_its_files_are_served_and_nothing_else() {
    let folder = folder();
    let server = Server::start(folder.path(), &[]);
    assert!(server.host.starts_with("127.0.0.1:"), "{}", server.host);
    for (path, kind) in
        [("", "text/html"), ("view.css", "text/css"), ("view.js", "text/javascript")]
    {
        let answer = server.get(path);
        assert_eq!(answer.status, 200, "{path}");
        for header in [
            &format!("content-type: {kind}; charset=utf-8"),
            "cache-control: no-store",
            "referrer-policy: no-referrer",
            "x-content-type-options: nosniff",
            "content-security-policy: default-src 'none'; script-src 'self'; style-src 'self'; ",
            "frame-ancestors 'none'",
        ] {
            assert!(answer.head.contains(header), "{path}: {header}\n{}", answer.head);
        }
        // Nothing is asked of anyone else.
        assert!(!answer.body.contains("//www.") && !answer.body.contains("https:"), "{path}");
        assert!(answer.body.len() > 1000, "{path}");
    }
    for path in [
        "scene.sce",
        "../scene.sce",
        "../../../../../../etc/passwd",
        "%2e%2e/scene.sce",
        "..%2fscene.sce",
        "/etc/passwd",
        "view.js/",
        "view.html",
    ] {
        let answer = server.get(path);
        assert_eq!(
            (answer.status, answer.body.as_str()),
            (404, "there is no such page\n"),
            "{path}"
        );
    }
}

#[test]
fn without_the_token_nobody_gets_anything() {
    let folder = folder();
    let server = Server::start(folder.path(), &[]);
    let host = [("Host", server.host.as_str())];
    assert_eq!(server.token.len(), 32);
    let shorter = format!("/{}/", &server.token[1..]);
    let longer = format!("/{}0/view.js", server.token);
    let other: String = server.token.chars().map(|c| if c == '0' { '1' } else { '0' }).collect();
    let (other, below) = (format!("/{other}/"), format!("/x/../{}/", server.token));
    for path in ["/", "/view.js", "/socket", "/favicon.ico", &shorter, &longer, &other, &below] {
        let answer = server.ask("GET", path, &host);
        assert_eq!(answer.status, 403, "{path}");
        assert!(answer.body.contains("the address lacks the token"), "{path}: {}", answer.body);
    }
    let tokens = [(); 2].map(|()| Server::start(folder.path(), &[]).token.clone());
    assert_ne!(tokens[0], tokens[1], "each start has its own");
}

#[test]
fn hosts_and_origins_of_others_are_refused() {
    let folder = folder();
    let server = Server::start(folder.path(), &[]);
    let path = format!("/{}/", server.token);
    let port = server.host.split(':').nth(1).unwrap();
    for host in [format!("localhost:{port}"), format!("[::1]:{port}"), "127.0.0.1".to_owned()] {
        assert_eq!(server.ask("GET", &path, &[("Host", &host)]).status, 200, "{host}");
    }
    for host in [format!("example.org:{port}"), format!("192.168.0.1:{port}"), String::new()] {
        let answer = server.ask("GET", &path, &[("Host", &host)]);
        assert_eq!(answer.status, 403, "{host}");
        assert!(answer.body.contains("no address of this page"), "{}", answer.body);
    }
    let with_origin = |origin| [("Host", server.host.as_str()), ("Origin", origin)];
    let own = format!("http://{}", server.host);
    assert_eq!(server.ask("GET", &path, &with_origin(&own)).status, 200);
    for origin in ["http://example.org", "null", "http://localhost"] {
        let answer = server.ask("GET", &path, &with_origin(origin));
        assert_eq!(answer.status, 403, "{origin}");
        let socket = server.connect(Some(origin)).err();
        assert!(socket.is_some_and(|error| error.contains("403")), "{origin}");
    }
    let answer = server.ask("POST", &path, &[("Host", &server.host), ("Content-Length", "0")]);
    assert_eq!(answer.status, 405);
    // What is no WebSocket is told so.
    assert_eq!(server.get("socket").status, 400);
}

#[test]
fn what_is_no_command_closes_the_socket_with_the_reason() {
    let folder = folder();
    let server = Server::start(folder.path(), &[]);
    for (text, reason) in
        [("{}", "not a command: missing field"), (r#"{"id":1,"do":{"zoom":0}}"#, "`0` is too far")]
    {
        let mut page = server.look();
        page.socket.send(tungstenite::Message::text(text)).unwrap();
        let frame = loop {
            if let tungstenite::Message::Close(frame) = page.socket.read().unwrap() {
                break frame.unwrap();
            }
        };
        assert_eq!(u16::from(frame.code), 1008);
        assert!(frame.reason.contains(reason), "{}", frame.reason);
    }
}
