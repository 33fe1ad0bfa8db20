//! Studies beside the averages over time: what projections buy, and what drawing anchors anew does.

mod anchor_draws;
mod budget;
mod indoor_sweep;
mod kinematics_sweep;
