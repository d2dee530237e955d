use super::super::super::Quality;
use super::*;
use crate::math::{Aabb, Random};
use glam::Vec3A;

fn terms(pack_bits: u32, most: usize) -> Terms {
    Terms { pack_bits, most, effort: Effort::of(Quality::Medium) }
}

/// Long boxes along all axes, and small ones.
fn boxes(count: u32) -> Vec<Aabb> {
    let mut random = Random::new(&[41, u64::from(count)]);
    let mut boxes = Vec::new();
    for index in 0..count as usize {
        let at = Vec3A::from_array(std::array::from_fn(|_| random.next_f32()));
        let mut size = Vec3A::splat(0.01);
        if index % 3 == 0 {
            size[index % 9 / 3] = 0.5;
        }
        boxes.push(Aabb { min: at, max: at + size });
    }
    boxes
}

fn references(boxes: &[Aabb]) -> Vec<Reference> {
    (0..).zip(boxes).map(|(index, bounds)| Reference::new(index, bounds)).collect()
}

/// The leaves' boxes by primitive.
fn parts_of(tree: &Bvh2, boxes: &[Aabb]) -> Vec<Vec<Aabb>> {
    let mut parts = vec![Vec::new(); boxes.len()];
    let mut open = vec![0];
    while let Some(index) = open.pop() {
        let node: &Bvh2Node = &tree.nodes[index as usize];
        let bounds = Aabb { min: node.aabb().min, max: node.aabb().max };
        if node.is_leaf() {
            let first = node.first_index as usize;
            let own = &tree.primitive_indices[first..first + node.prim_count as usize];
            own.iter().for_each(|&one| parts[one as usize].push(bounds));
            continue;
        }
        for child in [node.first_index, node.first_index + 1] {
            let below = tree.nodes[child as usize].aabb();
            assert!(bounds.min.cmple(below.min).all() && bounds.max.cmpge(below.max).all());
            open.push(child);
        }
    }
    parts
}

#[test]
fn parts_of_a_box_cover_it() {
    let mut random = Random::new(&[43]);
    for (count, terms) in
        [(1, terms(0, 1)), (2, terms(0, 1)), (900, terms(0, 1)), (9_000, terms(3, 8))]
    {
        let boxes = boxes(count);
        let tree = tree(references(&boxes), terms, true);
        let most = boxes.len() * (100 + EXTRA_PERCENT) / 100;
        assert!((boxes.len()..=most).contains(&tree.primitive_indices.len()));
        for (own, parts) in boxes.iter().zip(parts_of(&tree, &boxes)) {
            assert!(!parts.is_empty());
            for _ in 0..20 {
                let share = Vec3A::from_array(std::array::from_fn(|_| random.next_f32()));
                let point = own.min + share * (own.max - own.min);
                let holds =
                    |part: &Aabb| part.min.cmple(point).all() && part.max.cmpge(point).all();
                assert!(parts.iter().any(holds), "{point} of {own:?} is in none of {parts:?}");
            }
        }
    }
}

#[test]
fn cuts_make_long_boxes_cheaper() {
    let boxes = boxes(3_000);
    let cost = |cuts| {
        let tree = tree(references(&boxes), terms(0, 1), cuts);
        let area = tree.nodes.iter().map(|node| f64::from(node.aabb().half_area()));
        (area.sum::<f64>(), tree.primitive_indices.len())
    };
    let (whole, cut) = (cost(false), cost(true));
    assert_eq!(whole.1, boxes.len());
    assert!(cut.1 > boxes.len() && cut.0 < 0.95 * whole.0, "{whole:?} {cut:?}");
}
