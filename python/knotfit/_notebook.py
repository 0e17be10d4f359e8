"""What a notebook shows."""

from __future__ import annotations

import base64
from html import escape
from typing import Any


def _picture(png: bytes | None) -> str:
    if png is None:
        return ""
    return f'<img alt="" style="max-width:100%" src="data:image/png;base64,{base64.b64encode(png).decode()}"/>'


def _table(rows: list[tuple[str, str]]) -> str:
    cells = "".join(f'<tr><th style="text-align:left">{escape(a)}</th><td style="text-align:left">{escape(b)}</td></tr>'
                    for a, b in rows)
    return f"<table>{cells}</table>"


def _surface_rows(surface: Any) -> list[tuple[str, str]]:
    (n, m), (p, q) = surface.size, surface.degree
    (a, b), (c, d) = surface.domain
    where = "height field" if surface.height_field else f"in R^{surface.dimension}"
    return [("surface", f"{n} x {m} = {n * m} control points, degree {p} x {q}, {where}"),
            ("domain", f"[{a:.6g}, {b:.6g}] x [{c:.6g}, {d:.6g}]")]


def surface_html(surface: Any) -> str:
    return _picture(surface._repr_png_()) + _table(_surface_rows(surface))


def fit_html(fit: Any) -> str:
    rows = [("status", f"{fit.status}: {fit.message}"), *_surface_rows(fit.surface),
            ("error", f"max {fit.error.max:.4g}, rms {fit.error.rms:.4g}, median {fit.error.median:.4g}")]
    if fit.tolerance is not None:
        rows.append(("tolerance", f"{fit.tolerance:.4g}"))
    if fit.between is not None:
        rows.append(("between the points", f"{fit.between:.4g}, bound {fit.bound:.4g}, "
                                           f"{100 * (fit.thin or 0):.3g} % of the domain too thin to say"))
    rows += [("note", note) for note in fit.notes]
    return _picture(fit._repr_png_()) + _table(rows)


def comparison_html(comparison: Any) -> str:
    names = ["method", "asked", "control_points", "rms", "max", "between", "status", "seconds"]

    def cell(value: Any) -> str:
        return "" if value is None else f"{value:.4g}" if isinstance(value, float) else escape(str(value))

    head = "".join(f"<th>{name}</th>" for name in names)
    body = "".join("<tr>" + "".join(f"<td>{cell(row.get(name))}</td>" for name in names) + "</tr>" for row in comparison)
    return f"<table><tr>{head}</tr>{body}</table>"
