#!/usr/bin/env python3
"""Writes bounds.json: bounds computed a second time, from the papers' stacked matrices, in NumPy.

Nothing of the crate is used, and another road is taken wherever there is one: U_M from a QR factorization, whitening by
the symmetric square root, rotations from the matrix exponential by scaling and squaring, the constrained bound from a
null space found by the singular value decomposition of the constraint gradient ([L] eq. 46), posterior bounds as the
inverse of one large information matrix over all steps. Run with NumPy 2 and redirect to bounds.json.
"""

import json

import numpy as np

STEPS = 20
LOCALIZATION_ANCHORS = [[364.7, -285.7, -119.4], [-225.2, 312.0, -466.1], [380.9, 59.64, 81.83], [-440.7, 337.0, 147.8]]
TRACKING_ANCHORS = [[-753.8, 161.8, 701.8], [-680.5, -511.0, 387.2], [-169.7, -647.0, -208.3], [703.6, 218.6, 968.2]]


def hat(v):
    return np.array([[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]])


def exponential(k):
    term = total = np.eye(3)
    for i in range(1, 20):
        term = term @ (k / 1024) / i
        total = total + term
    return np.linalg.matrix_power(total, 1024)


def sensors_of(points):
    c = np.array(points, float).T
    return c - c.mean(axis=1, keepdims=True)


def jacobian(anchors, c, q, t, variance, raw):
    """Whitened derivative of the data in vec([Q | t]), each pair with the variance of its own true range."""
    a = np.array(anchors)
    m = len(a)
    ones = np.ones((m, 1))
    u = np.linalg.qr(np.hstack([ones, np.eye(m)]))[0][:, 1:m]
    rows = []
    for n in range(c.shape[1]):
        s = q @ c[:, n] + t
        r2 = ((a - s) ** 2).sum(axis=1)
        if raw:
            block = (2 * (s - a)) / np.sqrt(variance(r2))[:, None]
        else:
            values, vectors = np.linalg.eigh(u.T @ np.diag(variance(r2)) @ u)
            block = vectors @ np.diag(values**-0.5) @ vectors.T @ u.T @ (-2 * a)
        rows.append(np.kron(np.append(c[:, n], 1.0), block))
    return np.vstack(rows)


def null_space_basis(q):
    """U of [L] eq. 42 from the gradient of the six constraints, eq. 46."""
    q1, q2, q3 = q.T
    z = np.zeros(3)
    g = np.array(
        [
            np.concatenate([2 * q1, z, z, z]),
            np.concatenate([q2, q1, z, z]),
            np.concatenate([q3, z, q1, z]),
            np.concatenate([z, 2 * q2, z, z]),
            np.concatenate([z, q3, q2, z]),
            np.concatenate([z, z, 2 * q3, z]),
        ]
    )
    return np.linalg.svd(g)[2][6:].T


def traces(covariance):
    return {"orientation": float(np.trace(covariance[:9, :9])), "position": float(np.trace(covariance[9:, 9:]))}


def localization_body():
    h = 2.5
    c = sensors_of(
        [[h, h, 0], [-h, h, 0], [-h, -h, 0], [h, -h, 0], [0, 0, 5]]
        + [[h / 2, h / 2, h], [-h / 2, h / 2, h], [-h / 2, -h / 2, h], [h / 2, -h / 2, h], [h, 0, 0]]
    )
    x, y, z = np.eye(3)
    d = np.pi / 180
    return c, exponential(10 * d * hat(z)) @ exponential(-25 * d * hat(y)) @ exponential(20 * d * hat(x))


def localization_jacobian(anchors, c, q, raw):
    return jacobian(anchors, c, q, np.array([100.0, 100, 55]), lambda r2: 4 * r2**2 / 1e6, raw)


def localization():
    c, q = localization_body()
    u = null_space_basis(q)
    result = {}
    for raw in [False, True]:
        j = localization_jacobian(LOCALIZATION_ANCHORS, c, q, raw)
        if not raw:
            result["crb"] = traces(np.linalg.pinv(j) @ np.linalg.pinv(j).T)
        small = np.linalg.pinv(j @ u)
        result["uc_crb_raw" if raw else "uc_crb"] = traces(u @ small @ small.T @ u.T)
    return result


def projection_cost(draws=4000):
    """Medians over random anchors of the root of the UC-CRB projected over raw, with their standard errors."""
    c, q = localization_body()
    u, rng, result = null_space_basis(q), np.random.default_rng(1), []
    for count in [4, 6, 12, 20]:
        ratios = []
        for _ in range(draws):
            anchors = rng.uniform(-500, 500, (count, 3))
            half = [np.linalg.pinv(localization_jacobian(anchors, c, q, raw) @ u) for raw in [False, True]]
            bounds = [traces(u @ x @ x.T @ u.T) for x in half]
            ratios.append([np.sqrt(bounds[0][k] / bounds[1][k]) for k in ["orientation", "position"]])
        ratios = np.sort(np.array(ratios), axis=0)
        middle, away = draws // 2, round(np.sqrt(draws) / 2)
        error = (ratios[middle + away] - ratios[middle - away]) / 2
        result.append(
            {
                "anchors": count,
                "orientation": ratios[middle, 0],
                "orientation_error": error[0],
                "position": ratios[middle, 1],
                "position_error": error[1],
            }
        )
    return result


def tracking():
    h, d = 0.5, np.pi / 180
    c = sensors_of([[h, h, 0], [-h, h, 0], [-h, -h, 0], [h, -h, 0], [0, 0, 1]])
    turn = exponential(d * hat([1, 1, 1]))
    q, t, variance = np.eye(3), np.zeros(3), lambda r2: 0.0316**2 * r2
    poses = []
    for _ in range(STEPS):
        q, t = turn @ q, t + 1
        poses.append((q, t))

    def data(k, raw):
        return jacobian(TRACKING_ANCHORS, c, *poses[k], variance, raw)

    def left_tangent(k):
        columns = [np.concatenate([(hat(e) @ poses[k][0]).T.ravel(), np.zeros(3)]) for e in np.eye(3)]
        return np.array(columns + [np.eye(12)[9 + i] for i in range(3)]).T

    linear = np.kron(np.eye(4), np.eye(3))
    linear[:9, :9] = np.kron(np.eye(3), turn)
    left = np.eye(6)
    left[:3, :3] = turn
    sq, st = 0.1 * d, 1.0
    all_entries = (linear, [100.0] * 12, [sq] * 9 + [st] * 3, lambda k: data(k, False), lambda k: np.eye(12))
    projected = (left, [50.0] * 3 + [100.0] * 3, [sq] * 3 + [st] * 3, lambda k: data(k, False) @ left_tangent(k), left_tangent)
    raw = (*projected[:3], lambda k: data(k, True) @ left_tangent(k), left_tangent)
    named = {"linear_posterior_crb": all_entries, "posterior_crb": projected, "posterior_crb_raw": raw}
    return {name: [traces(covariance_at(k, *parts)) for k in (0, 4, 19)] for name, parts in named.items()}


def covariance_at(last, f, prior, process, h, basis):
    """Last block of the inverse information about the states before step 0 and at steps 0..last, all at once."""
    size = len(prior)
    rows = [np.hstack([np.diag(1 / np.sqrt(prior)), np.zeros((size, size * (last + 1)))])]
    for k in range(last + 1):
        motion = np.zeros((size, size * (last + 2)))
        motion[:, size * k : size * (k + 1)] = -f / np.array(process)[:, None]
        motion[:, size * (k + 1) : size * (k + 2)] = np.diag(1 / np.array(process))
        seen = np.zeros((len(h(k)), size * (last + 2)))
        seen[:, size * (k + 1) : size * (k + 2)] = h(k)
        rows += [motion, seen]
    # The last block of the triangular factor is that of the marginal of the last state.
    triangle = np.linalg.qr(np.vstack(rows), mode="r")[-size:, -size:]
    half = basis(last) @ np.linalg.inv(triangle)
    return half @ half.T


if __name__ == "__main__":
    numbers = {
        "localization": localization(),
        "projection_cost": projection_cost(),
        "tracking_steps_0_4_19": tracking(),
    }
    print(json.dumps(numbers, indent=1))
