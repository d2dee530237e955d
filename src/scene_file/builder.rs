//! The scene as far as it has been read, and what commands can do to it.
//!
//! When the text has ended it is checked as a whole and becomes a [`SceneDescription`].

use std::collections::{HashMap, TryReserveError};

use glam::DAffine3;

use crate::description::{
    Deformation, Light, Material, MeshReference, Object, Options, SceneDescription, Shape, Span,
};
use crate::math::Transform;

use super::camera_draft::CameraDraft;
use super::diagnostic::{Diagnostic, counted};
use super::precision::holds_transform;
use super::scopes::Scopes;
use super::{Invalid, Parsed};

/// The scene as far as it has been read.
#[derive(Default)]
pub(super) struct SceneBuilder {
    diagnostics: Vec<Diagnostic>,
    error_count: usize,
    camera: CameraDraft,
    options: Options,
    scopes: Scopes,
    objects: Vec<Object>,
    lights: Vec<Light>,
    materials: Vec<Material>,
    material_ids: HashMap<[u32; 12], usize>,
    meshes: Vec<MeshReference>,
    mesh_ids: HashMap<(String, [u64; 5]), usize>,
    /// The meshes that lines name, whether these lines are carried out or not.
    named: Vec<MeshReference>,
    /// The first and the last frame of all keys.
    keyed: Option<[f64; 2]>,
    /// The first degenerate triangle, and how many there are.
    degenerate: Option<(Span, usize)>,
    memory: Option<u64>,
}

impl SceneBuilder {
    /// Notes what is wrong.
    pub(super) fn report(&mut self, diagnostic: Diagnostic) {
        self.error_count += usize::from(diagnostic.is_error());
        self.diagnostics.push(diagnostic);
    }

    /// Notes all that is wrong.
    pub(super) fn report_all(&mut self, diagnostics: impl IntoIterator<Item = Diagnostic>) {
        diagnostics.into_iter().for_each(|diagnostic| self.report(diagnostic));
    }

    /// What is wrong with a text that is no valid scene.
    pub(super) fn into_invalid(self) -> Invalid {
        Invalid { diagnostics: self.diagnostics, meshes: self.named }
    }

    /// How many errors there are.
    pub(super) fn error_count(&self) -> usize {
        self.error_count
    }

    /// The camera, to be set.
    pub(super) fn camera(&mut self) -> &mut CameraDraft {
        &mut self.camera
    }

    /// The rendering options, to be set.
    pub(super) fn options(&mut self) -> &mut Options {
        &mut self.options
    }

    /// The material in force, to be changed.
    pub(super) fn material(&mut self) -> &mut Material {
        self.scopes.material()
    }

    /// The deformation in force, to be changed.
    pub(super) fn deformation(&mut self) -> &mut Deformation {
        self.scopes.deformation()
    }

    /// The frame that the scene is read for.
    pub(super) fn begin_at(&mut self, frame: u32) {
        *self.scopes.clock() = f64::from(frame);
    }

    /// The time that keys are looked up at, in frames.
    pub(super) fn clock(&mut self) -> f64 {
        *self.scopes.clock()
    }

    /// What follows happens later, by so many frames.
    pub(super) fn delay(&mut self, frames: f64) {
        *self.scopes.clock() -= frames;
    }

    /// What follows happens again after so many frames.
    pub(super) fn recur(&mut self, frames: f64) {
        let clock = self.scopes.clock();
        *clock = clock.rem_euclid(frames);
    }

    /// Notes the first and the last frame of a command's keys.
    pub(super) fn note_keys(&mut self, [first, last]: [f64; 2]) {
        let [low, high] = self.keyed.unwrap_or([first, last]);
        self.keyed = Some([low.min(first), high.max(last)]);
    }

    /// The transform in force: object space to world space.
    pub(super) fn transform(&self) -> DAffine3 {
        self.scopes.transform()
    }

    /// transform ← transform · `by`, because of a command.
    pub(super) fn compose(&mut self, by: DAffine3, command: Span) {
        self.scopes.compose(by, command);
    }

    /// The transform in force, for the object of a command; reported where it is of no use.
    pub(super) fn object_transform(&mut self, command: Span) -> Option<DAffine3> {
        let transform = self.transform();
        if !holds_transform(&transform) {
            self.report_transform(command, "is beyond single precision");
        } else if Transform::new(transform).is_err() {
            self.report_transform(command, "is singular: it flattens the object");
        } else {
            return Some(transform);
        }
        None
    }

    /// Reports what is wrong with the transform at a command; once for each transform.
    pub(super) fn report_transform(&mut self, command: Span, what: &str) {
        let diagnostic = self.scopes.unusable_transform(command, what);
        self.report_all(diagnostic);
    }

    /// Saves the material and the transform.
    pub(super) fn open_brace(&mut self, here: Span) {
        self.scopes.open_brace(here);
    }

    /// Restores the material and the transform.
    pub(super) fn close_brace(&mut self, here: &Span) {
        let wrong = self.scopes.close_brace(here);
        self.report_all(wrong);
    }

    /// Saves the transform.
    pub(super) fn push_matrix(&mut self, here: Span) {
        self.scopes.push_matrix(here);
    }

    /// Restores the transform.
    pub(super) fn pop_matrix(&mut self, here: &Span) {
        let wrong = self.scopes.pop_matrix(here);
        self.report_all(wrong);
    }

    /// Begins an iteration of a `repeat`.
    pub(super) fn begin_iteration(&mut self, repeat: Span) {
        self.scopes.begin_iteration(repeat);
    }

    /// Ends an iteration of a `repeat`.
    pub(super) fn end_iteration(&mut self, end: &Span) {
        let wrong = self.scopes.end_iteration(end);
        self.report_all(wrong);
    }

    /// Adds the object of a command, with the material in force.
    pub(super) fn add_object(
        &mut self,
        shape: impl Into<Shape>,
        transform: DAffine3,
        command: Span,
    ) {
        let material = self.material_id();
        let shape = shape.into();
        self.objects.push(Object { shape, transform, material, span: command });
    }

    /// Adds a light.
    pub(super) fn add_light(&mut self, light: Light) {
        self.lights.push(light);
    }

    /// Notes that the triangle of a command is left out, because its corners lie on a line.
    pub(super) fn leave_out_degenerate(&mut self, command: Span) {
        let (_, count) = self.degenerate.get_or_insert((command, 0));
        *count += 1;
    }

    /// Notes that a line names a mesh.
    pub(super) fn note_mesh(&mut self, name: &str, span: Span) {
        if self.named.iter().all(|mesh| mesh.name != name) {
            let deformation = Deformation::default();
            self.named.push(MeshReference { name: name.to_owned(), deformation, span });
        }
    }

    /// The index of the mesh of a name as the deformation in force makes it, new or not.
    pub(super) fn mesh_id(&mut self, name: &str, span: Span) -> usize {
        let deformation = *self.scopes.deformation();
        *self.mesh_ids.entry((name.to_owned(), deformation.key())).or_insert_with(|| {
            self.meshes.push(MeshReference { name: name.to_owned(), deformation, span });
            self.meshes.len() - 1
        })
    }

    /// How many objects and lights there are.
    pub(super) fn entity_count(&self) -> usize {
        self.objects.len() + self.lights.len()
    }

    /// How much memory objects and lights may take, if that is known.
    pub(super) fn limit_memory(&mut self, bytes: Option<u64>) {
        self.memory = bytes;
    }

    /// What [`limit_memory`](Self::limit_memory) has set.
    pub(super) fn memory(&self) -> Option<u64> {
        self.memory
    }

    /// Makes room for objects and lights that are known to come, if there is so much memory.
    pub(super) fn reserve(&mut self, objects: usize, lights: usize) -> Result<(), TryReserveError> {
        self.objects.try_reserve(objects)?;
        self.lights.try_reserve(lights)
    }

    /// The index of the material in force, new or not.
    fn material_id(&mut self) -> usize {
        let material = *self.scopes.material();
        *self.material_ids.entry(key(&material)).or_insert_with(|| {
            self.materials.push(material);
            self.materials.len() - 1
        })
    }

    /// Checks the scene as a whole.
    pub(super) fn finish(mut self, end: &Span) -> Result<Parsed, Invalid> {
        let unclosed = self.scopes.unclosed(end);
        self.report_all(unclosed);
        let camera = std::mem::take(&mut self.camera).finish();
        let camera = camera.unwrap_or_else(|wrong| {
            self.report(wrong);
            None
        });
        self.warn_of_degenerate_triangles();
        let Some(camera) = camera.filter(|_| self.error_count == 0) else {
            return Err(self.into_invalid());
        };
        self.warn_of_nothing_to_see(end);
        let description = SceneDescription {
            camera,
            options: self.options,
            materials: self.materials,
            meshes: self.meshes,
            objects: self.objects,
            lights: self.lights,
        };
        Ok(Parsed { description, keyed_frames: self.keyed, warnings: self.diagnostics })
    }

    fn warn_of_degenerate_triangles(&mut self) {
        let Some((first, count)) = self.degenerate.take() else { return };
        let (verb, label) = match count {
            1 => ("was", "its corners lie on one line"),
            _ => ("were", "the first of them: its corners lie on one line"),
        };
        let message = format!("{} {verb} left out", counted(count, "degenerate triangle"));
        self.report(Diagnostic::warning(first, message).with_label(label));
    }

    /// Only for scenes without errors: what is missing may have stood in an erroneous line.
    fn warn_of_nothing_to_see(&mut self, end: &Span) {
        if self.objects.is_empty() {
            let warning = Diagnostic::warning(end.clone(), "the scene has nothing to see")
                .with_label("it ends here without an object")
                .with_help("add one, for example `ball 0.5 0 0 1`");
            self.report(warning);
        } else if self.lights.is_empty() {
            let warning =
                Diagnostic::warning(end.clone(), "the scene is lit by its ambient light alone")
                    .with_label("it ends here without a light")
                    .with_help("add one, for example `pointlight 2 -3 5  1 1 1`");
            self.report(warning);
        }
    }
}

/// The bits of a material, equal exactly for materials that are equal.
fn key(material: &Material) -> [u32; 12] {
    let Material { ambient_light: a, reflectance: r, specular: s, .. } = *material;
    let Material { shininess, alpha, refractive_index, .. } = *material;
    // Adding 0 turns −0 into 0, which equals it but has other bits.
    [a.x, a.y, a.z, r.x, r.y, r.z, s.x, s.y, s.z, shininess, alpha, refractive_index]
        .map(|x| (x + 0.0).to_bits())
}
