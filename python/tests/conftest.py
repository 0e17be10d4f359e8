"""Data of the tests. KNOTFIT is the tool, KNOTFIT_SOURCE the project's root; ctest sets both."""

import os
import warnings
from pathlib import Path

import numpy as np
import pytest

import knotfit

SOURCE = Path(os.environ.get("KNOTFIT_SOURCE", Path(__file__).parents[2]))


def wave(u, v):
    return np.sin(6 * u) * np.cos(5 * v)


@pytest.fixture(scope="session")
def samples():
    return SOURCE / "samples"


@pytest.fixture(scope="session")
def tool():
    if "KNOTFIT" not in os.environ:
        pytest.skip("KNOTFIT does not name the tool")
    return os.environ["KNOTFIT"]


@pytest.fixture(scope="session")
def uv():
    return np.random.default_rng(1).random((900, 2))


@pytest.fixture(scope="session")
def xyz(uv):
    return np.column_stack([uv, wave(uv[:, 0], uv[:, 1])])


@pytest.fixture(scope="session")
def fixed(xyz, uv):
    """A small fit of a fixed size, for what does not depend on a search."""
    return knotfit.fit(xyz, uv, control_points=(9, 8), knots="uniform", between=False)


@pytest.fixture(scope="session")
def disk():
    """A triangulated patch, bent."""
    n = 12
    a, b = np.meshgrid(np.linspace(0, 1, n), np.linspace(0, 1, n), indexing="ij")
    vertices = np.column_stack([a.ravel(), b.ravel(), 0.3 * wave(a, b).ravel()])
    k = (np.arange(n - 1)[:, None] * n + np.arange(n - 1)).ravel()
    faces = np.concatenate([np.column_stack([k, k + n, k + n + 1]), np.column_stack([k, k + n + 1, k + 1])])
    return vertices, faces


@pytest.fixture(autouse=True)
def no_stray_warnings():
    """A warning that a test does not expect fails it; those of other libraries are theirs."""
    with warnings.catch_warnings():
        warnings.simplefilter("error", knotfit.KnotfitWarning)
        yield
