"""Surfaces: values, geometry, knots, other libraries' forms, files."""

from __future__ import annotations

import os
import tempfile
from typing import Any, Literal, NamedTuple, Union

import numpy as np

from . import _arrays, _core, _options
from ._arrays import Floats
from ._errors import translated
from ._run import thread_count

Outside = Literal["raise", "clamp", "nan"]
Tolerance = Union[float, str, None]

class Curvature(NamedTuple):
    """Curvatures, each of the shape of the places. Signs follow the normal; k1 >= k2."""

    mean: Floats
    gaussian: Floats
    k1: Floats
    k2: Floats


class ClosestPoints(NamedTuple):
    """parameters (n, 2) in the surface's own coordinates, points (n, 3) on the surface, distances (n,)."""

    parameters: Floats
    points: Floats
    distances: Floats


class Distances(NamedTuple):
    """Between a surface and a mesh, both ways.

    signed      (n,) of the vertices to the surface, + on the side of its normal
    to_surface  dict: rms, max, mean, median, p95, p99, ... of them
    to_mesh     dict, likewise, of samples of the surface to the mesh; None: it has no faces
    """

    signed: Floats
    to_surface: dict[str, Any]
    to_mesh: dict[str, Any] | None


def draw_size(width: float | None, height: float | None, default: tuple[int, int] = (1600, 900)) -> tuple[int, int]:
    """Whole sizes; one that is missing keeps the usual shape, where that is not too narrow to be drawn."""
    if width is None and height is None:
        return default
    if height is None:
        assert width is not None
        height = max(200, width * default[1] / default[0])
    if width is None:
        width = max(200, height * default[0] / default[1])
    return round(width), round(height)


def show_picture(png: bytes, ax: Any) -> Any:
    """A PNG on matplotlib's axes."""
    import io

    import matplotlib.pyplot as plt

    if ax is None:
        _, ax = plt.subplots(figsize=(9, 5.1))
    ax.imshow(plt.imread(io.BytesIO(png), format="png"))
    ax.set_axis_off()
    return ax


def _knots(value: Any, name: str) -> Floats:
    return _arrays.floats(value, name, None)


class SurfaceDerivative:
    """A derivative of a surface, called like the surface."""

    def __init__(self, surface: Surface, du: int, dv: int) -> None:
        self.surface = surface
        self.order = (du, dv)

    def __call__(self, u: Any, v: Any, *, outside: Outside = "raise") -> Floats:
        return self.surface(u, v, du=self.order[0], dv=self.order[1], outside=outside)

    def __repr__(self) -> str:
        return f"<knotfit.SurfaceDerivative {self.order} of {self.surface!r}>"


class Surface:
    """A tensor-product B-spline surface S(u, v) in R^d over a rectangle.

    Places are in the coordinates of the data that was fitted: x, y of a height field, else u, v. A surface of dimension
    1 gives numbers, any other points: S(u, v) has the broadcast shape of u and v, and (d,) behind it.
    """

    __slots__ = ("_document", "__weakref__")
    _document: _core.Document

    def __init__(self, knots_u: Any, knots_v: Any, control_points: Any, degree: int | tuple[int, int] = 3, *,
                 domain: tuple[tuple[float, float], tuple[float, float]] | None = None,
                 height_field: bool = False) -> None:
        """knots_u, knots_v  whole knot vectors, end knots repeated; control_points  (n, m) or (n, m, d)

        domain        ((a, b), (c, d)) in which places are given; default: the knots' own range
        height_field  the surface is z over x and y: control_points have one component
        ValueError    sizes that do not fit, knots that decrease
        """
        p, q = (int(k) for k in np.broadcast_to(np.asarray(degree), 2))
        u, v = _knots(knots_u, "knots_u"), _knots(knots_v, "knots_v")
        net = _arrays.real(_arrays.plain(control_points, "control_points"), "control_points")
        for name, array in (("knots_u", u), ("knots_v", v), ("control_points", net)):
            if not np.isfinite(array).all():
                raise ValueError(f"{name}: an entry is not finite")
        if net.ndim == 2:
            net = net[:, :, None]
        if net.ndim != 3:
            raise ValueError(f"control_points: has shape {net.shape}, not (n, m) or (n, m, d)")
        if height_field and net.shape[2] != 1:
            raise ValueError("height_field: the control points of a height field have one component")
        with translated(rows=False):
            u, first_u = _on_unit(u, p, "knots_u")
            v, first_v = _on_unit(v, q, "knots_v")
            (a, b), (c, d) = domain if domain is not None else (first_u, first_v)
            if not (a < b and c < d):
                raise ValueError(f"domain: {domain} has an empty side")
            names = ("x", "y") if height_field else ("u", "v")
            self._document = _core.Document(p, u, q, v, _arrays.contiguous(net, dtype=np.float64),
                                            (*names, float(a), float(b), float(c), float(d), 0.0, 0.0), height_field,
                                            "", "")

    @classmethod
    def _of(cls, document: _core.Document) -> Surface:
        surface = object.__new__(cls)
        surface._document = document
        return surface

    @property
    def knots_u(self) -> Floats:
        """(n + degree + 1,) over [0, 1]; `domain` says what 0 and 1 are."""
        return self._document.knots_u

    @property
    def knots_v(self) -> Floats:
        """(m + degree + 1,) over [0, 1]."""
        return self._document.knots_v

    @property
    def _interior(self) -> tuple[Floats, Floats]:
        return self._document.interior_u, self._document.interior_v

    @property
    def control_points(self) -> Floats:
        """(n, m, d), or (n, m) where d is 1. A copy."""
        net = self._document.net
        return net[:, :, 0] if net.shape[2] == 1 else net

    @property
    def degree(self) -> tuple[int, int]:
        return self._document.degree

    @property
    def size(self) -> tuple[int, int]:
        """Control points along u and v."""
        n, m, _ = self._document.net.shape
        return n, m

    @property
    def dimension(self) -> int:
        return int(self._document.net.shape[2])

    @property
    def height_field(self) -> bool:
        """It is z over x and y."""
        return self._document.height_field

    @property
    def domain(self) -> tuple[tuple[float, float], tuple[float, float]]:
        """((a, b), (c, d)): the rectangle of the data's own coordinates."""
        _, _, a, b, c, d, _, _ = self._document.map
        return (a, b), (c, d)

    @property
    def shear(self) -> tuple[float, float]:
        """Of oblique parameters (fit's `shear`); (0, 0): none."""
        return self._document.map[6], self._document.map[7]

    def _places(self, u: Any, v: Any) -> tuple[Floats, Floats, tuple[int, ...]]:
        a, b = (_arrays.real(_arrays.plain(x, name), name) for x, name in ((u, "u"), (v, "v")))
        a, b = _arrays.unmasked(a, np.nan), _arrays.unmasked(b, np.nan)
        try:
            a, b = np.broadcast_arrays(a, b)
        except ValueError:
            raise ValueError(f"u, v: shapes {np.shape(u)} and {np.shape(v)} do not broadcast") from None
        return (_arrays.contiguous(a, dtype=np.float64).reshape(-1),
                _arrays.contiguous(b, dtype=np.float64).reshape(-1), a.shape)

    def __call__(self, u: Any, v: Any, *, du: int = 0, dv: int = 0, outside: Outside = "raise") -> Floats:
        """S(u, v), or its derivative of order du along u and dv along v, by the data's own coordinates.

        u, v     arrays that broadcast to a shape; a NaN gives NaN
        outside  "raise", "clamp" (to the border) or "nan": of places outside the domain
        returns  the shape, and (d,) behind it where d > 1
        """
        _check_outside(outside)
        _check_order(du, dv)
        a, b, shape = self._places(u, v)
        with translated(rows=False):
            values = self._document.values(a, b, du, dv, outside)
        return values.reshape(shape if values.shape[1] == 1 else (*shape, values.shape[1]))

    def grid(self, u: Any, v: Any, *, outside: Outside = "raise") -> Floats:
        """S on the grid of u (n,) and v (m,): (n, m), or (n, m, d) where d > 1. Faster than broadcasting."""
        _check_outside(outside)
        a, b = _arrays.floats(u, "u", None), _arrays.floats(v, "v", None)
        with translated(rows=False):
            values = self._document.grid(a, b, outside)
        return values[:, :, 0] if values.shape[2] == 1 else values

    def derivative(self, du: int, dv: int) -> SurfaceDerivative:
        """The derivative of order du along u and dv along v as a function of places."""
        _check_order(du, dv)
        return SurfaceDerivative(self, du, dv)

    def normals(self, u: Any, v: Any, *, outside: Outside = "raise") -> Floats:
        """Unit normals S_u x S_v / |.|, the shape of the places and (3,); of a height field in space. 0: none."""
        _check_outside(outside)
        a, b, shape = self._places(u, v)
        with translated(rows=False):
            return self._document.geometry(a, b, True, outside).reshape(*shape, 3)

    def curvature(self, u: Any, v: Any, *, outside: Outside = "raise") -> Curvature:
        """Mean, Gaussian and principal curvatures, each of the shape of the places; of a height field in space."""
        _check_outside(outside)
        a, b, shape = self._places(u, v)
        with translated(rows=False):
            found = self._document.geometry(a, b, False, outside)
        return Curvature(*(np.ascontiguousarray(found[:, k]).reshape(shape) for k in range(4)))

    def insert_knots(self, u: Any = (), v: Any = ()) -> Surface:
        """The same surface with more knots; u, v: knots inside (0, 1), repeats allowed."""
        with translated(rows=False):
            return Surface._of(self._document.with_knots(_knots(u, "u"), _knots(v, "v")))

    def in_space(self) -> Surface:
        """A height field as a surface in R^3, x and y exact; a surface in R^3 as it is."""
        with translated(rows=False):
            return Surface._of(self._document.in_space())

    def closest_points(self, points: Any, *, threads: int = 0) -> ClosestPoints:
        """The closest points of the whole surface, in space. points: (n, 3), or (3,)."""
        array = np.atleast_2d(_arrays.real(_arrays.plain(points, "points"), "points"))
        places = _arrays.floats(array, "points", None, 3)
        with translated(rows=False):
            uv, on, distances, raised = _core.closest_points(self._document, places, thread_count(threads))
        if raised is not None:
            raise raised
        _, _, a, b, c, d, _, _ = self._document.map
        if self.shear == (0.0, 0.0):
            uv = np.array([a, c]) + uv * np.array([b - a, d - c])
        return ClosestPoints(uv, on, distances)

    def distance_to(self, mesh: Any, faces: Any = None, *, samples: int = 700, threads: int = 0) -> Distances:
        """Distances to a mesh and back: of its vertices to the surface, of samples of the surface to its triangles.

        mesh     as fit_mesh() takes it: an object, or vertices (n, 3) with faces; vertices alone are points
        samples  of the surface, along u and along v
        """
        from . import _sources

        if faces is None and not hasattr(mesh, "faces") and not hasattr(mesh, "cells"):
            vertices, corners = _arrays.floats(mesh, "mesh", None, 3), np.zeros((0, 3), np.int32)
        else:
            vertices, corners = _sources.mesh_arrays(mesh, faces)
        with translated(rows=False):
            signed, to_surface, to_mesh, raised = _core.distance(self._document, vertices, corners, int(samples),
                                                                 thread_count(threads))
        if raised is not None:
            raise raised
        return Distances(signed, to_surface, to_mesh)

    def to_scipy(self) -> Any:
        """SciPy's form, in the data's own coordinates.

        returns  ScipySurface: `tck` (tx, ty, c, kx, ky) for scipy.interpolate.bisplev, a list of them where d > 1, and
                 `nd` ((tx, ty), c (n, m[, d]), (kx, ky)) for NdBSpline (SciPy 1.12)

        Far from zero, as in metres of a map projection, the knots lose digits there that they have in [0, 1].
        """
        from ._exchange import to_scipy

        return to_scipy(self)

    def to_geomdl(self) -> Any:
        """geomdl.BSpline.Surface. A height field goes in space. ImportError: no geomdl."""
        from ._exchange import to_geomdl

        return to_geomdl(self)

    @staticmethod
    def from_geomdl(surface: Any) -> Surface:
        """Of a geomdl B-spline surface, by its attributes. ValueError: it is rational with weights that differ."""
        from ._exchange import from_geomdl

        return from_geomdl(surface)

    def to_splinepy(self) -> Any:
        """splinepy.BSpline. A height field goes in space. ImportError: no splinepy."""
        from ._exchange import to_splinepy

        return to_splinepy(self)

    def to_step(self, **options: Any) -> str:
        """The text of a STEP file, for OCP and CadQuery. options: as save() has them for CAD files."""
        with tempfile.TemporaryDirectory(prefix="knotfit") as folder:
            path = os.path.join(folder, "surface.step")
            said: dict[str, Any] = {"name": "knotfit surface", **options}
            self.save(path, **said)
            with open(path, encoding="utf-8") as file:
                return file.read()

    def to_json(self) -> str:
        """The text of its .json file: numbers round-trip exactly."""
        return self._document.json()

    @staticmethod
    def from_json(text: str) -> Surface:
        """Of such a text."""
        with translated(rows=False):
            return Surface._of(_core.surface_from_json(text))

    def save(self, path: str | os.PathLike[str], *, force: bool = False, cell: Any = None, grid: Any = (100, 100),
             samples: int = 4, reflections: bool = False, unit: str = "mm", name: str | None = None,
             step_schema: str = "ap242", cad_safe: bool = False, cad_tol: Tolerance = None,
             fill_holes: bool = False) -> None:
        """Writes a file, its kind by the extension: .json, .csv (values on a grid), .asc .grd, .png .svg .pdf, .obj .ply
        .vts, .step .stp .igs .iges. Options as Fit.save() has them; grid: (along u, along v) places of a .csv."""
        del fill_holes  # a surface has no holes
        given = _options.changed(_SAVE_USUAL, {
            "cell": cell, "grid": grid, "samples": samples, "reflections": reflections, "unit": unit, "name": name,
            "step_schema": step_schema, "cad_safe": cad_safe, "cad_tol": cad_tol})
        if given.get("grid") == (100, 100):
            del given["grid"]
        with translated(rows=False):
            _core.save_surface(self._document, os.fspath(path), force, _options.texts("convert", given))

    def draw(self, format: str = "png", *, width: float | None = None, height: float | None = None,
             reflections: bool = False) -> bytes:
        """The picture: surface with knot lines, parameter plane beside it."""
        with translated(rows=False):
            return _core.draw_surface(self._document, "." + format.lstrip("."), *draw_size(width, height), reflections)

    def plot(self, ax: Any = None, *, width: int = 1600, height: int = 900) -> Any:
        """The picture on matplotlib's axes, made where none are given. Returns them. ImportError: no matplotlib."""
        return show_picture(self.draw("png", width=width, height=height), ax)

    def _repr_png_(self) -> bytes | None:
        return self.draw("png", width=1200, height=675) if self.height_field or self.dimension == 3 else None

    def _repr_html_(self) -> str:
        from ._notebook import surface_html

        return surface_html(self)

    def __repr__(self) -> str:
        (n, m), (p, q) = self.size, self.degree
        where = "height field" if self.height_field else f"in R^{self.dimension}"
        return f"<knotfit.Surface {n} x {m} control points, degree {p} x {q}, {where}>"

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Surface):
            return NotImplemented
        return self._document.same(other._document)

    def __hash__(self) -> int:
        return hash((self.degree, self.knots_u.tobytes(), self.knots_v.tobytes(), self._document.net.tobytes()))

    def __copy__(self) -> Surface:
        return self  # it never changes

    def __deepcopy__(self, memo: dict[int, Any]) -> Surface:
        return self

    def __reduce__(self) -> tuple[Any, ...]:
        d = self._document
        return _restored, (*zip(d.degree, (d.knots_u, d.knots_v)), d.net, d.map, d.height_field, d.options, d.result)


_SAVE_USUAL = {"cell": None, "grid": (100, 100), "samples": 4, "reflections": False, "unit": "mm", "name": None,
               "step_schema": "ap242", "cad_safe": False, "cad_tol": None}


def _restored(u: tuple[int, Floats], v: tuple[int, Floats], net: Floats, map_: Any, height_field: bool, options: str,
              result: str) -> Surface:
    return Surface._of(_core.Document(*u, *v, net, map_, height_field, options, result))


def _on_unit(knots: Floats, degree: int, name: str) -> tuple[Floats, tuple[float, float]]:
    """The knots over [0, 1], and their own range."""
    if len(knots) < 2 * degree + 2:
        raise ValueError(f"{name}: {len(knots)} knots are too few for degree {degree}; give whole knot vectors")
    first, last = float(knots[degree]), float(knots[-degree - 1])
    if not first < last:
        raise ValueError(f"{name}: the domain [{first}, {last}] is empty")
    if (first, last) == (0.0, 1.0):
        return knots, (0.0, 1.0)
    moved = (knots - first) / (last - first)
    moved[knots == last] = 1.0
    return moved, (first, last)


def _check_outside(outside: str) -> None:
    if outside not in ("raise", "clamp", "nan"):
        raise ValueError(f"outside: {outside!r} is none of 'raise', 'clamp', 'nan'")


def _check_order(du: Any, dv: Any) -> None:
    for name, order in (("du", du), ("dv", dv)):
        if isinstance(order, bool) or not hasattr(order, "__index__"):
            raise TypeError(f"{name}: takes a whole number, not {type(order).__name__}")
        if not 0 <= order.__index__() <= 20:
            raise ValueError(f"{name}: {order} is no order from 0 to 20")
