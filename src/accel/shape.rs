//! What a structure looks like: the facts that reports print beside its speed.

use super::Tree;

/// How many leaves hold how many primitives: entry `n` counts the leaves with `n` primitives.
pub type LeafHistogram = Vec<u64>;

/// Size and form of a structure.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct StructureShape {
    /// Inner nodes, the root included.
    pub nodes: u64,
    /// Leaves: ranges of primitives that are offered at once.
    pub leaves: u64,
    /// Steps from the root to the deepest leaf; 0 where there is no tree.
    pub depth: u32,
    /// Leaves by the number of primitives in them.
    pub leaf_sizes: LeafHistogram,
    /// Bytes of the index itself, without the primitives.
    pub bytes: u64,
    /// Expected cost of a ray that meets the root's box, by the surface area heuristic (Goldsmith,
    /// Salmon 1987; MacDonald, Booth 1990): every box test costs 1, every primitive test costs 1.
    /// For trees alone.
    pub sah_cost: Option<f64>,
}

impl StructureShape {
    /// Size and form of a tree, with the bytes of the structure that it shows.
    #[must_use]
    pub fn of_tree(tree: Option<&Tree>, bytes: u64) -> Self {
        let mut shape = Self { bytes, ..Self::default() };
        let nodes = tree.map_or(&[][..], Tree::nodes);
        let root_area = nodes.first().map_or(0.0, |root| root.bounds.half_area());
        // The ends of the nodes that the walk is in: their number is the depth.
        let mut open: Vec<usize> = Vec::new();
        let mut cost = 0.0;
        for (index, node) in nodes.iter().enumerate() {
            while open.last().is_some_and(|&end| end <= index) {
                open.pop();
            }
            // The share of the rays that meet it: by its area in the root's.
            let met = if index == 0 { 1.0 } else { node.bounds.half_area() / root_area };
            cost += met * node.cost();
            if node.children == 0 {
                shape.add_leaf(node.slots.len() as u32, open.len() as u32);
            } else {
                shape.nodes += 1;
                open.push(node.end);
            }
        }
        shape.sah_cost = (cost.is_finite() && !nodes.is_empty()).then_some(cost);
        shape
    }

    /// Notes a leaf.
    pub fn add_leaf(&mut self, primitives: u32, depth: u32) {
        let size = primitives as usize;
        if self.leaf_sizes.len() <= size {
            self.leaf_sizes.resize(size + 1, 0);
        }
        self.leaf_sizes[size] += 1;
        self.leaves += 1;
        self.depth = self.depth.max(depth);
    }

    /// Adds what another structure is made of; the depth is that of the deeper one, and the cost
    /// that of a ray that meets both.
    pub fn merge(&mut self, other: &Self) {
        self.nodes += other.nodes;
        self.leaves += other.leaves;
        self.depth = self.depth.max(other.depth);
        self.bytes += other.bytes;
        if let Some(cost) = other.sah_cost {
            *self.sah_cost.get_or_insert(0.0) += cost;
        }
        if self.leaf_sizes.len() < other.leaf_sizes.len() {
            self.leaf_sizes.resize(other.leaf_sizes.len(), 0);
        }
        for (sum, n) in self.leaf_sizes.iter_mut().zip(&other.leaf_sizes) {
            *sum += n;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn leaves_are_counted_by_size() {
        let mut a = StructureShape::default();
        a.add_leaf(1, 3);
        a.add_leaf(4, 2);
        let mut b = StructureShape { nodes: 2, bytes: 64, ..StructureShape::default() };
        b.add_leaf(1, 1);
        b.merge(&a);
        assert_eq!(b.leaf_sizes, [0, 2, 0, 0, 1]);
        assert_eq!((b.nodes, b.leaves, b.depth, b.bytes), (2, 3, 3, 64));
    }
}
