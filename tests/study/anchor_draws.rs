//! Anchors drawn anew against the independent reference, and against the fixed ones.

use rangelab::model::noise::RangeNoise;
use rangelab::model::presets::preset;
use rangelab::model::scenario::Scenario;
use rangelab::study::anchor_draws::{AnchorDraws, Pair};
use rangelab::study::quantile::quantile;

const SHARES: [f64; 3] = [0.5, 0.95, 0.99];

fn draws(name: &str, anchors: usize, count: usize) -> Vec<Pair> {
    let mut scenario = preset(name).unwrap();
    let given = scenario.anchors.clone();
    scenario.anchors = given.iter().cycle().take(anchors).cloned().collect();
    // Only their number matters where they are redrawn; doubled ones are moved apart.
    scenario.anchors.iter_mut().skip(given.len()).flatten().for_each(|x| *x *= -0.7);
    let study = AnchorDraws::new(&scenario, count).unwrap();
    (0..study.blocks()).flat_map(|index| study.block(index).unwrap()).collect()
}

/// Whether so large a share of the conditions lies up to `limit`, within three standard errors of a share.
fn holds(conditions: &[f64], limit: f64, share: f64, rounding: f64) -> bool {
    let count = conditions.len() as f64;
    let below =
        |limit: f64| conditions.iter().filter(|&&condition| condition <= limit).count() as f64 / count;
    let spread = 3.0 * (share * (1.0 - share) / count).sqrt();
    below(limit - rounding) <= share + spread && below(limit + rounding) >= share - spread
}

#[test]
fn conditions_of_drawn_anchors_are_those_of_the_reference() {
    let reference = [(4, [6.6, 74.0, 382.0], [0.05, 0.5, 0.5]), (8, [2.4, 4.6, 6.6], [0.05; 3])];
    let [four, eight] = reference.map(|(anchors, limits, roundings)| {
        let conditions: Vec<f64> = draws("localization-paper-redrawn", anchors, 2000)
            .iter()
            .filter_map(|pair| pair.redrawn.condition)
            .collect();
        assert_eq!(conditions.len(), 2000);
        let found = SHARES.map(|share| quantile(conditions.iter().copied(), share).unwrap());
        println!("{anchors} anchors: {found:.2?}");
        for ((share, limit), rounding) in SHARES.into_iter().zip(limits).zip(roundings) {
            assert!(holds(&conditions, limit, share, rounding), "{anchors} anchors, {share}: {found:?}");
        }
        conditions
    });
    assert!(!holds(&four, 2.4, 0.5, 0.05) && !holds(&eight, 6.6, 0.5, 0.05), "one taken for the other");
}

/// The fixed draw is the median one; badly conditioned draws hurt the position, and the unconstrained orientation more
/// than the constrained one.
#[test]
fn badly_conditioned_anchors_hurt_whom_the_paper_says() {
    let pairs = draws("tracking-paper-redrawn", 4, 400);
    let worst = quantile(pairs.iter().filter_map(|pair| pair.redrawn.condition), 0.9).unwrap();
    let bad: Vec<_> = pairs.iter().filter(|pair| pair.redrawn.condition.unwrap() > worst).collect();
    let median = |of: &dyn Fn(&Pair) -> f64, among: &[&Pair]| {
        quantile(among.iter().map(|pair| of(pair)), 0.5).unwrap()
    };
    let all: Vec<_> = pairs.iter().collect();
    let angle = |of: usize| move |pair: &Pair| pair.redrawn.errors[of].unwrap().angle;
    let loss = |of: usize| median(&angle(of), &bad) / median(&angle(of), &all);
    println!("loss of angle: KF {}, UC-KF {}", loss(0), loss(1));
    assert!(loss(0) > 1.5 * loss(1));
    let position = |pair: &Pair| pair.redrawn.bound.unwrap().position;
    assert!(median(&position, &bad) > 3.0 * median(&position, &all));
    // Of fixed anchors only the place of the body changes, by a metre in a kilometre.
    let fixed = pairs[0].fixed.condition.unwrap();
    assert!(pairs.iter().all(|pair| (pair.fixed.condition.unwrap() / fixed - 1.0).abs() < 0.02));
}

#[test]
fn draws_travel_as_the_same_bits_and_do_not_depend_on_how_many_there_are() {
    let scenario = preset("room").unwrap();
    let study = AnchorDraws::new(&scenario, 30).unwrap();
    let blocks: Vec<Pair> = (0..2).flat_map(|index| study.block(index).unwrap()).collect();
    assert_eq!(blocks.len(), 30);
    assert_eq!(Pair::from_numbers(&Pair::to_numbers(&blocks)).unwrap(), blocks);
    assert_eq!(AnchorDraws::new(&scenario, 60).unwrap().block(0).unwrap(), blocks[..20]);
    assert!(Pair::from_numbers(&[1.0; 3]).is_err());
    assert!(AnchorDraws::new(&scenario, 0).is_err());
}

/// Weights tell: with errors that do not grow with the distance the same anchors are conditioned otherwise.
#[test]
fn the_condition_is_that_of_the_anchors_as_they_are_weighed() {
    let condition = |noise| {
        let scenario = Scenario { noise, ..preset("localization-paper").unwrap() };
        AnchorDraws::new(&scenario, 1).unwrap().block(0).unwrap()[0].fixed.condition.unwrap()
    };
    let [growing, steady] =
        [RangeNoise::Toa { zeta_db: 60.0 }, RangeNoise::Range { sigma: 0.1 }].map(condition);
    assert!((growing / steady - 1.0).abs() > 0.03, "{growing} and {steady}");
    let louder = condition(RangeNoise::Toa { zeta_db: 30.0 });
    assert!((louder / growing - 1.0).abs() < 1e-9, "the level of the noise does not matter: {louder}");
}

#[test]
fn anchors_in_a_plane_have_no_condition() {
    let scenario = preset("coplanar-ceiling").unwrap();
    let mut flat = scenario.clone();
    flat.anchors.iter_mut().for_each(|anchor| anchor[2] = 3.0);
    let pair = AnchorDraws::new(&flat, 1).unwrap().block(0).unwrap()[0];
    assert_eq!(pair.fixed.condition, None);
    assert!(pair.redrawn.condition.is_some_and(|condition| condition > 1.0));
}
