"""How estimators and bounds look: labels, colours, marks and dashes of the page, which a test compares."""

from dataclasses import dataclass


@dataclass(frozen=True)
class Look:
    """One estimator or bound."""

    label: str
    token: str
    """The name of its colour in a theme."""
    mark: str = "disc"
    """The shape that doubles the colour."""
    dash: tuple[int, ...] = ()


TRACKERS = {
    "kf": Look("KF", "kf", "ring"),
    "ortho": Look("KF-ortho", "ortho", "square"),
    "uc-kf": Look("UC-KF", "uc-kf", "triangle"),
    "et-kf": Look("ET-KF", "et-kf", "diamond"),
    "eskf": Look("ESKF", "eskf", "disc"),
    "eskf-raw": Look("ESKF raw", "eskf-raw", "cross"),
}

TRACK_BOUNDS = {
    "posterior_crb": Look("posterior CRB", "bound", dash=(7, 4)),
    "posterior_crb_raw": Look("posterior CRB, raw", "bound", dash=(10, 3, 2, 3)),
    "linear_posterior_crb": Look("linear posterior CRB", "bound", dash=(2, 4)),
}

FILTERS = {
    "ekf": Look("EKF", "kf", "ring"),
    "ekf-full": Look("EKF, full Jacobian", "kf", "cross", (7, 4)),
    "ekf-retraction": Look("EKF, retraction only", "ortho", "square"),
    "ekf-rie": Look("EKFRie", "uc-kf", "triangle", (7, 4)),
    "ukf": Look("UKF", "et-kf", "diamond"),
    "ukf-rie": Look("UKFRie", "et-kf", "triangle", (7, 4)),
    "mekf": Look("MEKF", "eskf", "disc"),
    "lie-kf": Look("LIEKF", "eskf", "diamond", (7, 4)),
    "tight": Look("MEKF on ranges", "eskf-raw", "cross", (2, 3)),
}

KINEMATICS = {
    "algorithm-1-rank1": Look("Alg. 1, rank one", "kf", "square"),
    "algorithm-1-so": Look("Alg. 1, O(D)", "kf", "triangle", (7, 4)),
    "algorithm-1-lifted": Look("Alg. 1, lifted", "kf", "diamond", (14, 4)),
    "algorithm-1-literal": Look("Alg. 1, as printed", "kf", "cross", (2, 3)),
    "algorithm-2-rank1": Look("Alg. 2, rank one", "ortho", "triangle"),
    "algorithm-2-so": Look("Alg. 2, O(D)", "ortho", "square", (7, 4)),
    "algorithm-2-lifted": Look("Alg. 2, lifted", "ortho", "ring", (14, 4)),
    "algorithm-2-literal": Look("Alg. 2, as printed", "ortho", "cross", (2, 3)),
    "snapshot-sync": Look("Snapshot sync", "et-kf", "diamond"),
    "maximum-likelihood": Look("ML, distances", "eskf", "disc"),
    "maximum-likelihood-full": Look("ML, every distance", "eskf", "cross", (7, 4)),
    "maximum-likelihood-accelerometers": Look("ML, all readings", "uc-kf", "ring"),
    "maximum-likelihood-accelerometers-full": Look("ML, every reading", "uc-kf", "cross", (7, 4)),
    "multidimensional-scaling": Look("MDS of each epoch", "eskf-raw", "triangle"),
    "range-polynomial": Look("Polynomial of each range", "eskf-raw", "cross", (7, 4)),
}

LOCALIZERS = {
    "classical-ls": Look("classical LS", "eskf-raw", "cross"),
    "ls": Look("LS", "kf", "ring"),
    "suc-ls": Look("SUC-LS", "ortho", "square"),
    "suc-ls-weighted": Look("weighted SUC-LS", "ortho", "disc"),
    "ouc-ls": Look("OUC-LS", "uc-kf", "triangle"),
    "suc-tls": Look("SUC-TLS", "ortho", "square"),
    "ouc-tls-printed": Look("printed OUC-TLS", "et-kf", "diamond"),
    "ouc-tls": Look("OUC-TLS", "eskf", "disc"),
    "gauss-newton": Look("Gauss-Newton step", "eskf-raw", "square"),
    "maximum-likelihood": Look("ML", "eskf-raw", "disc"),
}

LOCALIZER_BOUNDS = {
    "uc_crb": Look("UC-CRB", "bound", dash=(7, 4)),
    "uc_crb_raw": Look("UC-CRB, raw ranges", "bound", dash=(4, 2)),
    "crb": Look("CRB, any matrix", "bound", dash=(2, 4)),
    "classical_crb": Look("CRB, each sensor", "bound", dash=(10, 3, 2, 3)),
}

KINEMATICS_BOUNDS = {
    "distances": Look("CRB, distances", "bound", dash=(7, 4)),
    "accelerometers": Look("CRB, all readings", "bound", dash=(2, 4)),
}
