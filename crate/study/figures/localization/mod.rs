//! The figures of \[L\]: errors of snapshot estimators from no noise to speak of to nothing but noise.

mod claims;
mod experiments;
mod panels;
mod perturbed;
mod reading;

use super::{Figure, Paper};

const TRIALS: usize = 2000;

pub(super) const FIGURE_2: Figure = Figure {
    name: "localization-2",
    paper: Paper::Localization,
    number: "2",
    title: "RMSE of the orientation",
    statement: "LS is efficient and meets the CRB; SUC-LS is similar to OUC-LS, slightly worse; OUC-LS meets the UC-CRB at \
                reasonable noise, in fewer than 5 Newton iterations; below 30 dB the RMSE saturates.",
    trials: TRIALS,
    experiments: experiments::orientation,
    panels: panels::figure_2,
    claims: claims::figure_2,
};

pub(super) const FIGURE_3: Figure = Figure {
    name: "localization-3",
    paper: Paper::Localization,
    number: "3",
    title: "Bias of the orientation",
    statement: "the bias of SUC-LS and OUC-LS tends to zero above 50 dB, and LS has none.",
    trials: TRIALS,
    experiments: experiments::fixed,
    panels: panels::figure_3,
    claims: claims::figure_3,
};

pub(super) const FIGURE_4: Figure = Figure {
    name: "localization-4",
    paper: Paper::Localization,
    number: "4",
    title: "Mean angular error of the orientation",
    statement: "the mean angular error (MAE) shows how range errors become errors of the rotation; the columns of LS are \
                normalized for it.",
    trials: TRIALS,
    experiments: experiments::fixed,
    panels: panels::figure_4,
    claims: claims::figure_4,
};

pub(super) const FIGURE_5: Figure = Figure {
    name: "localization-5",
    paper: Paper::Localization,
    number: "5",
    title: "RMSE of the position, beside classical LS",
    statement: "the position of the body is close to an order of magnitude better than by classical LS of its sensors.",
    trials: TRIALS,
    experiments: experiments::sensors,
    panels: panels::figure_5,
    claims: claims::figure_5,
};

pub(super) const FIGURE_6: Figure = Figure {
    name: "localization-6",
    paper: Paper::Localization,
    number: "6",
    title: "RMSE of the sensors by topology-aware localization",
    statement: "sensors are found better by topology-aware localization, which knows the body, than by classical LS.",
    trials: TRIALS,
    experiments: experiments::sensors,
    panels: panels::figure_6,
    claims: claims::figure_6,
};

pub(super) const FIGURE_7: Figure = Figure {
    name: "localization-7",
    paper: Paper::Localization,
    number: "7",
    title: "RMSE of the orientation, sensors misplaced by 10 cm",
    statement: "with perturbed sensors all estimators have an error floor, and total least squares takes the perturbation \
                into account.",
    trials: TRIALS,
    experiments: experiments::perturbed,
    panels: panels::figure_7,
    claims: perturbed::figure_7,
};

pub(super) const FIGURE_8: Figure = Figure {
    name: "localization-8",
    paper: Paper::Localization,
    number: "8",
    title: "Mean angular error of the orientation, sensors misplaced by 10 cm",
    statement: "the mean angular error (MAE) of SUC-TLS and OUC-TLS has a floor too.",
    trials: TRIALS,
    experiments: experiments::perturbed,
    panels: panels::figure_8,
    claims: perturbed::figure_8,
};

pub(super) const FIGURE_9: Figure = Figure {
    name: "localization-9",
    paper: Paper::Localization,
    number: "9",
    title: "RMSE of the position, sensors misplaced by 10 cm",
    statement: "the RMSE of the position is that without perturbation, except for an error floor.",
    trials: TRIALS,
    experiments: experiments::perturbed,
    panels: panels::figure_9,
    claims: perturbed::figure_9,
};
