"""Knot placement methods beside each other for a paper: a table, and the figure as vector PDF at column width.

python compare_methods.py [FOLDER]   leaves compare.pdf, compare-maps.pdf and compare.png in FOLDER
"""

import sys
from pathlib import Path

import numpy as np

import knotfit

folder = Path(sys.argv[1] if len(sys.argv) > 1 else ".")

rng = np.random.default_rng(0)
uv = rng.random((1500, 2))
z = np.tanh(12 * (uv[:, 0] - 0.6)) * np.cos(3 * uv[:, 1])

table = knotfit.compare(z, uv, methods=["uniform", "quantile", "error-model", "optimal"], sizes=[7, 9, 12],
                        between=False)
for row in table:
    print(f"{row['method']:12} {row['asked']:>6} {row['control_points']:5} {row['rms']:.2e} {row['max']:.2e}")

column = 252  # points: 3.5 inches
(folder / "compare.pdf").write_bytes(table.draw("pdf", width=column, height=200))
(folder / "compare-maps.pdf").write_bytes(table.draw("pdf", asked="9x9", width=2 * column, height=300))
(folder / "compare.png").write_bytes(table.draw("png", width=1000))

try:
    import pandas
except ImportError:
    print("pandas is not installed")
else:
    print(pandas.DataFrame(table).pivot(index="method", columns="asked", values="rms"))
