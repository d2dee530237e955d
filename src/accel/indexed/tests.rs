use std::ops::{ControlFlow, Range};

use glam::Vec3A;

use super::*;
use crate::accel::{BallTree, Built, Bvh, Exhaustive, Followed, KdTree, NoPacks};
use crate::math::{BoxRay, Padding};

/// Boxes that nothing hits.
#[derive(Clone)]
struct Boxes(Vec<Aabb>);

impl Boxes {
    fn in_a_row(count: usize) -> Self {
        let at = |i: usize| Vec3A::new(i as f32, 0.0, 0.0);
        Self((0..count).map(|i| Aabb { min: at(i), max: at(i) + 0.5 }).collect())
    }
}

impl Bounded for Boxes {
    fn count(&self) -> u32 {
        self.0.len() as u32
    }

    fn bounds(&self, index: u32) -> Aabb {
        self.0[index as usize]
    }

    fn mean_point(&self) -> Vec3A {
        Vec3A::ZERO
    }
}

impl Primitives for Boxes {
    type Packs = NoPacks;

    fn packs(&self) -> &NoPacks {
        &NoPacks
    }

    fn padding(&self) -> Padding {
        Padding::of_bounds(&self.total_bounds())
    }

    fn reorder(&mut self, order: &[u32]) {
        self.0 = order.iter().map(|&from| self.0[from as usize]).collect();
    }

    fn test<Q: Query, C: Counters>(
        &self,
        _: &Q,
        _: Range<u32>,
        _: &Ray,
        _: &BoxRay,
        _: &mut Q::Answer,
        _: &mut C,
    ) {
    }
}

fn build<A: Accel>(boxes: Boxes) -> Indexed<Boxes, A> {
    Indexed::build(boxes, &BuildConfig::default())
}

/// What is said of a primitive that has a box from one corner to another.
fn said_of<A: Accel>(min: Vec3A, max: Vec3A) -> String {
    let mut boxes = Boxes::in_a_row(30);
    boxes.0[7] = Aabb { min, max };
    boxes.0[19] = Aabb::EMPTY;
    let payload = std::panic::catch_unwind(|| build::<A>(boxes).bytes()).unwrap_err();
    payload.downcast_ref::<String>().unwrap().clone()
}

#[test]
fn boxes_that_are_not_sound_are_refused_before_a_build() {
    let nan = Vec3A::new(0.0, f32::NAN, 0.0);
    let expected = "primitive 7 has no finite box: from [0, NaN, 0] to [1, 1, 1]";
    assert_eq!(said_of::<KdTree>(nan, Vec3A::ONE), expected);
    assert_eq!(said_of::<Bvh>(nan, Vec3A::ONE), expected);
    let inverted = said_of::<BallTree>(Vec3A::ONE, Vec3A::ZERO);
    assert_eq!(inverted, "primitive 7 has no finite box: from [1, 1, 1] to [0, 0, 0]");
    let endless = said_of::<Exhaustive>(Vec3A::ZERO, Vec3A::splat(f32::INFINITY));
    assert_eq!(endless, "primitive 7 has no finite box: from [0, 0, 0] to [inf, inf, inf]");
}

/// A structure whose order after a refit is the slots that have moved; four slots where none has.
struct Disorderly;

impl Accel for Disorderly {
    const UPDATES: &'static [Update] = &[Update::Partial];

    fn build(_: &impl Bounded, _: &mut Build<'_>) -> Built<Self> {
        Built { accel: Self, order: None }
    }

    fn traverse<C: Counters>(
        &self,
        _: &Ray,
        _: &BoxRay,
        _: &mut C,
        _: impl FnMut(Range<u32>, &mut C) -> ControlFlow<(), f32>,
    ) {
    }

    fn refit<P: Primitives>(
        &mut self,
        _: Update,
        primitives: &P,
        moved: Moved<'_>,
        _: &Build<'_>,
    ) -> Followed {
        let order = match moved {
            Moved::All | Moved::Slots([]) => vec![0, 1, 2, 3],
            Moved::Slots(slots) => slots.to_vec(),
        };
        Followed { bounds: primitives.total_bounds(), order: Some(order) }
    }

    fn bytes(&self) -> u64 {
        0
    }
}

fn follow<A: Accel>(update: Update, slots: &[u32]) {
    let mut own = build::<A>(Boxes::in_a_row(3));
    let fine = own.refit(update, Moved::Slots(slots), |_| Ok::<_, ()>(()), |_, _| Ok(()));
    fine.unwrap();
}

#[test]
fn an_order_from_a_refit_may_be_any_that_is_whole() {
    follow::<Disorderly>(Update::Partial, &[2, 0, 1]);
    follow::<Disorderly>(Update::Partial, &[2, 0, 2, 1]);
}

#[test]
#[should_panic(expected = "after a refit the order names primitive 1 never")]
fn an_order_from_a_refit_keeps_each_primitive() {
    follow::<Disorderly>(Update::Partial, &[2, 0, 0]);
}

#[test]
#[should_panic(expected = "after a refit the order names slot 3, and there are 3, counted from 0")]
fn an_order_from_a_refit_names_slots_that_there_are() {
    follow::<Disorderly>(Update::Partial, &[]);
}

#[test]
#[should_panic(expected = "slot 5000 has moved, and there are 3, counted from 0")]
fn slots_that_have_moved_are_some() {
    follow::<Bvh>(Update::Refit, &[1, 5000]);
}

/// [`Boxes`] in another structure's order, with a slot that is empty until the ranks are closed.
struct Spaced(Boxes);

impl Bounded for Spaced {
    fn count(&self) -> u32 {
        self.0.count()
    }

    fn bounds(&self, index: u32) -> Aabb {
        self.0.bounds(index)
    }

    fn mean_point(&self) -> Vec3A {
        Vec3A::ZERO
    }
}

impl Primitives for Spaced {
    type Packs = NoPacks;

    fn packs(&self) -> &NoPacks {
        &NoPacks
    }

    fn padding(&self) -> Padding {
        self.0.padding()
    }

    fn close_ranks(&mut self) {
        self.0.0.retain(|bounds| !bounds.is_empty());
    }

    fn reorder(&mut self, order: &[u32]) {
        self.0.reorder(order);
    }

    fn test<Q: Query, C: Counters>(
        &self,
        _: &Q,
        _: Range<u32>,
        _: &Ray,
        _: &BoxRay,
        _: &mut Q::Answer,
        _: &mut C,
    ) {
    }
}

#[test]
fn ranks_are_closed_before_boxes_are_looked_at() {
    let mut boxes = Boxes::in_a_row(20);
    boxes.0.insert(0, Aabb::EMPTY);
    let index: Indexed<_, Bvh> = Indexed::build(Spaced(boxes), &BuildConfig::default());
    assert_eq!(index.primitives().count(), 20);
}
