"""The points of an input as this program reads them itself, to hold a run's CSV against.

Text with a header and ESRI ASCII grids; of rows of points, arrays and meshes the number of points only. The points of
other formats are taken from the run's own CSV.
"""

import itertools
import os

import numpy as np


def of_csv(path):
    """Columns by their header, in file order; None without a header that has z."""
    with open(path, encoding="utf-8") as file:
        names = [n.strip().lower() for n in file.readline().split(",")]
        if "z" not in names:
            return None
        table = np.loadtxt(file, delimiter=",", ndmin=2)
    return {n: table[:, i] for i, n in enumerate(names)}


def of_grid(path):
    """x, y, z of the cells that hold a height, row by row from the north."""
    head = {}
    with open(path, encoding="utf-8") as file:
        while True:
            begin = file.tell()
            words = file.readline().split()
            if not words or not words[0][0].isalpha() or words[0].lower() in ("nan", "null"):
                file.seek(begin)
                break
            head[words[0].lower()] = float(words[1])
        heights = np.loadtxt(file, ndmin=2)
    rows, cols = heights.shape
    dx, dy = head.get("dx", head.get("cellsize")), head.get("dy", head.get("cellsize"))
    left = head["xllcenter"] if "xllcenter" in head else head["xllcorner"] + dx / 2
    lower = head["yllcenter"] if "yllcenter" in head else head["yllcorner"] + dy / 2
    x, y = np.meshgrid(left + dx * np.arange(cols), lower + dy * np.arange(rows)[::-1])
    kept = np.isfinite(heights) & (heights != head.get("nodata_value", -9999))
    return {"x": x[kept], "y": y[kept], "z": heights[kept]}


def read(path):
    """Column name -> numbers, or None where this program does not read the format."""
    if path.endswith(".asc"):
        return of_grid(path)
    return of_csv(path) if path.endswith(".csv") else None


def lines_of_numbers(file):
    return sum(1 for line in file if line.split() and "nan" not in line.lower())


def header_count(file, word):
    """`element vertex N` of a PLY."""
    for line in itertools.islice(file, 100):
        if line.startswith(word):
            return int(line.split()[-1])
    return None


def count(path):
    """Points of the input, or None where this program does not count the format."""
    ending = os.path.splitext(path)[1].lower()
    if ending == ".npy":
        array = np.load(path, allow_pickle=False)
        return int(np.isfinite(array).all(axis=2).sum() if array.ndim == 3 else np.isfinite(array).sum())
    with open(path, encoding="latin-1") as file:
        if ending in (".txt", ".rows"):
            return lines_of_numbers(file)
        if ending == ".ply":
            return header_count(file, "element vertex")
        if ending == ".obj":
            return sum(1 for line in file if line.startswith("v "))
        if ending == ".off":
            words = (line.partition("#")[0].split() for line in file)
            return int(next(w[0] for w in words if w and w[0].isdigit()))
    return None


def denied(path, table):
    """What the run's residuals (column name -> numbers) contradict the input in; empty: nothing."""
    data = read(path)
    if data is None or not {"x", "y", "z"} <= set(data) or "x" not in table:
        return ""
    if len(data["z"]) != len(table["z"]):
        return f"the CSV has {len(table['z'])} points, the input {len(data['z'])}"
    for name in ("x", "y", "z"):
        gap = np.max(np.abs(data[name] - table[name]))
        if gap > 1e-9 * np.max(np.abs(data[name])):
            return f"{name} of the CSV is not the input's: they differ by {gap:.3g}"
    return ""
