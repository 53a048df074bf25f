//! Exact intersection of half-planes in the plane.
//!
//! Two functions intersect a [`System`] of linear inequalities: [`envelope::intersect`] (fast) and
//! [`clipping::intersect`] (the definition, step by step). Both return the same [`Region`], one of ten kinds, with
//! the half-planes active at every vertex. A [`Polyhedron`] keeps system and region together and answers questions
//! about them, each answer with a proof that [`Farkas::verify`], [`BoundProof::verify`] or [`UnboundedProof::verify`]
//! recomputes.
//!
//! Everything is exact: there is no tolerance, no floating point and no bounding box around unbounded sets.
//!
//! | to | modules |
//! |---|---|
//! | state half-planes | `half_plane`, `system`, `point` |
//! | intersect | `envelope`, `clipping`, `bounds`, `hull`, `fan` |
//! | answer about a set | `region`, `polyhedron`, `active_sets`, `measures`, `normal_cone`, `projective`, `leaving_out`, `layers` |
//! | decide and construct | `predicates`, `constructions`, `angle_key` |
//! | prove and check | `proof`, `invariants` |
//! | keep only readings that may decide | `grid`, `touching`, `ties`, `tally`, `active` |
//! | start from points and directions | `generators` |
//!
//! ```
//! use boundfit_exact::Rational;
//! use boundfit_geometry::{Inequality, Polyhedron, RegionKind, Support, System};
//!
//! let row = |a1: i64, a2: i64, b: i64| Inequality::new(a1.into(), a2.into(), b.into());
//! let system: System = [row(-1, 0, 0), row(0, -1, 0), row(2, 3, 6)].into_iter().collect();
//! let triangle = Polyhedron::intersect(system);
//! assert_eq!(triangle.region().kind(), RegionKind::Polygon);
//! assert_eq!(triangle.region().area(), Some(Rational::from(3)));
//! let Support::Bounded { proof, .. } = triangle.support(&[Rational::one(), Rational::one()]) else {
//!     unreachable!("a triangle is bounded")
//! };
//! assert_eq!(proof.value, Rational::from(3));
//! assert_eq!(proof.verify(triangle.system()), Ok(()));
//! ```

mod active;
mod active_sets;
mod angle_key;
mod bounds;
pub mod clipping;
pub mod constructions;
pub mod envelope;
mod fan;
mod generators;
pub mod grid;
mod half_plane;
mod hull;
mod invariants;
mod layers;
mod leaving_out;
mod measures;
mod normal_cone;
mod point;
mod polyhedron;
pub mod predicates;
mod projective;
mod proof;
mod region;
mod system;
mod tally;
mod ties;
mod touching;

pub use active_sets::ActiveSets;
pub use generators::{Generator, Generators};
pub use half_plane::{Constraint, HalfPlane, Inequality};
pub use hull::{Hull, HullSide, Hulls, Site};
pub use invariants::InvariantViolation;
pub use layers::{LayerOf, Layers};
pub use leaving_out::LeavingOut;
pub use measures::{Measure, Measures};
pub use normal_cone::NormalCone;
pub use point::{Direction, Point};
pub use polyhedron::{Face, Membership, Polyhedron, Redundancy, Support};
pub use projective::{Branch, inverse_line_image};
pub use proof::{BoundProof, Farkas, Multiplier, ProofError, UnboundedProof, verify_membership};
pub use region::{
    Boundary, EmptyRegion, HalfPlaneRegion, LineRegion, PointRegion, PolygonRegion, RayRegion, Region,
    RegionKind, SegmentRegion, StripRegion, UnboundedPolygonRegion, Vertex,
};
pub use system::System;
pub use tally::Tally;
pub use ties::{Tied, touching_as_one, touching_each};
pub use touching::{Touch, touches_of_envelopes, touching_an_envelope};
