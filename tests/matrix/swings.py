"""Swings: how far a surface leaves its data between points that stand side by side (docs/matrix.md).

One measure, for the library's verdict, the tests and the matrix:

    swing(x) = (how far S(x) lies outside the box of the 16 nearest points and of the corners of its triangle,
               the largest over the components) / L,   L = max(floor, largest error of the 8 nearest points)

floor is the tolerance, or the RMS error where none was asked. Nearest is meant in the parameter square, among
points with distinct parameters; of points with equal parameters all count as one place. Places x are random ones
inside small triangles: those of the Delaunay triangulation of the parameters whose edges are at most 3 times the
least spacing at their corners, the distance to the 4th nearest place. (The corners count so that a plane has no
swings: at the border of dense data they may not be among the 16.)

A curve has one parameter: places lie in gaps at most 3 times the distance to the 2nd nearest, the box is that of
the 4 nearest points and the ends of the gap, L looks at the 2 nearest, and up to 5 % of the range of these points is
free: a curve through a single peak goes on a little.
"""

from dataclasses import dataclass

import numpy as np
from scipy.spatial import Delaunay, QhullError, cKDTree

NEAR_BOX, NEAR_ERROR, SPACING, SMALL = 16, 8, 4, 3.0
NEAR_BOX_CURVE, NEAR_ERROR_CURVE, SPACING_CURVE, FREE_CURVE = 4, 2, 2, 0.05
PLACES, LEAST_PER_TRIANGLE, MOST_PER_TRIANGLE = 200_000, 4, 50
SEED = 20
ROUNDING = 2.0 ** -40  # of the data's largest number: what counts as no error at all


@dataclass
class Swings:
    places: int = 0
    largest: float = 0.0
    share_above_3: float = 0.0
    excess: float = 0.0  # the largest, in the data's unit
    where: tuple = ()  # parameters of the largest


def distinct(parameters, values, errors):
    """One place for equal parameters: (parameters, least value, largest value, largest error)."""
    unique, group = np.unique(parameters, axis=0, return_inverse=True)
    group = group.ravel()
    low = np.full((len(unique), values.shape[1]), np.inf)
    high, worst = -low, np.zeros(len(unique))
    np.minimum.at(low, group, values)
    np.maximum.at(high, group, values)
    np.maximum.at(worst, group, errors)
    return unique, low, high, worst


def nearest(tree, places, count):
    """Distances and numbers of the nearest `count` points, n x count; fewer where there are not so many."""
    count = min(count, tree.n)
    distance, index = tree.query(places, k=count)
    return distance.reshape(len(places), count), index.reshape(len(places), count)


def small_triangles(uv, tree):
    """Corners (numbers of points) of the small triangles, n x 3."""
    if len(uv) < 4:
        return np.empty((0, 3), int)
    try:
        corners = Delaunay(uv).simplices
    except QhullError:  # all on one line
        return np.empty((0, 3), int)
    spacing = nearest(tree, uv, SPACING + 1)[0][:, -1]
    edges = np.stack([np.linalg.norm(uv[corners[:, i]] - uv[corners[:, (i + 1) % 3]], axis=1) for i in range(3)])
    return corners[edges.max(axis=0) <= SMALL * spacing[corners].min(axis=1)]


def thinned(things, rng):
    """(at most so many things that each gets its least number of places, places for each)."""
    most = PLACES // LEAST_PER_TRIANGLE
    if len(things) > most:
        things = things[np.sort(rng.choice(len(things), most, replace=False))]
    return things, int(np.clip(PLACES // max(len(things), 1), LEAST_PER_TRIANGLE, MOST_PER_TRIANGLE))


def random_places(uv, corners, rng):
    """(n x 2 places; the triangle's corners of each, n x 3)."""
    corners, each = thinned(corners, rng)
    a, b = rng.random((2, len(corners), each))
    folded = a + b > 1
    a, b = np.where(folded, 1 - a, a), np.where(folded, 1 - b, b)
    p, q, r = (uv[corners[:, i]][:, None, :] for i in range(3))
    places = (p + a[..., None] * (q - p) + b[..., None] * (r - p)).reshape(-1, 2)
    return places, np.repeat(corners, each, axis=0)


def summarize(tree, places, corners, at_places, data, floor, near_box, near_error, free=0.0):
    """The measure at `places` between `corners`, where the surface is `at_places`; `data` as of distinct(); `free` of
    the range of the box does not count."""
    if len(places) == 0:
        return Swings()
    _, low, high, worst = data
    scale = max(np.abs(low).max(), np.abs(high).max())
    swing, largest_excess = np.empty(len(places)), 0.0
    for begin in range(0, len(places), 20_000):
        part = slice(begin, begin + 20_000)
        near = nearest(tree, places[part], near_box)[1]
        boxed = np.concatenate([near, corners[part]], axis=1)
        floor_of, top = low[boxed].min(axis=1), high[boxed].max(axis=1)
        beyond = np.maximum(floor_of - at_places[part], at_places[part] - top)
        excess = np.where(beyond > free * (top - floor_of), beyond, 0).max(axis=1)
        excess = np.maximum(excess, 0)
        largest_excess = max(largest_excess, float(excess.max()))
        length = np.maximum(worst[near[:, :near_error]].max(axis=1), floor)
        swing[part] = excess / np.maximum(length, ROUNDING * scale + 1e-300)
    at = int(np.argmax(swing))
    return Swings(len(places), float(swing[at]), float(np.mean(swing > 3)), largest_excess,
                  tuple(map(float, places[at])))


def of_surface(surface, uv, values, errors, floor):
    """uv n x 2 in [0,1], values n x dimension, errors n (at the parameters), floor > 0 or 0."""
    data = distinct(uv, values, errors)
    tree = cKDTree(data[0])
    rng = np.random.default_rng(SEED)
    places, corners = random_places(data[0], small_triangles(data[0], tree), rng)
    return summarize(tree, places, corners, surface(places[:, 0], places[:, 1]), data, floor, NEAR_BOX, NEAR_ERROR)


def of_curve(curve, t, values, errors, floor):
    """t n in [0,1], values n x dimension, errors n, floor > 0 or 0."""
    data = distinct(np.asarray(t, float)[:, None], values, errors)
    tree = cKDTree(data[0])
    at = data[0][:, 0]
    spacing = nearest(tree, data[0], SPACING_CURVE + 1)[0][:, -1]
    gaps = np.flatnonzero(np.diff(at) <= SMALL * np.minimum(spacing[1:], spacing[:-1]))
    rng = np.random.default_rng(SEED)
    gaps, each = thinned(gaps, rng)
    places = (at[gaps, None] + rng.random((len(gaps), each)) * (at[gaps + 1] - at[gaps])[:, None]).reshape(-1, 1)
    values_there = curve(places[:, 0]) if len(places) else np.empty((0, values.shape[1]))
    ends = np.repeat(np.stack([gaps, gaps + 1], axis=1), each, axis=0)
    return summarize(tree, places, ends, values_there, data, floor, NEAR_BOX_CURVE, NEAR_ERROR_CURVE,
                     FREE_CURVE)
