"""The points of an input as this program reads them itself, to hold a run's CSV against.

Text with a header and ESRI ASCII grids; other formats are taken from the run's own CSV.
"""

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
