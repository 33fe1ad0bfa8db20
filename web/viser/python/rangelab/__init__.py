"""Position and orientation of a rigid body, and motions of nodes without anchors, from ranges.

Estimators, their bounds, studies and figures.

Metres, seconds and radians unless a name says otherwise. Orientations `Q` and positions `t` take the body frame to the
world frame, `s = Q c + t`. In shapes K counts epochs, M anchors, N sensors, D dimensions (2 or 3), A angles (1 or 3);
in networks without anchors K counts stamps and N nodes, whose vectors are rows.
The same scenario and trial give the same bits here, on the command line and on the page.

>>> import rangelab
>>> run = rangelab.Scenario.preset("room").run(trial=0)
>>> run["uc-kf"].position_errors.shape
(20,)
"""

from importlib.metadata import version as _version

from ._core import (
    Cancelled,
    Error,
    InternalError,
    InvalidDocument,
    NoConvergence,
    UnknownName,
    Unobservable,
)
from .consistency import chi_squared_interval
from .distances import DistanceRecord, KinematicsEstimate, kinematics_estimators
from .draws import AnchorDraws
from .figures import Figure, figure, figures
from .gram_spectrum import GramSpectrum
from .indoor import IndoorRun, IndoorScenario, indoor_presets
from .kinematics import KinematicsBound, KinematicsScenario, SimulatedKinematics, kinematics_presets
from .kinematics_run import KinematicsEstimatorRun, KinematicsRun
from .link import from_link, to_link
from .motion import RelativeKinematics
from .recording import Recording
from .run import BoundRun, EstimatorRun, Run
from .scenario import Scenario, presets, topologies
from .snapshot import Snapshot
from .studies import Curve, Study
from .tracker import Track, Tracker

__version__ = _version("rangelab")

__all__ = [
    "AnchorDraws",
    "BoundRun",
    "Cancelled",
    "Curve",
    "DistanceRecord",
    "Error",
    "EstimatorRun",
    "Figure",
    "GramSpectrum",
    "IndoorRun",
    "IndoorScenario",
    "InternalError",
    "InvalidDocument",
    "KinematicsBound",
    "KinematicsEstimate",
    "KinematicsEstimatorRun",
    "KinematicsRun",
    "KinematicsScenario",
    "NoConvergence",
    "Recording",
    "RelativeKinematics",
    "Run",
    "Scenario",
    "SimulatedKinematics",
    "Snapshot",
    "Study",
    "Track",
    "Tracker",
    "UnknownName",
    "Unobservable",
    "chi_squared_interval",
    "figure",
    "figures",
    "from_link",
    "indoor_presets",
    "kinematics_estimators",
    "kinematics_presets",
    "presets",
    "to_link",
    "topologies",
]
