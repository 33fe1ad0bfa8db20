//! The bounds against what they are defined by: finite differences of the measurement, the stacked matrices of the
//! papers, an independent program, and geometries in which there is nothing to be seen.

mod constrained;
mod degenerate;
mod dense;
mod derivatives;
mod figures;
mod recursion;
mod reference;
mod scenes;
