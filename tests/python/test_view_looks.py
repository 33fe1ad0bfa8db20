"""The viewer looks as the page does: its colours, marks and dashes are compared with those of the page's sources."""

import re

import pytest
from conftest import ROOT
from rangelab import Scenario
from rangelab.view import colours, looks, themes


@pytest.mark.parametrize("theme", themes.THEMES)
def test_colours_are_those_of_the_page(theme: str) -> None:
    css = (ROOT / "web/page/src/theme/tokens.css").read_text()
    found = re.search(rf'data-theme="{theme}"\] \{{(.*?)\n\}}', css, re.S)
    assert found is not None
    tokens = dict(re.findall(r"--([a-z-]+): (#[0-9a-f]{6})", found[1]))
    ours = themes.THEMES[theme].tokens
    assert {token: tokens.get(token) for token in ours} == ours
    weight = re.search(r"--line-weight: ([\d.]+);", found[1])
    assert themes.THEMES[theme].weight == (float(weight[1]) if weight else 1.0)
    assert themes.THEMES[theme].dark == ("color-scheme: dark" in found[1])


def test_the_field_is_coloured_as_on_the_page() -> None:
    stops = (ROOT / "web/page/src/theme/field-colours.ts").read_text()
    assert re.findall(r'^  "(#[0-9a-f]{6})"', stops, re.M) == colours.FIELD_STOPS


Written = dict[str, tuple[str, str, str, tuple[int, ...]]]


def looks_written_in(path: str) -> Written:
    """What a list of estimators of the page says: label, colour, mark and dash by name."""
    text = re.sub(r"\s+", " ", (ROOT / path).read_text())
    entries = re.findall(r'\{ name: "([^"]+)", label: "([^"]+)", (.*?)\}', text)
    found = {}
    for name, label, rest in entries:
        fields = dict(re.findall(r'(token|mark): "([^"]+)"', rest))
        dash = re.search(r"dash: (DASH|\[[\d, ]*\])", rest)
        numbers = "[7, 4]" if dash and dash[1] == "DASH" else dash[1] if dash else "[]"
        found[name] = (label, fields["token"], fields["mark"], tuple(int(n) for n in re.findall(r"\d+", numbers)))
    return found


@pytest.mark.parametrize(
    ("path", "ours", "least"),
    [
        ("web/page/src/labs/indoor/filters.ts", looks.FILTERS, 9),
        ("web/page/src/labs/anchorless/estimators.ts", looks.KINEMATICS, 7),
        ("web/page/src/labs/localize/localizers.ts", looks.LOCALIZERS, 10),
    ],
)
def test_estimators_look_as_on_the_page(path: str, ours: dict[str, looks.Look], least: int) -> None:
    written = looks_written_in(path)
    assert len(written) >= least
    assert written == {name: (ours[name].label, ours[name].token, ours[name].mark, ours[name].dash) for name in written}


def test_trackers_and_bounds_look_as_on_the_page() -> None:
    palette = (ROOT / "web/page/src/theme/palette.ts").read_text()
    marks = re.search(r"MARKS.*?\{(.*?)\}", palette, re.S)
    assert marks is not None
    found = dict(re.findall(r'"?([a-z-]+)"?: "([a-z]+)"', marks[1]))
    assert found == {name: look.mark for name, look in looks.TRACKERS.items()}
    plots = (ROOT / "web/page/src/labs/track/plots.ts").read_text()
    for name, look in looks.TRACK_BOUNDS.items():
        assert f'{name}: {{ short: "{look.label}", dash: {list(look.dash)} }}' in plots
    localizers = (ROOT / "web/page/src/labs/localize/localizers.ts").read_text()
    for name, look in looks.LOCALIZER_BOUNDS.items():
        assert f'{name}: {{ label: "{look.label}", dash: {list(look.dash)} }}' in localizers
    run = Scenario.preset("room").run()
    assert {name: each.label for name, each in run.estimators.items()} == {
        name: look.label for name, look in looks.TRACKERS.items() if name in run.estimators
    }


@pytest.mark.parametrize("algorithm", [1, 2])
def test_solvers_of_both_algorithms_look_as_on_the_page(algorithm: int) -> None:
    text = (ROOT / "web/page/src/labs/anchorless/estimators.ts").read_text()
    call = re.search(rf'solvers\({algorithm}, "([a-z-]+)", \[(.*?)\]\)', text)
    assert call is not None
    marks = re.findall(r'"(\w+)"', call[2])
    solvers = re.findall(r'of\("(\w+)", "([^"]+)", "[^"]+", (\d), (DASH|LONG|DOTS|\[\])\)', text)
    dashes = {"[]": (), "DASH": (7, 4), "LONG": (14, 4), "DOTS": (2, 3)}
    assert len(solvers) == 4
    for solver, label, index, dash in solvers:
        expected = looks.Look(f"Alg. {algorithm}, {label}", call[1], marks[int(index)], dashes[dash])
        assert looks.KINEMATICS[f"algorithm-{algorithm}-{solver}"] == expected
