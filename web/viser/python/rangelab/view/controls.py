"""The panel of controls: those of the page, by the same names."""

from collections.abc import Callable
from typing import Any

import viser

from .._core import Error
from ..link import from_link, to_link
from ..scenario import Scenario, presets
from .handles import by_hand, put
from .state import Studio

TRACKERS = {"kf": "KF", "ortho": "KF-ortho", "uc-kf": "UC-KF", "et-kf": "ET-KF", "eskf": "ESKF", "eskf-raw": "ESKF-raw"}

# What is typed, where it is in the scenario, what people read, and its least value and step.
NUMBERS = (
    ("Motion", "interval", "interval, s", 1e-3, 0.01),
    ("Motion", "motion.sigma_omega", "turning disturbed by, rad/s", 0.0, 0.001),
    ("Motion", "motion.sigma_t", "moving disturbed by, m", 0.0, 0.001),
    ("Motion", "process.sigma_q", "turning noise assumed, rad", 0.0, 0.001),
    ("Motion", "process.sigma_t", "moving noise assumed, m", 0.0, 0.001),
    ("Start", "initial.covariance", "variance of each entry of [Q | t]", 1e-9, 1.0),
    ("Estimators", "estimators.threshold.epsilon", "ET-KF threshold", 0.0, 0.01),
    ("Ranges", "missing_probability", "missing ranges, probability", 0.0, 0.01),
    ("Ranges", "mounting_sigma", "mounting error, m", 0.0, 0.001),
    ("Run", "steps", "epochs", 1, 1),
    ("Run", "seed", "seed", 0, 1),
)
# What is chosen: where it is in the scenario, what people read, and what there is.
CHOICES = (
    ("Ranges", "weights", "weights from", ("measured", "true")),
    ("Ranges", "weighting", "weights of sensors", ("common", "per_pair")),
    ("Estimators", "estimators.threshold.kind", "threshold counts", ("absolute", "relative")),
    ("Estimators", "estimators.manifold", "project onto", ("so", "o")),
    ("Estimators", "estimators.metric", "nearest in", ("frobenius", "information")),
)
SWITCHES = (
    ("Estimators", "estimators.feedback", "go on from the projected Q"),
    ("Estimators", "estimators.decoupled", "UC-KF solves for Q, then for t"),
)
NOISE = {"range": ("sigma", "sigma of a range, m"), "squared_range": ("sigma", "sigma of a squared range, m²")}
NOISE_DB = ("zeta_db", "zeta, dB")


class Controls:
    """Every control writes an edit; `follow` puts them where the scenario is."""

    def __init__(
        self, server: viser.ViserServer, studio: Studio, opened: Callable[[Scenario], None], page: str
    ) -> None:
        self._server, self._studio, self._opened, self._page = server, studio, opened, page
        self._follow: list[Callable[[dict[str, Any]], None]] = []
        self._folders: dict[str, viser.GuiFolderHandle] = {}
        if studio.scenario is not None:
            self._scenario_controls()

    def follow(self, scenario: Scenario) -> None:
        """Shows the values of a scenario, which are no edits."""
        document = scenario.to_dict()
        for write in self._follow:
            write(document)

    def _folder(self, name: str) -> viser.GuiFolderHandle:
        if name not in self._folders:
            self._folders[name] = self._server.gui.add_folder(name, expand_by_default=name in ("Estimators", "Ranges"))
        return self._folders[name]

    def _scenario_controls(self) -> None:
        self._preset()
        self._estimators()
        self._noise()
        for folder, path, label, least, step in NUMBERS:
            self._number(folder, path, label, least, step)
        for folder, path, label, options in CHOICES:
            with self._folder(folder):
                self._bound(path, self._server.gui.add_dropdown(label, options))
        for folder, path, label in SWITCHES:
            with self._folder(folder):
                self._bound(path, self._server.gui.add_checkbox(label, False))
        self._field()
        self._link()

    def _edit(self, path: str, value: Any) -> None:
        self._studio.edit(lambda scenario: scenario.replace({path: value}))

    def _preset(self) -> None:
        names = ("…", *(each["name"] for each in presets()))
        chosen = self._server.gui.add_dropdown("preset", names)
        self._follow.append(lambda document: put(chosen, document["name"] if document["name"] in names else "…"))

        by_hand(chosen, lambda name: self._opened(Scenario.preset(name)) if name != "…" else None)

    def _estimators(self) -> None:
        boxes = {}
        with self._folder("Estimators"):
            for name, label in TRACKERS.items():
                boxes[name] = self._server.gui.add_checkbox(label, True)

        def write(document: dict[str, Any]) -> None:
            for name, box in boxes.items():
                put(box, name in document["estimators"]["enabled"])

        def chosen(_: bool) -> None:
            self._edit("estimators.enabled", [name for name, box in boxes.items() if box.value])

        for box in boxes.values():
            by_hand(box, chosen)
        self._follow.append(write)

    def _noise(self) -> None:
        """One number, whatever the kind of noise calls it."""
        with self._folder("Ranges"):
            number = self._server.gui.add_number("noise", 1.0, step=1e-6)

        def key(document: dict[str, Any]) -> tuple[str, str]:
            return NOISE.get(document["noise"]["kind"], NOISE_DB)

        def write(document: dict[str, Any]) -> None:
            field, label = key(document)
            number.label = label
            put(number, float(document["noise"][field]))

        def typed(value: float) -> None:
            scenario = self._studio.scenario
            if scenario is not None:
                self._edit(f"noise.{key(scenario.to_dict())[0]}", float(value))

        by_hand(number, typed)
        self._follow.append(write)

    def _number(self, folder: str, path: str, label: str, least: float, step: float) -> None:
        whole = isinstance(step, int)
        with self._folder(folder):
            number = self._server.gui.add_number(label, least, min=least, step=step if whole else 1e-6)

        def write(document: dict[str, Any]) -> None:
            put(number, _at(document, path))

        by_hand(number, lambda value: self._edit(path, int(value) if whole else float(value)))
        self._follow.append(write)

    def _bound(self, path: str, handle: Any) -> None:
        """A control that shows one value of the scenario as it is."""
        self._follow.append(lambda document: put(handle, _at(document, path)))
        by_hand(handle, lambda value: self._edit(path, value))

    def _field(self) -> None:
        with self._folder("Bound over a plane"):
            shown = self._server.gui.add_checkbox("show it", self._studio.wish.field)
            quantity = self._server.gui.add_dropdown("of", ("position", "orientation"))

        def write(document: dict[str, Any]) -> None:
            put(quantity, document["field"]["quantity"])
            put(shown, self._studio.wish.field)

        by_hand(shown, lambda value: self._studio.ask(field=value))
        by_hand(quantity, lambda value: self._edit("field.quantity", value))
        self._follow.append(write)

    def _link(self) -> None:
        with self._folder("Link of the page"):
            link = self._server.gui.add_text("link", "", hint="The whole scenario; paste another one to open it.")
            problem = self._server.gui.add_markdown("", visible=False)

        def write(document: dict[str, Any]) -> None:
            put(link, to_link(Scenario(document), self._page))
            problem.visible = False

        def pasted(text: str) -> None:
            try:
                self._opened(from_link(text.strip()))
            except Error as error:
                problem.content, problem.visible = f"**{error}**", True

        by_hand(link, pasted)
        self._follow.append(write)


def _at(document: dict[str, Any], path: str) -> Any:
    """The value of a scenario at a path of names."""
    at: Any = document
    for name in path.split("."):
        at = at[name]
    return at
