//! The inertial filters against the figures of the corrected paper, an independent implementation, finite differences and
//! the chi-square law; then the edges, where an answer is finite or a typed error.

mod table;
