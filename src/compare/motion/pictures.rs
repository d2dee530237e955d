//! Small pictures of some frames.

use super::MotionPlan;
use crate::image_io::{Format, encode};
use crate::record::FramePicture;
use crate::render::{Image, Settings, Silent, View, render};
use crate::scene::{Scene, TracedWorld};

/// The frames of which there is to be a picture: the first, the last, and evenly between them.
pub(super) fn shown_frames(plan: &MotionPlan) -> Vec<u32> {
    let [first, last] = plan.frames;
    let count = plan.pictures.min((last - first).saturating_add(1));
    let gaps = u64::from(count.saturating_sub(1).max(1));
    let behind = |place: u32| u64::from(place) * u64::from(last - first) / gaps;
    (0..count).map(|place| first + behind(place) as u32).collect()
}

/// What a frame looks like; `None` where it has no colours.
pub(super) fn picture_of(
    plan: &MotionPlan,
    frame: u32,
    scene: &Scene,
    world: &dyn TracedWorld,
) -> Result<Option<FramePicture>, String> {
    let [width, height] = plan.size;
    let settings = Settings { width, height, view: View::Color, ..Settings::of_scene(scene) };
    let Image::Color(picture) = render(scene, world, &settings, &Silent).image else {
        return Ok(None);
    };
    let png = encode(&picture, Format::Png).map_err(|error| error.to_string())?;
    Ok(Some(FramePicture { frame, size: plan.size, png }))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pictures_are_of_the_first_frame_the_last_and_some_between() {
        let shown = |frames, pictures| {
            let plan = MotionPlan {
                structures: Vec::new(),
                strategies: Vec::new(),
                frames,
                threads: 1,
                rounds: 1,
                rays_per_class: 1,
                size: [1, 1],
                pictures,
            };
            shown_frames(&plan)
        };
        assert_eq!(shown([3, 6], 24), [3, 4, 5, 6]);
        assert_eq!(shown([0, 100], 5), [0, 25, 50, 75, 100]);
        assert_eq!(shown([0, 100], 1), [0]);
        assert!(shown([0, 100], 0).is_empty());
        let wide = shown([0, u32::MAX], 3);
        assert_eq!((wide[0], wide[2], wide.len()), (0, u32::MAX, 3));
    }
}
