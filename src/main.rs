//! The command `srt`.

fn main() {}
