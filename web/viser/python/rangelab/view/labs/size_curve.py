"""How large the body must be for what orientation: the bound against the size of the body."""

from dataclasses import dataclass

import numpy as np

from ...arrays import Floats
from ...scenario import Scenario
from ..looks import Look
from ..plots import Line, Plot

DECADES, POINTS = 3, 12
"""From a thousandth of the scene to all of it, so many points in a power of ten."""
MANY_RANGES, FEWER_POINTS = 2000, 3
"""With more ranges than this a point takes so long that a drag would stutter."""
SLOPE_TOLERANCE = 0.02
"""Slopes nearer than this to -1 are that of small bodies."""
FORMS = {"projected": Look("projected ranges", "bound", dash=(7, 4)), "raw": Look("raw ranges", "bound", dash=(2, 2))}


def size_of(sensors: Floats) -> float:
    """Largest distance between two sensors (N x D, m); 0 for a single one."""
    return float(np.linalg.norm(sensors[:, None] - sensors[None], axis=2).max())


@dataclass(frozen=True)
class SizeCurves:
    """The bounds on the orientation of the same body in other sizes."""

    size: float
    """Its own, m."""
    sizes: Floats
    """m, increasing; its own is among them."""
    bounds: dict[str, Floats]
    """By the form of the ranges, deg; NaN where there is none."""
    form: str
    """Which one the field shows."""

    @classmethod
    def of(cls, scenario: Scenario) -> "SizeCurves":
        """By the crate."""
        document = scenario.to_dict()
        size = size_of(scenario.sensors)
        many = len(scenario.anchors) * len(scenario.sensors) > MANY_RANGES
        extent = float(np.ptp(scenario.anchors, axis=0).max()) or 1.0
        sizes = sizes_around(size, extent, FEWER_POINTS if many else POINTS)
        bounds = {form: np.full(len(sizes), np.nan) for form in FORMS}
        if size > 0:
            for form in FORMS:
                bounds[form] = np.degrees(scenario.replace({"field.form": form}).size_curve(sizes / size))
        return cls(size, sizes, bounds, document["field"]["form"])

    def plot(self) -> Plot:
        """Both curves, and where the body is."""
        lines = [Line(FORMS[form], each) for form, each in self.bounds.items() if np.isfinite(each).any()]
        if lines and self.size > 0:
            own = np.where(np.isclose(self.sizes, self.size, rtol=1e-9), self.bounds[self.form], np.nan)
            lines.append(Line(Look("this body", "accent"), own, dots=True))
        axis = "size of the body, m"
        return Plot("Orientation bound by size, deg", self.sizes, tuple(lines), axis, logarithmic_x=True)

    def sentence(self) -> str:
        """How the bound falls while bodies are small, and from which size on one degree is reached."""
        bounds = self.bounds[self.form]
        if self.size == 0:
            return "A single sensor has no size."
        slope = float(np.log(bounds[1] / bounds[0]) / np.log(self.sizes[1] / self.sizes[0]))
        if not np.isfinite(slope):
            return "No size lets these sensors see every rotation."
        inverse = " (∝ 1/size)" if abs(slope + 1) < SLOPE_TOLERANCE else ""
        needed = size_for(1.0, self.sizes, bounds)
        reached = "1 deg is not reached" if needed is None else f"1 deg from {needed:.3g} m"
        return f"Small bodies: orientation bound of slope {slope:.3g}{inverse}; {reached}.".replace("-", "−")


def sizes_around(size: float, extent: float, points: int) -> Floats:
    """Even steps on a logarithmic scale that hold the size itself, over whole decades of the scene, m."""
    top = np.ceil(np.log10(extent) - 1e-9)
    own = np.log10(size) if size > 0 else top
    low, high = min(top - DECADES, np.floor(own)), max(top, np.ceil(own))
    steps = 10.0 ** (low + np.arange(int(high - low) * points + 1) / points)
    if size == 0:
        return np.asarray(steps)
    return np.sort(np.append(steps[np.abs(np.log(steps / size)) > 1e-6], size))


def size_for(wanted: float, sizes: Floats, bounds: Floats) -> float | None:
    """The least size at which a bound is no larger, between points on a straight line of logarithms."""
    there = np.nonzero(bounds <= wanted)[0]
    if not len(there):
        return None
    i = int(there[0])
    if i == 0:
        return float(sizes[0])
    share = np.log(bounds[i - 1] / wanted) / np.log(bounds[i - 1] / bounds[i])
    return float(sizes[i - 1] * (sizes[i] / sizes[i - 1]) ** share)
