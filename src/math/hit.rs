//! What a ray found, and the order that makes "the closest" unique.

/// The id of no object and no primitive.
pub const NONE: u32 = u32::MAX;

/// The closest hit of a ray: the smallest `(t, object, prim)` in this order.
///
/// The ids break ties, so that the closest hit is one and the same for every structure, whatever
/// the order in which it offers its primitives.
#[derive(Clone, Copy, Debug, PartialEq)]
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

    /// The same bits in every field: what the cross-checks compare.
    #[must_use]
    pub fn same_bits(&self, other: &Self) -> bool {
        let bits = |h: &Self| (h.t.to_bits(), h.object, h.prim, h.u.to_bits(), h.v.to_bits());
        bits(self) == bits(other)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

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
