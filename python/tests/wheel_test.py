"""A wheel as pyproject.toml makes it, in a virtual environment of its own: wheel_test.py SOURCE BUILD.

Nothing is downloaded: pip builds with what is installed, and NumPy is the system's.
"""

import os
import subprocess
import sys
import tempfile
from pathlib import Path

USE = """
import sys, numpy as np, knotfit, pathlib
assert pathlib.Path(knotfit.__file__).is_relative_to(sys.prefix), knotfit.__file__
rng = np.random.default_rng(0)
uv = rng.random((500, 2))
fit = knotfit.fit(np.sin(5 * uv[:, 0]) * uv[:, 1], uv, tol="1%")
assert fit.reached and knotfit.load("samples/face.obj").faces.shape[1] == 3
print(knotfit.__version__, fit)
"""


def main(source, build):
    for module in ("pip", "venv", "wheel"):
        if subprocess.run([sys.executable, "-c", f"import {module}"], check=False, capture_output=True).returncode:
            print(f"skipped: {sys.executable} has no {module}")
            return 77
    environment = {k: v for k, v in os.environ.items() if k != "PYTHONPATH"}
    environment |= {"KNOTFIT_BUILD_DIR": str(build), "PIP_NO_INDEX": "1", "PIP_DISABLE_PIP_VERSION_CHECK": "1"}
    with tempfile.TemporaryDirectory() as folder:
        def run(*command):
            print("$", *command, flush=True)
            subprocess.run(list(map(str, command)), check=True, env=environment, cwd=source)

        run(sys.executable, "-m", "pip", "wheel", "--no-build-isolation", "--no-deps", "-w", folder, ".")
        wheel = next(Path(folder).glob("knotfit-*.whl"))
        print(f"{wheel.name}: {wheel.stat().st_size / 1e6:.1f} MB")
        run(sys.executable, "-m", "venv", "--system-site-packages", f"{folder}/venv")
        run(f"{folder}/venv/bin/python", "-m", "pip", "install", "--no-deps", wheel)
        run(f"{folder}/venv/bin/python", "-B", "-c", USE)
        if subprocess.run([sys.executable, "-c", "import pytest, scipy"], check=False, capture_output=True).returncode == 0:
            environment["KNOTFIT_SOURCE"] = str(source)
            run(f"{folder}/venv/bin/python", "-B", "-m", "pytest", "-q", "-p", "no:cacheprovider",
                "python/tests/test_surface.py", "python/tests/test_arrays.py")
    return 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
