//! What is wrong with a scene beyond its text: meshes that cannot be loaded, objects that cannot be
//! traced. They become diagnostics at the scene's own lines, so that all errors look alike.

use std::sync::Arc;

use glam::DVec3;
use rayon::iter::{IntoParallelRefIterator, ParallelIterator};

use crate::assets::{AssetError, MeshData};
use crate::description::{Light, MeshReference, Object, SceneDescription, Shape, Span};
use crate::scene::SceneError;
use crate::scene_file::{Diagnostic, LineElsewhere};
use crate::shapes::Single;

/// A mesh that cannot be loaded, at the place where the scene names it first.
pub(crate) fn mesh(error: &AssetError, meshes: &[MeshReference]) -> Diagnostic {
    let diagnostic = Diagnostic::error(meshes[error.reference].span.clone(), error.to_string());
    let diagnostic = match &error.place {
        Some(place) => diagnostic.with_elsewhere(LineElsewhere {
            file: place.path.display().to_string(),
            line: place.line,
            text: place.text.clone(),
            marked: place.wrong.clone(),
        }),
        None => diagnostic,
    };
    match &error.help {
        Some(help) => diagnostic.with_help(help.clone()),
        None => diagnostic,
    }
}

/// One warning for each mesh of which triangles without area were left out.
pub(crate) fn dropped(scene: &SceneDescription, meshes: &[Arc<MeshData>]) -> Vec<Diagnostic> {
    let reported = |i: usize| meshes[..i].iter().any(|mesh| Arc::ptr_eq(mesh, &meshes[i]));
    let warning = |(i, mesh): (usize, &Arc<MeshData>)| {
        let reference = &scene.meshes[i];
        let which = match mesh.dropped {
            0 => return None,
            1 => "1 degenerate triangle".to_owned(),
            n => format!("{n} degenerate triangles"),
        };
        let message = format!("{which} of the mesh `{}` left out", reference.name);
        let kept = format!("{} left", mesh.triangles.len());
        (!reported(i))
            .then(|| Diagnostic::warning(reference.span.clone(), message).with_label(kept))
    };
    meshes.iter().enumerate().filter_map(warning).collect()
}

/// A warning of the first opaque ball that keeps the eye within it and every light out. A room or a
/// sky that is one ball has a light inside.
pub(crate) fn eye_in_the_dark(scene: &SceneDescription) -> Option<Diagnostic> {
    let around_eye = |object: &&Object| {
        let Shape::Single(Single::Ball(ball)) = object.shape else { return false };
        let (center, radius) = (ball.center.as_dvec3(), f64::from(ball.radius));
        if scene.materials[object.material].alpha < 1.0 {
            return false;
        }
        let to_ball = object.transform.inverse();
        let inside = |point: DVec3| to_ball.transform_point3(point).distance(center) < radius;
        let lit = |light: &Light| match *light {
            Light::Point { position, .. } => inside(position),
            Light::Area { center, .. } => inside(center),
        };
        inside(scene.camera.eye) && !scene.lights.iter().any(lit)
    };
    // There may be millions.
    let object = scene.objects.par_iter().find_first(around_eye)?;
    let message = "the eye is within an opaque ball, and no light is: little else can be seen";
    let warning = Diagnostic::warning(object.span.clone(), message).with_label("this ball");
    Some(warning.with_help("look at `eyepos`, and at the ball's place and size"))
}

/// What lengths `scene` can trace.
const RANGE: &str = "coordinates may be up to 1e9, and sizes must be at least 1e-9: choose another \
                     unit of length";

/// What cannot be traced, at the object's place.
pub(crate) fn scene(error: &SceneError, scene: &SceneDescription) -> Diagnostic {
    let place = |object: usize| scene.objects[object].span.clone();
    match error {
        SceneError::Transform { object, source } => {
            Diagnostic::error(place(*object), source.to_string())
                .with_label("this object")
                .with_help("look for a factor of `scale` that is nearly zero, or huge")
        }
        SceneError::OutOfRange { object } => Diagnostic::error(
            place(*object),
            "an object is too large, too small or too far away to be traced in single precision",
        )
        .with_label("this object, with the transform in force")
        .with_help(RANGE),
        // Lights and cameras have no place in the text: the error stands at its beginning.
        SceneError::LightOutOfRange { light } => Diagnostic::error(
            Span::default(),
            format!(
                "light {}, counted from the top, is too far away to be traced in single precision",
                light + 1,
            ),
        )
        .with_help(RANGE),
        SceneError::CameraOutOfRange => Diagnostic::error(
            Span::default(),
            "the camera is too far away, or its image plane too near or too far, to be traced in \
             single precision",
        )
        .with_label("the camera of this scene")
        .with_help(format!("look at `eyepos`, `wdist` and `fovy_deg`: {RANGE}")),
        SceneError::Camera => Diagnostic::error(Span::default(), error.to_string())
            .with_label("the camera of this scene")
            .with_help(
                "look at `eyedir` and `eyeup`: neither may be zero, nor one along the other",
            ),
    }
}
