//! The scene as far as it has been read.
//!
//! The commands' functions fill it; when the text has ended it is checked as a whole and becomes a
//! [`SceneDescription`].

use std::collections::{HashMap, HashSet, TryReserveError};

use crate::description::{
    Light, Material, MeshReference, Object, Options, SceneDescription, Shape, Span,
};

use super::camera::{self, CameraDraft};
use super::diagnostic::{Diagnostic, counted};
use super::scopes::{self, Scopes};
use super::state::State;

/// The scene as far as it has been read.
pub(super) struct Builder {
    /// What is wrong so far.
    pub(super) diagnostics: Vec<Diagnostic>,
    /// The commands that were read, or that an erroneous line was meant to be.
    pub(super) seen: HashSet<&'static str>,
    /// What the text has said of the camera.
    pub(super) camera: CameraDraft,
    /// The rendering options.
    pub(super) options: Options,
    /// The material and transform in force.
    pub(super) state: State,
    /// What is open.
    pub(super) scopes: Scopes,
    /// The lights.
    pub(super) lights: Vec<Light>,
    /// The first degenerate triangle, and how many there are.
    pub(super) degenerate: Option<(Span, usize)>,
    /// Where `end` stands, once it was read.
    pub(super) end: Option<Span>,
    objects: Vec<Object>,
    materials: Vec<Material>,
    material_ids: HashMap<[u32; 12], usize>,
    meshes: Vec<MeshReference>,
    mesh_ids: HashMap<String, usize>,
}

impl Builder {
    pub(super) fn new() -> Self {
        Self {
            diagnostics: Vec::new(),
            seen: HashSet::new(),
            camera: CameraDraft::default(),
            options: camera::DEFAULT_OPTIONS,
            state: State::default(),
            scopes: Scopes::default(),
            lights: Vec::new(),
            degenerate: None,
            end: None,
            objects: Vec::new(),
            materials: Vec::new(),
            material_ids: HashMap::new(),
            meshes: Vec::new(),
            mesh_ids: HashMap::new(),
        }
    }

    /// Notes what is wrong.
    pub(super) fn report(&mut self, diagnostic: Diagnostic) {
        self.diagnostics.push(diagnostic);
    }

    /// Adds an object with the material in force.
    pub(super) fn add_object(
        &mut self,
        shape: impl Into<Shape>,
        transform: glam::DAffine3,
        span: Span,
    ) {
        let shape = shape.into();
        let material = self.material_id();
        self.objects.push(Object { shape, transform, material, span });
    }

    /// Makes room for objects and lights that are known to come, if there is so much memory.
    pub(super) fn reserve(&mut self, objects: usize, lights: usize) -> Result<(), TryReserveError> {
        self.objects.try_reserve(objects)?;
        self.lights.try_reserve(lights)
    }

    /// How many objects and lights there are.
    pub(super) fn entity_count(&self) -> usize {
        self.objects.len() + self.lights.len()
    }

    /// The index of the material in force, new or not.
    fn material_id(&mut self) -> usize {
        let material = self.state.material;
        *self.material_ids.entry(key(&material)).or_insert_with(|| {
            self.materials.push(material);
            self.materials.len() - 1
        })
    }

    /// The index of a mesh, new or not.
    pub(super) fn mesh_id(&mut self, name: &str, span: Span) -> usize {
        if let Some(id) = self.mesh_ids.get(name) {
            return *id;
        }
        self.meshes.push(MeshReference { name: name.to_owned(), span });
        self.mesh_ids.insert(name.to_owned(), self.meshes.len() - 1);
        self.meshes.len() - 1
    }

    /// Checks the scene as a whole. `None` where something is wrong with it.
    pub(super) fn finish(mut self, end: Span) -> (Option<SceneDescription>, Vec<Diagnostic>) {
        scopes::report_unclosed(&mut self, &end);
        camera::report_missing(&mut self, &end);
        let camera = camera::finish(&mut self);
        self.warn_of_degenerate_triangles();
        if self.diagnostics.iter().any(Diagnostic::is_error) {
            return (None, self.diagnostics);
        }
        self.warn_of_nothing_to_see(&end);
        let description = camera.map(|camera| SceneDescription {
            camera,
            options: self.options,
            materials: self.materials,
            meshes: self.meshes,
            objects: self.objects,
            lights: self.lights,
        });
        (description, self.diagnostics)
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
