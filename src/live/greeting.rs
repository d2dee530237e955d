//! What there is to choose from: the first message of a session.

use serde_json::{Value, json};

use crate::accel::{Allowed, OptionInfo};
use crate::render::View;
use crate::scene::Structure;

use super::{MOST_LANES, Studio};

/// The message, as JSON.
pub(super) fn text(studio: &Studio) -> String {
    let views = View::ALL.map(|view| json!({"name": view.name(), "summary": view.summary()}));
    // The one to begin with may be a second time in the list, with options of its own.
    let is_plain = |one: &&Structure| one.name == one.base_name();
    let structures: Vec<_> = studio.structures.iter().filter(is_plain).map(structure).collect();
    json!({
        "greeting": {
            "structures": structures,
            "views": views,
            "threads": studio.pool.current_num_threads(),
            "most_lanes": MOST_LANES,
        }
    })
    .to_string()
}

fn structure(one: &Structure) -> Value {
    let options: Vec<_> = one.offered_options().map(option).collect();
    json!({"name": one.name, "summary": one.summary, "peer": one.peer, "options": options})
}

fn option(info: &OptionInfo) -> Value {
    let mut value = json!({"name": info.name, "summary": info.summary, "default": info.default});
    match info.allowed {
        Allowed::Words(words) => value["words"] = json!(words),
        Allowed::Numbers(least, most) => value["numbers"] = json!([least, most]),
    }
    value
}
