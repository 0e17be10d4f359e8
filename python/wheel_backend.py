"""The build backend of pyproject.toml (PEP 517): CMake builds, this packs. It needs the standard library and NumPy.

KNOTFIT_BUILD_DIR      a build folder that has the package for this interpreter; default: one of its own, which goes
KNOTFIT_CMAKE_OPTIONS  more options for CMake, such as -DKNOTFIT_WITH_CAD=OFF
"""

import base64
import hashlib
import os
import re
import shlex
import subprocess
import sys
import sysconfig
import tempfile
import zipfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
EPOCH = (1980, 1, 1, 0, 0, 0)  # the same files give the same wheel


def version():
    return re.search(r"project\(knotfit VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text(encoding="utf-8"))[1]


def metadata():
    text = (ROOT / "pyproject.toml").read_text(encoding="utf-8")

    def said(name):
        return re.search(rf'^{name} = "(.*)"$', text, re.M)[1]

    lines = ["Metadata-Version: 2.1", "Name: knotfit", f"Version: {version()}", f"Summary: {said('description')}",
             "License: Apache-2.0", f"Requires-Python: {said('requires-python')}",
             "Description-Content-Type: text/markdown"]
    lines += [f"Requires-Dist: {need}" for need in re.findall(r'"(.*?)"', re.search(r"^dependencies = \[(.*)\]$", text,
                                                                                     re.M)[1])]
    for extra, needs in re.findall(r"^(\w+) = \[(.*)\]$", text.split("[project.optional-dependencies]")[1]
                                   .split("\n[")[0], re.M):
        lines += [f"Provides-Extra: {extra}"]
        lines += [f'Requires-Dist: {need}; extra == "{extra}"' for need in re.findall(r'"(.*?)"', needs)]
    return "\n".join(lines) + "\n\n" + (ROOT / "README.md").read_text(encoding="utf-8")


def tag():
    python = f"cp{sys.version_info.major}{sys.version_info.minor}"
    platform = re.sub(r"[-.]", "_", sysconfig.get_platform())
    return f"{python}-{python}-{platform}"


def built(folder):
    """The package's folder, made by CMake."""
    build, place = Path(os.environ.get("KNOTFIT_BUILD_DIR") or folder / "build"), folder / "installed"
    if not os.environ.get("KNOTFIT_BUILD_DIR"):
        run("cmake", "-G", "Ninja", "-S", ROOT, "-B", build, "-DCMAKE_BUILD_TYPE=Release", "-DKNOTFIT_BUILD_PYTHON=ON",
            "-DKNOTFIT_BUILD_TESTS=OFF", "-DKNOTFIT_BUILD_TOOL=OFF", f"-DPython_EXECUTABLE={sys.executable}",
            *shlex.split(os.environ.get("KNOTFIT_CMAKE_OPTIONS", "")))
    run("cmake", "--build", build, "--target", "knotfit_core")
    run("cmake", "--install", build, "--component", "python", "--strip", "--prefix", place)
    return next(place.rglob("knotfit/_core.*")).parent


def run(*command):
    subprocess.run(command, check=True, stdout=sys.stderr)


def get_requires_for_build_wheel(config_settings=None):
    return []


def prepare_metadata_for_build_wheel(metadata_directory, config_settings=None):
    info = Path(metadata_directory) / f"knotfit-{version()}.dist-info"
    info.mkdir()
    (info / "METADATA").write_text(metadata(), encoding="utf-8")
    (info / "WHEEL").write_text(wheel_text(), encoding="utf-8")
    return info.name


def wheel_text():
    return f"Wheel-Version: 1.0\nGenerator: knotfit {version()}\nRoot-Is-Purelib: false\nTag: {tag()}\n"


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    info = f"knotfit-{version()}.dist-info"
    name = f"knotfit-{version()}-{tag()}.whl"
    with tempfile.TemporaryDirectory() as folder:
        package = built(Path(folder))
        files = {f"knotfit/{p.relative_to(package).as_posix()}": p.read_bytes()
                 for p in sorted(package.rglob("*")) if p.is_file() and "__pycache__" not in p.parts}
    files[f"{info}/METADATA"] = metadata().encode()
    files[f"{info}/WHEEL"] = wheel_text().encode()
    files[f"{info}/LICENSE"] = (ROOT / "LICENSE").read_bytes()
    record = "".join(f"{path},sha256={base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b'=').decode()},"
                     f"{len(data)}\n" for path, data in files.items())
    files[f"{info}/RECORD"] = (record + f"{info}/RECORD,,\n").encode()
    with zipfile.ZipFile(Path(wheel_directory) / name, "w", zipfile.ZIP_DEFLATED) as wheel:
        for path, data in files.items():
            entry = zipfile.ZipInfo(path, EPOCH)
            entry.external_attr = (0o755 if path.endswith(".so") else 0o644) << 16
            entry.compress_type = zipfile.ZIP_DEFLATED
            wheel.writestr(entry, data)
    return name


def build_sdist(sdist_directory, config_settings=None):
    raise RuntimeError("knotfit has no source archive of its own: install from a clone")
