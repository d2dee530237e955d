//! What a ray found, and the order that makes "the closest" unique.

use bytemuck::{Pod, Zeroable};

use super::slab::not_before;

/// The id of no object and no primitive.
pub const NONE: u32 = u32::MAX;

/// The closest hit of a ray: the smallest `(t, object, prim)` in this order.
///
/// The ids break ties, so that the closest hit is one and the same for every structure, whatever
/// the order in which it offers its primitives. Within one object of a single shape it is the first crossing of its
/// formula: where the two crossings of a cylinder are rounded to one `t`, the face by which the ray enters, even if the
/// other one has the smaller `prim`.
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct Hit {
    /// Parameter along the ray, in units of the ray's own direction.
    pub t: f32,
    /// Index of the object in the scene, or [`NONE`].
    pub object: u32,
    /// Index of the primitive in the object (a mesh's triangle, a cylinder's side or cap).
    pub prim: u32,
    /// First surface coordinate: for triangles the barycentric weight of the second corner.
    pub u: f32,
    /// Second surface coordinate: for triangles the barycentric weight of the third corner.
    pub v: f32,
}

/// How far the parameters of two formulas may lie apart, as a share of the larger one.
pub const CLOSE: f32 = 1e-4;

impl Hit {
    /// What a ray that hits nothing has.
    pub const MISS: Self = Self { t: f32::INFINITY, object: NONE, prim: NONE, u: 0.0, v: 0.0 };

    /// The start of a search: nothing found yet, and nothing beyond `t_max` wanted.
    ///
    /// Every hit at `t ≤ t_max` precedes it, because every id precedes [`NONE`].
    #[must_use]
    pub fn none_before(t_max: f32) -> Self {
        Self { t: t_max, ..Self::MISS }
    }

    /// Whether anything was hit.
    #[must_use]
    pub fn is_hit(&self) -> bool {
        self.object != NONE
    }

    /// Whether `self` comes before `other` in the order `(t, object, prim)`.
    #[must_use]
    pub fn precedes(&self, other: &Self) -> bool {
        self.t < other.t
            || (self.t == other.t && (self.object, self.prim) < (other.object, other.prim))
    }

    /// The same hit as one on an object, whose box begins at `begin`: no hit on it counts earlier.
    #[inline(always)]
    #[must_use]
    pub fn in_object(&self, object: u32, begin: f32) -> Self {
        Self { t: not_before(self.t, begin), object, ..*self }
    }

    /// The same bits in every field: what the cross-checks compare.
    #[must_use]
    pub fn same_bits(&self, other: &Self) -> bool {
        let bits = |h: &Self| (h.t.to_bits(), h.object, h.prim, h.u.to_bits(), h.v.to_bits());
        bits(self) == bits(other)
    }

    /// Whether another formula may have found `other` where this one found `self`: the same
    /// primitive of the same object, or a `t` that is the same but for [`CLOSE`] of it; or neither
    /// hit anything. What a peer library is held to.
    #[must_use]
    pub fn agrees(&self, other: &Self) -> bool {
        if !self.is_hit() || !other.is_hit() {
            return self.is_hit() == other.is_hit();
        }
        (self.object, self.prim) == (other.object, other.prim)
            || (self.t - other.t).abs() <= CLOSE * self.t.abs().max(other.t.abs())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hits_agree_on_the_primitive_or_nearly_on_the_parameter() {
        let hit = |t, prim| Hit { t, object: 0, prim, u: 0.0, v: 0.0 };
        assert!(hit(1.0, 3).agrees(&hit(1.1, 3)));
        assert!(hit(1.0, 3).agrees(&hit(1.00005, 4)));
        assert!(!hit(1.0, 3).agrees(&hit(1.0003, 4)));
        assert!(!hit(1.0, 3).agrees(&Hit::MISS) && !Hit::MISS.agrees(&hit(1.0, 3)));
        assert!(Hit::MISS.agrees(&Hit::MISS));
    }

    #[test]
    fn ties_go_to_the_smaller_object_then_the_smaller_primitive() {
        let hit = |t, object, prim| Hit { t, object, prim, u: 0.0, v: 0.0 };
        assert!(hit(1.0, 9, 9).precedes(&hit(2.0, 0, 0)));
        assert!(hit(1.0, 0, 9).precedes(&hit(1.0, 1, 0)));
        assert!(hit(1.0, 1, 0).precedes(&hit(1.0, 1, 1)));
        assert!(!hit(1.0, 1, 1).precedes(&hit(1.0, 1, 1)));
        assert!(hit(5.0, 0, 0).precedes(&Hit::none_before(5.0)), "the end of the ray is inclusive");
        assert!(!hit(5.0f32.next_up(), 0, 0).precedes(&Hit::none_before(5.0)));
    }
}
