"""B-spline surfaces and curves from knotfit's JSON, evaluated by the recurrence of Cox and de Boor.

Written apart from the library, which it is a witness against: only the file format is shared.
"""

import json

import numpy as np


def basis(knots, degree, t):
    """The degree + 1 functions that are not 0 at each t: (index of the first, n; values, n x degree + 1).

    t lies in the domain of the knots; at its end the last span counts.
    """
    last = len(knots) - degree - 2
    span = np.clip(np.searchsorted(knots, t, side="right") - 1, degree, last)
    values = np.zeros((len(t), degree + 1))
    values[:, 0] = 1
    for p in range(1, degree + 1):
        saved = np.zeros(len(t))
        for r in range(p):
            right = knots[span + r + 1]
            left = knots[span + 1 - p + r]
            share = values[:, r] / (right - left)  # the span lies in it: never 0
            values[:, r] = saved + (right - t) * share
            saved = (t - left) * share
        values[:, p] = saved
    return span - degree, values


def basis_matrix(knots, degree, t):
    """All functions at each t: n x number of functions."""
    first, values = basis(knots, degree, t)
    matrix = np.zeros((len(t), len(knots) - degree - 1))
    for a in range(degree + 1):
        matrix[np.arange(len(t)), first + a] = values[:, a]
    return matrix


def breaks(knots, degree):
    """The ends of the spans that have a length."""
    return np.unique(knots[degree:len(knots) - degree])


class Surface:
    """Degrees (m, n), full knot vectors, a net of size_u x size_v x dimension."""

    def __init__(self, degree, knots_u, knots_v, net):
        self.degree = tuple(degree)
        self.knots = (np.asarray(knots_u, float), np.asarray(knots_v, float))
        self.net = np.asarray(net, float)

    @property
    def dimension(self):
        return self.net.shape[2]

    def __call__(self, u, v):
        """S at n places: n x dimension."""
        first_u, in_u = basis(self.knots[0], self.degree[0], np.asarray(u, float))
        first_v, in_v = basis(self.knots[1], self.degree[1], np.asarray(v, float))
        out = np.zeros((len(u), self.dimension))
        for a in range(self.degree[0] + 1):
            for b in range(self.degree[1] + 1):
                out += (in_u[:, a] * in_v[:, b])[:, None] * self.net[first_u + a, first_v + b]
        return out

    def on_grid(self, u, v):
        """S at every pair of u and v: len(u) x len(v) x dimension."""
        in_u = basis_matrix(self.knots[0], self.degree[0], np.asarray(u, float))
        in_v = basis_matrix(self.knots[1], self.degree[1], np.asarray(v, float))
        return np.stack([in_u @ self.net[:, :, c] @ in_v.T for c in range(self.dimension)], axis=2)

    def derivative(self, axis):
        """dS/du (axis 0) or dS/dv (axis 1), a surface of one degree less."""
        degree, knots = self.degree[axis], self.knots[axis]
        net = np.moveaxis(self.net, axis, 0)
        length = knots[degree + 1:-1] - knots[1:-degree - 1]
        factor = np.divide(degree, length, out=np.zeros_like(length), where=length > 0)
        net = np.moveaxis((net[1:] - net[:-1]) * factor[:, None, None], 0, axis)
        degrees, both = list(self.degree), list(self.knots)
        degrees[axis], both[axis] = degree - 1, knots[1:-1]
        return Surface(degrees, both[0], both[1], net)


class Curve:
    """A degree, a full knot vector over [0,1], control points n x dimension."""

    def __init__(self, degree, knots, net):
        self.degree = degree
        self.knots = np.asarray(knots, float)
        self.net = np.asarray(net, float)

    def __call__(self, t):
        first, values = basis(self.knots, self.degree, np.asarray(t, float))
        return sum(values[:, a, None] * self.net[first + a] for a in range(self.degree + 1))


class Map:
    """The user's parameters over the surface's own: given = low + own (high - low), each direction."""

    def __init__(self, document):
        d = document or {}
        if d.get("shear_u") or d.get("shear_v"):
            raise ValueError("sheared parameters: not a part of the matrix")
        self.low = np.array([d.get("u0", 0.0), d.get("v0", 0.0)], float)
        self.high = np.array([d.get("u1", 1.0), d.get("v1", 1.0)], float)

    def own(self, uv):
        """n x 2 of the user's to n x 2 in [0,1]; what rounding puts outside is brought back."""
        own = (np.asarray(uv, float) - self.low) / (self.high - self.low)
        if len(own) and not (own.min() > -1e-6 and own.max() < 1 + 1e-6):
            raise ValueError("a parameter lies outside the surface's domain")
        return np.clip(own, 0, 1)


def read_document(path):
    with open(path, encoding="utf-8") as file:
        return json.load(file)


def read_surface(path):
    """(Surface, Map, the whole document)."""
    d = read_document(path)
    return Surface(d["degree"], d["knots_u"], d["knots_v"], d["control_points"]), Map(d.get("parameter_map")), d


def read_curve(path):
    """(Curve, the whole document)."""
    d = read_document(path)
    return Curve(d["degree"], d["knots"], d["control_points"]), d
