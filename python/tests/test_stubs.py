"""The stubs tell what the module has, and the package's own types hold."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

import knotfit

pytest.importorskip("mypy", reason="mypy is not installed")
PACKAGE = Path(knotfit.__file__).parent


def run(tmp_path, *command):
    done = subprocess.run([sys.executable, "-m", *command, ], capture_output=True, text=True, check=False,
                          cwd=PACKAGE.parent, env={**os.environ, "MYPYPATH": str(PACKAGE.parent),
                                                   "MYPY_CACHE_DIR": str(tmp_path)})
    assert done.returncode == 0, done.stdout + done.stderr


def test_stubs_are_those_of_the_module(tmp_path):
    config = tmp_path / "mypy.ini"
    config.write_text(f"[mypy]\ncache_dir = {tmp_path}\nignore_missing_imports = True\n")
    run(tmp_path, "mypy.stubtest", "knotfit._core", "--mypy-config-file", str(config), "--ignore-unused-allowlist",
        "--allowlist", str(Path(__file__).with_name("stubtest.allow")))


def test_the_types_hold(tmp_path):
    run(tmp_path, "mypy", "--strict", "--no-warn-unused-ignores", "--cache-dir", str(tmp_path), "--ignore-missing-imports",
        "--exclude", "sklearn", "-p", "knotfit")


def test_the_package_says_that_it_is_typed():
    assert (PACKAGE / "py.typed").is_file() and (PACKAGE / "_core.pyi").is_file()
