"""The box of a surface or curve against its data's: what it does where there is no data."""

import numpy as np

from splines import breaks

PER_SPAN = 6
MOST = 2500  # places a direction


def places(knots, degree):
    """Every break, and places inside each span."""
    ends = breaks(knots, degree)
    each = max(1, min(PER_SPAN, MOST // max(len(ends) - 1, 1)))
    steps = np.arange(each) / each
    inside = (ends[:-1, None] + np.diff(ends)[:, None] * steps).ravel()
    return np.append(inside, ends[-1])


def diagonal(values):
    """Of the data's box; of heights alone it is their range."""
    return float(np.linalg.norm(values.max(axis=0) - values.min(axis=0)))


def excess(found, values):
    """How far the places `found` leave the box of `values`, the largest over components and sides."""
    below = values.min(axis=0) - found.min(axis=0)
    above = found.max(axis=0) - values.max(axis=0)
    return float(max(below.max(), above.max(), 0.0))


def of_surface(surface, values):
    found = surface.on_grid(*(places(surface.knots[i], surface.degree[i]) for i in range(2)))
    return excess(found.reshape(-1, surface.dimension), values)


def of_curve(curve, values):
    return excess(curve(places(curve.knots, curve.degree)), values)
