"""Every example runs, and leaves what it says."""

import os
import re
import subprocess
import sys

import pytest

from conftest import SOURCE

EXAMPLES = sorted((SOURCE / "examples" / "python").glob("*.py"))
NEEDS = {"knots_for_scipy": "scipy", "sklearn_regressor": "sklearn", "tiles_with_dask": "dask",
         "xarray_raster": "xarray"}


@pytest.mark.parametrize("path", EXAMPLES, ids=lambda path: path.stem)
def test_example(path, tmp_path):
    if path.stem in NEEDS:
        pytest.importorskip(NEEDS[path.stem], reason=f"{NEEDS[path.stem]} is not installed")
    done = subprocess.run([sys.executable, "-B", str(path), str(tmp_path)], capture_output=True, text=True, check=False,
                          cwd=tmp_path, env=dict(os.environ), timeout=600)
    assert done.returncode == 0, done.stdout + done.stderr
    assert done.stdout
    said = re.search(r"leaves (.*) in FOLDER", path.read_text(encoding="utf-8"))
    names = re.findall(r"[\w-]+\.\w+", said[1]) if said else []
    assert sorted(names) == sorted(p.name for p in tmp_path.iterdir())


def test_examples_are_those_of_the_gallery():
    page = (SOURCE / "docs" / "python.md").read_text(encoding="utf-8")
    assert {p.name for p in EXAMPLES} == set(re.findall(r"\.\./examples/python/(\w+\.py)", page))
