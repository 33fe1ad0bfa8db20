"""What runs are held against: bands of chi-square, spectra of Gram matrices, which ranges there were."""

import numpy as np
import pytest
import rangelab
from rangelab import IndoorScenario, KinematicsScenario


def test_the_interval_of_chi_square_holds_so_many_of_its_draws() -> None:
    # Abramowitz and Stegun, table 26.8: 12 degrees of freedom.
    assert np.allclose(rangelab.chi_squared_interval(12), (4.40379, 23.3367), rtol=0, atol=5e-5)
    low, high = rangelab.chi_squared_interval(12, 0.5)
    draws = np.random.default_rng(1).chisquare(12, 100_000)
    within = ((draws > low) & (draws < high)).mean()
    assert abs(within - 0.5) < 4 * np.sqrt(0.25 / 100_000)
    with pytest.raises(rangelab.Error, match="below 1"):
        rangelab.chi_squared_interval(12, 1.0)
    with pytest.raises(rangelab.Error, match="from 1 to 1e9"):
        rangelab.chi_squared_interval(0)


def test_the_spectrum_is_that_of_the_gram_matrices_of_the_trial() -> None:
    scenario = KinematicsScenario.preset()
    spectrum = scenario.gram_spectrum(3)
    simulated = scenario.simulate(3)
    places = simulated.truth.coefficients[0]
    expected = np.linalg.eigvalsh(places @ places.T)[::-1]
    assert np.allclose(spectrum.truth, expected, rtol=0, atol=1e-9 * expected[0])
    record = simulated.record
    epoch = np.abs(record.stamps).argmin()
    squares = np.nan_to_num(record.distances[epoch]) ** 2
    centring = np.eye(10) - 0.1
    gram = -0.5 * centring @ squares @ centring
    found = np.sort(np.linalg.eigvalsh(gram))[::-1]
    assert np.allclose(spectrum.epoch, found, rtol=0, atol=1e-9 * expected[0])
    # The trial is heard.
    assert not np.allclose(spectrum.epoch, scenario.gram_spectrum(4).epoch, rtol=0, atol=1e-9 * expected[0])


def test_a_run_tells_which_ranges_there_were() -> None:
    scenario = IndoorScenario.preset("indoor-u")
    run = scenario.run()
    assert run.present.shape == (len(run.times), len(run.beacons), 3)
    assert np.array_equal(run.present.all(axis=(1, 2)), run.fixes)
    assert not run.present[~run.fixes].any()
    sparse = scenario.replace({"ranging.missing_probability": 0.5}).run()
    share = sparse.present[sparse.fixes].mean()
    assert abs(share - 0.5) < 4 * np.sqrt(0.25 / sparse.present[sparse.fixes].size)
