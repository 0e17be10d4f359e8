"""Distances of points to a surface: the nearest of many samples, then steps of Gauss and Newton.

An upper bound of the true distance, which confirms a distance that a run reports.
"""

import numpy as np
from scipy.spatial import cKDTree

from box import places

SAMPLES = 400  # a direction, at least
STARTS = 4
STEPS = 12


def refine(surface, points, uv):
    """Feet from the starts uv: (distance, uv)."""
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
    return best, uv


def distances(surface, points, uv):
    """Of each point, from its own parameters uv and from the nearest samples: n."""
    best, _ = refine(surface, points, uv)
    grid = []
    for i in range(2):
        own = places(surface.knots[i], surface.degree[i])
        grid.append(np.union1d(own, np.linspace(0, 1, SAMPLES)) if len(own) < SAMPLES else own)
    samples = surface.on_grid(*grid).reshape(-1, surface.dimension)
    _, near = cKDTree(samples).query(points, k=STARTS)
    for start in near.T:
        at = np.stack([grid[0][start // len(grid[1])], grid[1][start % len(grid[1])]], axis=1)
        best = np.minimum(best, refine(surface, points, at)[0])
    return best
