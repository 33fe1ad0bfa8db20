"""A rigid body tracked through time: estimators side by side with their bounds, and the bound over a plane."""

from dataclasses import dataclass
from dataclasses import field as entry
from typing import Any

import numpy as np

from ...arrays import Floats
from ...field import Field
from ...recording import Recording
from ...run import EstimatorRun, Run
from ...scenario import Scenario
from .. import shapes
from ..canvas import Canvas
from ..looks import TRACK_BOUNDS, TRACKERS, Look
from ..picture import Handle, Wish
from ..plots import Plot
from ..readout import Row, Table
from ..study_page import StudyPage
from . import drawing
from .averages import Averaged
from .field_told import field_sentence
from .obstacles import obstacle_handles
from .room import advice_of, draw_room, field_of
from .track_averages import averaged_plots, averaged_readout
from .track_findings import told_at
from .track_plots import plots_of, shown_bounds
from .way_points import points_of


@dataclass
class TrackPicture(Averaged):
    """A run of trackers, and the field where it is wished for."""

    wish: Wish
    run: Run
    field: Field | None
    document: dict[str, Any] = entry(default_factory=dict)
    """The scenario; empty where the run is one of a recording."""
    advice: dict[str, Any] | None = None
    """How good the places of the anchors are and in which way they get better, where it is wished for."""

    @property
    def name(self) -> str:
        """What people call it."""
        return self.run.name

    @property
    def times(self) -> Floats:
        """Time of each epoch, s: K."""
        return self.run.times

    @property
    def outline(self) -> Floats:
        """Anchors and the true track."""
        return np.concatenate([self.run.anchors, self.run.truth_positions])

    @property
    def magnification(self) -> float:
        """10 as on the page's default scene, fewer where errors would leave it."""
        errors = [each.position_errors[len(each.position_errors) // 2 :] for each in self.run.estimators.values()]
        return min(10.0, drawing.magnification(errors, drawing.extent_of(self.outline), 0.5))

    @property
    def body(self) -> Floats:
        """The sensors as they are drawn, in the body frame, m: N x D."""
        return self.run.sensors * drawing.body_scale(self.run.sensors, drawing.extent_of(self.outline))

    def sentences(self) -> list[str]:
        """What ranges do not show, who stopped and why, and what the colours of the field mean."""
        run = self.run
        stopped = [f"{each.label} stopped: {each.failure[1]}" for each in run.estimators.values() if each.failure]
        scale = drawing.body_scale(run.sensors, drawing.extent_of(self.outline))
        told_of_field = "" if self.field is None else field_sentence(self.field, self.document)
        told = [run.unseen or "", *stopped, told_of_field, *drawing.scale_sentence(scale)]
        return list(filter(None, told))

    def handles(self) -> list[Handle]:
        """Anchors, the body's start, obstacles; a recording has none."""
        source = self.wish.source
        if not isinstance(source, Scenario):
            return [_anchor(m, place, fixed=True) for m, place in enumerate(self.run.anchors)]
        document = source.to_dict()
        return [*anchor_handles(document), *_way_points(document), *obstacle_handles(document)]

    def plots(self) -> list[Plot]:
        """The page's plots of one run, or of the study that there is."""
        study = self.wish.study
        if isinstance(study, StudyPage):
            return study.plots(self.document)
        if self.averages is not None:
            return averaged_plots(self.averages, self.times, shown_bounds(self.run))
        return plots_of(self.run, self.document)

    def readout(self, step: int) -> Table:
        """Errors and bounds at a step, and root mean squares over the run, with what there is to be told of them."""
        run, study = self.run, self.wish.study
        if self.averages is not None:
            return averaged_readout(self.averages, step, list(run.estimators), shown_bounds(run))
        rows = [self._row(TRACKERS[name], each, step) for name, each in run.estimators.items()]
        for name in shown_bounds(run):
            bound = run.bounds[name]
            rows.append(Row(TRACK_BOUNDS[name], drawing.readings(bound.orientation, bound.position, step)))
        heads = ("orient.\ndeg", "position\nm")
        told = study.sentence(self.document) if isinstance(study, StudyPage) else told_at(run, step)
        return Table((("at this step", heads), ("RMSE of the run", heads)), tuple(rows), told)

    def draw(self, canvas: Canvas, step: int, magnify: float) -> None:
        """Track, body, ranges, estimates with their ellipsoids, obstacles, the field."""
        run, truth = self.run, self.run.truth_positions
        if np.isfinite(truth).all():
            drawing.draw_truth(canvas, run.truth_orientations, truth, self.body, step)
            sensors = shapes.body(run.truth_orientations[step], truth[step], self.body)
            drawing.draw_ranges(canvas, run.anchors, sensors, run.present[step])
            if self.wish.fans and shown_bounds(run):
                turns = run.bounds[shown_bounds(run)[0]].rotation_covariances[step]
                drawing.draw_fans(canvas, "bound", "bound", run.truth_orientations[step], turns, truth[step])
        manner = drawing.Manner(truth, self.body, magnify, self.wish.fans)
        for (name, each), rim in zip(run.estimators.items(), drawing.rims(len(run.estimators)), strict=True):
            positions = drawing.draw_estimate(canvas, TRACKERS[name], each, step, rim, manner)
            canvas.marks(f"/estimators/{name}/events", shapes.lifted(positions[each.events]), TRACKERS[name], 0.3)
        if self.document:
            draw_room(canvas, self.document, self.outline, self.field, self.advice)

    def _row(self, look: Look, each: EstimatorRun, step: int) -> Row:
        return Row(
            look, drawing.readings(each.orientation_errors, each.position_errors, step), drawing.ended(each, step)
        )


def track(wish: Wish) -> TrackPicture:
    """Runs the crate.

    Raises:
        Error: in a sentence.
    """
    source = wish.source
    if isinstance(source, Recording):
        settings = {} if wish.estimators is None else {"enabled": list(wish.estimators)}
        return TrackPicture(wish, source.run(settings), None)
    assert isinstance(source, Scenario)
    return TrackPicture(wish, source.run(wish.trial), field_of(wish, source), source.to_dict(), advice_of(wish, source))


def _anchor(m: int, place: Floats, *, fixed: bool = False) -> Handle:
    return Handle(
        f"/anchors/{m}",
        f"A{m + 1}",
        place,
        lambda to, _: lambda scenario: scenario.replace({f"anchors[{m}]": to}),
        fixed=(fixed, fixed, fixed),
    )


def anchor_handles(document: dict[str, Any]) -> list[Handle]:
    """The anchors, unless they are drawn anew for every trial, and the body's start."""
    drawn = document["redraw_anchors"] is not None
    anchors = [_anchor(m, np.array(place), fixed=drawn) for m, place in enumerate(document["anchors"])]
    return [*anchors, _start(document["start"])]


def _way_points(document: dict[str, Any]) -> list[Handle]:
    """The points of a path drawn by hand."""
    return [_way_point(i, np.array(place)) for i, place in enumerate(points_of(document))]


def _way_point(i: int, place: Floats) -> Handle:
    return Handle(
        f"/way/{i}",
        str(i + 1),
        place,
        lambda to, _: lambda scenario: scenario.replace({f"motion.path.points[{i}]": to}),
        token="accent",
        size=0.6,
    )


def _start(start: dict[str, Any]) -> Handle:
    return Handle(
        "/start",
        "start",
        np.array(start["position"]),
        lambda to, turned: lambda scenario: scenario.replace({"start.orientation": turned, "start.position": to}),
        orientation=np.array(start["orientation"]),
        size=1.2,
    )
