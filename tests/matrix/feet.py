"""Distances of points to a surface: the nearest of many samples, then steps of Gauss and Newton.

An upper bound of the true distance, which confirms a distance that a run reports.
"""

import numpy as np
from scipy.spatial import cKDTree

from box import places

SAMPLES = 400  # a direction, at least
STARTS = 4  # of the nearest samples
MINIMA = 8  # local ones, where those were not enough
MOST_SEARCHED = 500  # points
STEPS = 12


def refine(surface, points, uv):
    """Feet from the starts uv: the distances."""
    in_u, in_v = surface.derivative(0), surface.derivative(1)
    best = np.linalg.norm(surface(uv[:, 0], uv[:, 1]) - points, axis=1)
    damping = np.full(len(uv), 1e-6)
    for _ in range(STEPS):
        r = points - surface(uv[:, 0], uv[:, 1])
        a, b = in_u(uv[:, 0], uv[:, 1]), in_v(uv[:, 0], uv[:, 1])
        aa, ab, bb = (a * a).sum(1), (a * b).sum(1), (b * b).sum(1)
        floor = damping * (aa + bb) + 1e-300
        aa, bb = aa + floor, bb + floor
        ar, br = (a * r).sum(1), (b * r).sum(1)
        determinant = aa * bb - ab * ab
        step = np.stack([bb * ar - ab * br, aa * br - ab * ar], axis=1) / determinant[:, None]
        there = np.clip(uv + step, 0, 1)
        distance = np.linalg.norm(surface(there[:, 0], there[:, 1]) - points, axis=1)
        better = distance < best
        uv = np.where(better[:, None], there, uv)
        best = np.where(better, distance, best)
        damping = np.where(better, damping * 0.1, np.minimum(damping * 30, 1e3))
    return best


class Samples:
    """The surface on a grid that has every knot line."""

    def __init__(self, surface):
        self.grid = []
        for i in range(2):
            own = places(surface.knots[i], surface.degree[i])
            self.grid.append(np.union1d(own, np.linspace(0, 1, SAMPLES)) if len(own) < SAMPLES else own)
        self.points = surface.on_grid(*self.grid)

    def parameters(self, number):
        wide = len(self.grid[1])
        return np.stack([self.grid[0][number // wide], self.grid[1][number % wide]], axis=1)

    def nearest(self, points):
        """Numbers of the nearest samples, n x STARTS."""
        return cKDTree(self.points.reshape(-1, self.points.shape[2])).query(points, k=STARTS)[1]

    def minima(self, point):
        """Numbers of the samples that are nearer than their neighbours on the grid: the nearest MINIMA."""
        d = np.linalg.norm(self.points - point, axis=2)
        wide = np.pad(d, 1, constant_values=np.inf)
        least = np.ones(d.shape, bool)
        for i in range(3):
            for j in range(3):
                least &= d <= wide[i:i + d.shape[0], j:j + d.shape[1]]
        number = np.flatnonzero(least)
        return number[np.argsort(d.ravel()[number])[:MINIMA]]


def distances(surface, points, uv, wanted):
    """Of each point, n: from its own parameters uv; where that is more than `wanted` from the nearest samples, and then
    from the local minima of all samples."""
    best = refine(surface, points, uv)
    samples = Samples(surface)
    left = np.flatnonzero(best > wanted)
    if len(left):
        for start in samples.nearest(points[left]).T:
            best[left] = np.minimum(best[left], refine(surface, points[left], samples.parameters(start)))
    left = left[best[left] > wanted[left]]
    for k in left[np.argsort(wanted[left] - best[left])][:MOST_SEARCHED]:
        starts = samples.parameters(samples.minima(points[k]))
        best[k] = min(best[k], refine(surface, np.repeat(points[k:k + 1], len(starts), 0), starts).min())
    return best
