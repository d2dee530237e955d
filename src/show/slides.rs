//! The scene with the parts of space of each level drawn over it.

use std::cmp::Reverse;

use colorous::TURBO;
use glam::{DAffine3, DVec3, Vec3};

use crate::accel::{Region, RegionForm, Regions};
use crate::description::Shape;
use crate::image_io::Picture;
use crate::math::{Aabb, Color};
use crate::render::{Image, Observer, Settings, View, render};
use crate::scene::{Scene, TracedWorld, WorldRegions};

use super::canvas::Canvas;
use super::outline::outline;

/// The most parts that are drawn in a picture: more would cover it.
const MOST_DRAWN: usize = 6_000;

/// The luminance of a surface, of which so much is left under the lines.
const DIMMED: f32 = 0.5;

/// What slides are wanted.
#[derive(Clone, Copy, Debug)]
pub struct SlideOptions {
    /// The most levels of a structure that have a slide.
    pub levels: u32,
}

/// Which of the two levels of structures a slide is of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Which {
    /// The one over the objects of the scene.
    Objects,
    /// Those over the triangles of the meshes.
    Meshes,
}

/// A picture, and what it shows.
#[derive(Clone, Debug)]
pub struct Slide {
    /// In a few words.
    pub title: String,
    /// In a sentence.
    pub caption: String,
    /// The picture.
    pub picture: Picture,
    /// The level that is drawn over it, of a slide that has one.
    pub level: Option<LevelFacts>,
}

/// What a level has: of meshes, all of them, each once.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LevelFacts {
    /// Over what.
    pub which: Which,
    /// Steps from the root.
    pub level: u32,
    /// The colour of its lines.
    pub color: Color,
    /// Parts that are parted further.
    pub inner: u64,
    /// Leaves.
    pub leaves: u64,
    /// Primitives that the leaves hold, those of several leaves counted several times.
    pub held: u64,
}

/// The picture, one slide for each level, and the leaves as solids. Where the observer stops it, there are fewer.
///
/// The picture of the scene has the size and the samples of the settings.
#[must_use]
pub fn slides(
    scene: &Scene,
    world: &dyn TracedWorld,
    settings: &Settings,
    options: SlideOptions,
    observer: &dyn Observer,
) -> Vec<Slide> {
    let rendered = |view| {
        let settings = Settings { view, ..settings.clone() };
        render(scene, world, &settings, observer).image
    };
    let (Image::Color(picture), Image::Scalar { values: depths, .. }) =
        (rendered(View::Color), rendered(View::Depth))
    else {
        return Vec::new();
    };
    let stage = Stage::new(scene, settings, &picture, &depths);
    let mut slides = vec![Slide {
        title: "The scene".to_owned(),
        caption: "As it is rendered, with this structure or any other.".to_owned(),
        picture,
        level: None,
    }];
    let regions = world.regions();
    for which in [Which::Objects, Which::Meshes] {
        let levels = levels_of(&regions, which);
        for level in 0..levels.min(options.levels) {
            if observer.cancelled() {
                return slides;
            }
            slides.push(stage.slide(&regions, which, level, levels));
        }
    }
    if let Image::Color(picture) = rendered(View::Cells) {
        slides.push(Slide {
            title: "All leaves".to_owned(),
            caption: "Where a ray enters the first of them, each in a colour of its own; grey is what is hit before."
                .to_owned(),
            picture,
            level: None,
        });
    }
    slides
}

fn regions_of(regions: &WorldRegions, which: Which) -> &[Regions] {
    match which {
        Which::Objects => std::slice::from_ref(&regions.objects),
        Which::Meshes => &regions.meshes,
    }
}

fn levels_of(regions: &WorldRegions, which: Which) -> u32 {
    regions_of(regions, which).iter().map(Regions::levels).max().unwrap_or(0)
}

/// The colour of a level among so many: from blue over green and yellow to red.
fn color_of(level: u32, levels: u32) -> Color {
    let share = f64::from(level) / f64::from((levels - 1).max(1));
    let color = TURBO.eval_continuous(0.14 + 0.76 * share);
    Color::new(f32::from(color.r), f32::from(color.g), f32::from(color.b)) / 255.0
}

/// What slides are drawn on.
struct Stage<'a> {
    scene: &'a Scene,
    camera: crate::scene::Camera,
    dimmed: Picture,
    depths: Vec<f64>,
}

/// A part of space that stands in the world.
struct Standing<'a> {
    form: &'a RegionForm,
    transform: DAffine3,
    level: u32,
    /// How large it looks: its radius by its distance.
    size: f64,
}

impl<'a> Stage<'a> {
    fn new(scene: &'a Scene, settings: &Settings, picture: &Picture, depths: &[f32]) -> Self {
        let camera = scene.camera.resized(settings.width, settings.height);
        let dim = |color: &Color| {
            let color = color.clamp(Color::ZERO, Color::ONE);
            let luminance = color.dot(Color::new(0.2126, 0.7152, 0.0722));
            DIMMED * (0.5 * color + 0.5 * luminance)
        };
        let pixels = picture.pixels.iter().map(dim).collect();
        let dimmed = Picture { pixels, ..*picture };
        // Depths are distances along rays; lines have multiples of the way to the image plane.
        let depths = (0u32..).zip(depths).map(|(place, depth)| {
            let (x, y) = (place % camera.width, place / camera.width);
            let ray = camera.ray(f64::from(x), f64::from(camera.height - 1 - y));
            f64::from(*depth) / f64::from(ray.dir.length())
        });
        let depths = depths.collect();
        Self { scene, depths, dimmed, camera }
    }

    fn slide(&self, regions: &WorldRegions, which: Which, level: u32, levels: u32) -> Slide {
        let color = color_of(level, levels);
        let mut facts = LevelFacts { which, level, color, inner: 0, leaves: 0, held: 0 };
        for region in regions_of(regions, which).iter().flat_map(Regions::all) {
            if region.level == level {
                facts.inner += u64::from(!region.is_leaf());
                facts.leaves += u64::from(region.is_leaf());
                facts.held += region.count() as u64;
            }
        }
        let mut standing = self.standing(regions, which, level);
        let all = standing.len();
        standing.sort_by(|a, b| b.size.total_cmp(&a.size));
        standing.truncate(MOST_DRAWN);
        // Leaves of earlier levels first, so that this level lies over them.
        standing.sort_by_key(|part| Reverse(level - part.level));
        let mut canvas = Canvas::new(self.dimmed.clone(), &self.depths, &self.camera);
        let eye = self.camera.eye().as_dvec3();
        for part in &standing {
            let own = color_of(part.level, levels);
            // What was a leaf before goes on to be there, but is not what this slide is about.
            let color = if part.level == level { own } else { 0.55 * own };
            outline(part.form, &part.transform, eye, |a, b| canvas.line(a, b, color));
        }
        let over = match which {
            Which::Objects => "over the objects",
            Which::Meshes => "over the triangles",
        };
        let mut caption = match level {
            0 => "The part of space around all.",
            _ if facts.inner == 0 => "The last parts: leaves alone.",
            _ => "What the level before had is parted.",
        }
        .to_owned();
        if standing.iter().any(|part| part.level < level) {
            caption += " Darker lines are leaves of earlier levels.";
        }
        if all > standing.len() {
            caption += &format!(" Only the {MOST_DRAWN} parts that look largest are drawn.");
        }
        Slide {
            title: format!("Level {level} {over}"),
            caption,
            picture: canvas.into_picture(),
            level: Some(facts),
        }
    }

    /// The parts of a level and the leaves of those before, wherever they stand; of many instances those that look
    /// largest.
    fn standing<'r>(
        &self,
        regions: &'r WorldRegions,
        which: Which,
        level: u32,
    ) -> Vec<Standing<'r>> {
        let shown =
            |region: &&Region| region.level == level || region.level < level && region.is_leaf();
        let of = |regions: &'r Regions, transform: DAffine3| {
            regions.all().iter().filter(shown).map(move |region| self.stand(region, transform))
        };
        if which == Which::Objects {
            return of(&regions.objects, DAffine3::IDENTITY).collect();
        }
        let mut instances: Vec<(f64, &Regions, DAffine3)> = self
            .scene
            .objects
            .iter()
            .filter_map(|object| {
                let Shape::Mesh { mesh, .. } = object.shape else { return None };
                let transform = self.scene.transform_of(object);
                let transform =
                    transform.map_or(DAffine3::IDENTITY, |transform| transform.world_from_object);
                let bounds = object.bounds();
                let size = self.size(
                    Vec3::from(bounds.center()).as_dvec3(),
                    0.5 * f64::from(bounds.size().length()),
                );
                Some((size, regions.meshes.get(mesh)?, transform))
            })
            .collect();
        instances.sort_by(|a, b| b.0.total_cmp(&a.0));
        let mut standing = Vec::new();
        for (_, regions, transform) in instances {
            standing.extend(of(regions, transform));
            if standing.len() > 4 * MOST_DRAWN {
                break;
            }
        }
        standing
    }

    fn stand<'r>(&self, region: &'r Region, transform: DAffine3) -> Standing<'r> {
        let of_box = |bounds: &Aabb| (Vec3::from(bounds.center()), 0.5 * bounds.size().length());
        let (center, radius) = match &region.form {
            RegionForm::Box(bounds) => of_box(bounds),
            RegionForm::Polytope(kdop) => of_box(&kdop.bounds()),
            RegionForm::Ball { center, radius } => (*center, *radius),
        };
        let scale = transform.matrix3.determinant().abs().cbrt();
        let place = transform.transform_point3(center.as_dvec3());
        let size = self.size(place, scale * f64::from(radius));
        Standing { form: &region.form, transform, level: region.level, size }
    }

    fn size(&self, place: DVec3, radius: f64) -> f64 {
        radius / (place.distance(self.camera.eye().as_dvec3()) + radius)
    }
}
