"""Surfaces in the forms of other libraries, none of which is imported before it is asked for."""

from __future__ import annotations

from typing import Any, NamedTuple, Union

import numpy as np

from ._arrays import Floats
from .surface import Surface

Tck = tuple[Floats, Floats, Floats, int, int]


class ScipySurface(NamedTuple):
    """tck: (tx, ty, c, kx, ky) of bisplev, a list of d where the surface has d > 1 components; nd: (t, c, k)."""

    tck: Union[Tck, list[Tck]]
    nd: tuple[tuple[Floats, Floats], Floats, tuple[int, int]]


def _own_knots(surface: Surface) -> tuple[Floats, Floats]:
    """Knot vectors in the data's own coordinates."""
    if surface.shear != (0.0, 0.0):
        raise ValueError("shear: the surface has oblique parameters, which no tensor-product spline of x and y has")
    both = []
    for knots, (first, last) in zip((surface.knots_u, surface.knots_v), surface.domain):
        moved = first + knots * (last - first)
        moved[knots == 1.0] = last
        both.append(moved)
    return both[0], both[1]


def to_scipy(surface: Surface) -> ScipySurface:
    tx, ty = _own_knots(surface)
    kx, ky = surface.degree
    net = surface.control_points
    parts: list[Floats] = [net] if net.ndim == 2 else [net[:, :, d] for d in range(net.shape[2])]
    tcks: list[Tck] = [(tx, ty, np.ascontiguousarray(c).ravel(), kx, ky) for c in parts]
    return ScipySurface(tcks[0] if net.ndim == 2 else tcks, ((tx, ty), net, (kx, ky)))


def _in_space(surface: Surface) -> Surface:
    return surface.in_space() if surface.dimension == 1 else surface


def to_geomdl(surface: Surface) -> Any:
    from geomdl import BSpline

    space = _in_space(surface)
    made = BSpline.Surface()
    made.degree_u, made.degree_v = space.degree
    made.set_ctrlpts(space.control_points.reshape(-1, space.dimension).tolist(), *space.size)
    made.knotvector_u, made.knotvector_v = space.knots_u.tolist(), space.knots_v.tolist()
    return made


def from_geomdl(surface: Any) -> Surface:
    weights = getattr(surface, "weights", None)
    if getattr(surface, "rational", False) and weights is not None and len(set(weights)) > 1:
        raise ValueError("surface: is rational with weights that differ; knotfit has B-splines without weights")
    n, m = int(surface.ctrlpts_size_u), int(surface.ctrlpts_size_v)
    net = np.asarray(surface.ctrlpts, dtype=np.float64).reshape(n, m, -1)  # v runs fastest
    return Surface(surface.knotvector_u, surface.knotvector_v, net, (int(surface.degree_u), int(surface.degree_v)))


def to_splinepy(surface: Surface) -> Any:
    import splinepy

    space = _in_space(surface)
    # splinepy counts the first direction fastest.
    points = np.swapaxes(space.control_points, 0, 1).reshape(-1, space.dimension)
    return splinepy.BSpline(degrees=list(space.degree), knot_vectors=[space.knots_u.tolist(), space.knots_v.tolist()],
                            control_points=points)
