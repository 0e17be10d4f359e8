"""What a run wrote, read and measured anew: the surface's JSON and the residuals' CSV.

Errors come from here twice: from the surface in the JSON at the points' parameters, and from the CSV's column.
"""

import json
import os
from dataclasses import dataclass, field

import numpy as np

import box
import feet
import swings
from splines import read_curve, read_surface

AGREE = 1e-7  # of the diagonal: between two ways to the same error
FEET_AGREE = 1e-5  # of the diagonal: between two searches of the nearest place


@dataclass
class Measured:
    status: str
    control_points: int
    points: int
    dimension: int
    diagonal: float
    errors: np.ndarray  # of the points as the CSV has them
    recomputed: np.ndarray  # by this program from the JSON, at the same points
    disagree: str  # what the two contradict each other in; empty: nothing
    swings: swings.Swings
    box: float  # how far the surface leaves the data's box, in the data's unit
    report_differs: str = ""  # the report's errors, of the points it kept of equal ones, from those of all
    notes: list = field(default_factory=list)


def read_table(path):
    """Column name -> numbers."""
    with open(path, encoding="utf-8") as file:
        names = file.readline().strip().split(",")
        table = np.loadtxt(file, delimiter=",", ndmin=2)
    return {name: table[:, i] for i, name in enumerate(names)}


def columns(table, names):
    return np.stack([table[name] for name in names], axis=1)


def differ(what, a, b, allowed):
    gap = float(np.max(np.abs(a - b))) if len(a) else 0.0
    return f"{what} differ by {gap:.3g}" if not gap <= allowed else ""


def rms(errors):
    return float(np.sqrt(np.mean(errors ** 2))) if len(errors) else 0.0


def values_of(table, dimension):
    if dimension == 1:
        return columns(table, "z")
    return columns(table, [n for n in table if n in "xyz" or (n[0] == "a" and n[1:].isdigit())])


def of_surface(folder, report, tolerance):
    """Measures a `fit`; `tolerance` 0 where none was asked."""
    surface, user_map, document = read_surface(os.path.join(folder, "out.json"))
    table = read_table(os.path.join(folder, "out.csv"))
    values = values_of(table, surface.dimension)
    errors, given = table["error"], columns(table, "uv")
    corrected = "error_at_parameters" in table
    own = corrected or document.get("height_field", False)
    uv = np.clip(given, 0, 1) if own else user_map.own(given)
    at_parameters = np.linalg.norm(surface(uv[:, 0], uv[:, 1]) - values, axis=1)
    diagonal = box.diagonal(values)
    # Coordinates far from 0 lose digits: the surface's own rounding and the CSV's.
    allowed = AGREE * diagonal + 2.0 ** -44 * float(np.abs(values).max())
    recomputed = at_parameters
    if corrected:
        disagree = differ("errors at the parameters (JSON and CSV)", at_parameters, table["error_at_parameters"],
                          allowed)
        wanted = errors + FEET_AGREE * diagonal + allowed
        feet_of = columns(table, ["foot_u", "foot_v"])
        found = np.minimum(at_parameters, np.linalg.norm(surface(feet_of[:, 0], feet_of[:, 1]) - values, axis=1))
        far = found > wanted
        if far.any():
            found[far] = feet.distances(surface, values[far], feet_of[far], wanted[far])
        recomputed = np.where(found <= wanted, errors, found)
        disagree = disagree or differ("distances (JSON and CSV)", recomputed, errors, 10 * FEET_AGREE * diagonal)
    else:
        disagree = differ("errors (JSON and CSV)", at_parameters, errors, allowed)
    denied = report_denied(report, errors, allowed)
    # The report's errors are those of the points fitted; its verdict and the table are of all.
    merged = report["input"].get("duplicates", 0) > 0 or len(values) > report["input"].get("points", len(values))
    disagree = disagree or ("" if merged else denied)
    floor = tolerance if tolerance > 0 else rms(errors)
    return Measured(status=report["status"], control_points=surface.net.shape[0] * surface.net.shape[1],
                    points=len(values), dimension=surface.dimension, diagonal=diagonal, errors=errors,
                    recomputed=recomputed, disagree=disagree,
                    swings=swings.of_surface(surface, uv, values, at_parameters, floor),
                    box=box.of_surface(surface, values), report_differs=denied if merged else "",
                    notes=notes_of(report))


def of_curve(folder, report, tolerance):
    """Measures a `fit-curve`."""
    curve, document = read_curve(os.path.join(folder, "out.json"))
    table = read_table(os.path.join(folder, "out.csv"))
    values = columns(table, "y" if document.get("function") else [n for n in table if n in "xyz"])
    errors, t = table["error"], table["t"]
    recomputed = np.linalg.norm(curve(t) - values, axis=1)
    diagonal = box.diagonal(values)
    allowed = AGREE * diagonal + 2.0 ** -44 * float(np.abs(values).max())
    disagree = differ("errors (JSON and CSV)", recomputed, errors, allowed) or report_denied(report, errors, allowed)
    floor = tolerance if tolerance > 0 else rms(errors)
    return Measured(status=report["status"], control_points=report["control_points"], points=len(values),
                    dimension=values.shape[1], diagonal=diagonal, errors=errors, recomputed=recomputed,
                    disagree=disagree, swings=swings.of_curve(curve, t, values, recomputed, floor),
                    box=box.of_curve(curve, values), notes=notes_of(report))


def report_denied(report, errors, allowed):
    """The report's own numbers against the CSV of all points."""
    for name, number in (("max", float(errors.max())), ("rms", rms(errors))):
        said = report["error"][name]
        if said is not None and abs(said - number) > allowed + 1e-6 * number:
            return f"{name} error is {number:.4g} in the CSV, {said:.4g} in the report"
    return ""


def notes_of(report):
    return [report.get("message") or "", *report.get("notes", [])]


def read_report(text):
    """The JSON object a run printed; None where it printed none."""
    try:
        return json.loads(text)
    except ValueError:
        return None
