//! Which primitives each cell of a raster refers to, and how fine the raster may be for that.

use std::ops::Range;

use rayon::prelude::*;

use super::Raster;
use crate::math::Aabb;

/// Boxes are looked at in parallel by so many at least.
const PARALLEL: usize = 1 << 12;

/// Some primitives, by their places among these.
pub(in super::super) struct Boxes<'a> {
    pub(in super::super) boxes: &'a [Aabb],
    /// Those that are meant; all if there is no list.
    pub(in super::super) ids: Option<&'a [u32]>,
}

/// The lists of all cells behind each other.
pub(in super::super) struct Filed {
    /// Where each list begins, and where the last ends.
    begins: Vec<u32>,
    ids: Vec<u32>,
}

impl Boxes<'_> {
    pub(in super::super) fn count(&self) -> usize {
        self.ids.map_or(self.boxes.len(), <[u32]>::len)
    }

    #[inline(always)]
    fn id(&self, place: usize) -> u32 {
        self.ids.map_or(place as u32, |ids| ids[place])
    }

    #[inline(always)]
    fn touched(&self, place: usize, raster: &Raster) -> [Range<u32>; 3] {
        raster.touched(&self.boxes[self.id(place) as usize])
    }

    /// About so many cells in a box; fewer where a primitive would have more than `most` references in the
    /// mean.
    pub(in super::super) fn raster(&self, bounds: &Aabb, cells: f64, most: u64) -> Raster {
        let mut cells = cells;
        loop {
            let raster = Raster::of_about(bounds, cells);
            let references = |place| {
                let touched = self.touched(place, &raster);
                touched.iter().map(|places| places.len() as u64).product::<u64>()
            };
            let places = (0..self.count()).into_par_iter().with_min_len(PARALLEL);
            if raster.count() == 1
                || places.map(references).sum::<u64>() <= most * self.count() as u64
            {
                return raster;
            }
            cells /= 2.0;
        }
    }

    /// The lists of the cells of a raster, in which ids ascend: counted first, then filled.
    pub(in super::super) fn file(&self, raster: &Raster) -> Filed {
        let mut begins = vec![0; raster.count() + 1];
        for place in 0..self.count() {
            raster.numbers(self.touched(place, raster)).for_each(|cell| begins[cell] += 1);
        }
        let mut references = 0;
        for end in &mut begins {
            references += *end;
            *end = references;
        }
        // Backwards, so that what was the end of a list becomes its begin.
        let mut ids = vec![0; references as usize];
        for place in (0..self.count()).rev() {
            for cell in raster.numbers(self.touched(place, raster)) {
                begins[cell] -= 1;
                ids[begins[cell] as usize] = self.id(place);
            }
        }
        Filed { begins, ids }
    }
}

impl Filed {
    /// The lists, cell by cell.
    pub(in super::super) fn lists(&self) -> impl ExactSizeIterator<Item = &[u32]> {
        self.begins.windows(2).map(|ends| &self.ids[ends[0] as usize..ends[1] as usize])
    }

    /// The list of a cell.
    pub(in super::super) fn list(&self, cell: usize) -> &[u32] {
        &self.ids[self.begins[cell] as usize..self.begins[cell + 1] as usize]
    }
}

#[cfg(test)]
mod tests {
    use glam::Vec3A;

    use super::*;
    use crate::math::Random;

    #[test]
    fn each_cell_lists_the_boxes_that_touch_it() {
        let mut random = Random::new(&[43]);
        let mut point = || Vec3A::from_array(std::array::from_fn(|_| random.below(9) as f32));
        let boxes: Vec<Aabb> = (0..200).map(|_| Aabb::of_points([point(), point()])).collect();
        let bounds = boxes.iter().copied().fold(Aabb::EMPTY, Aabb::union);
        let some: Vec<u32> = (0..200).filter(|id| id % 3 != 1).collect();
        for ids in [None, Some(&some[..])] {
            let raster = Raster::new(&bounds, [4, 2, 3]);
            let filed = Boxes { boxes: &boxes, ids }.file(&raster);
            for (cell, list) in filed.lists().enumerate() {
                let touches =
                    |&id: &u32| !boxes[id as usize].intersection(raster.cell(cell)).is_empty();
                let is_meant = |id: &u32| ids.is_none_or(|ids| ids.contains(id));
                let expected: Vec<u32> = (0..200).filter(is_meant).filter(touches).collect();
                assert_eq!((list, filed.list(cell)), (&expected[..], &expected[..]));
            }
        }
    }

    #[test]
    fn a_raster_is_no_finer_than_references_allow() {
        let all = Aabb { min: Vec3A::ZERO, max: Vec3A::ONE };
        let raster = |most| Boxes { boxes: &[all; 10], ids: None }.raster(&all, 1e5, most).count();
        let [one, few, many] = [1, 16, 1_000].map(raster);
        assert_eq!(one, 1);
        assert!((4..=16).contains(&few) && (200..=1_000).contains(&many), "{few} {many}");
    }
}
