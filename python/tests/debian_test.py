"""The Debian packages that CPack makes: their fields and, unpacked, their use: debian_test.py SOURCE BUILD.

scripts/debian installs them in a bare root besides, which needs root and a mirror.
"""

import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path


def output(*command, **options):
    print("$", *command, flush=True)
    return subprocess.run(list(map(str, command)), check=True, capture_output=True, text=True, **options).stdout


def main(source, build):
    if not shutil.which("dpkg-shlibdeps") or not shutil.which("cpack") or sys.executable != "/usr/bin/python3":
        print("skipped: needs cpack, dpkg-shlibdeps and Debian's interpreter")
        return 77
    with tempfile.TemporaryDirectory() as folder:
        output("cpack", "-G", "DEB", "--config", Path(build) / "CPackConfig.cmake", "-B", folder)
        packages = {p.name.split("_")[0]: p for p in Path(folder).glob("*.deb")}
        assert set(packages) == {"knotfit", "libknotfit-dev", "python3-knotfit"}, packages
        root = Path(folder) / "root"
        for name, package in packages.items():
            fields = output("dpkg-deb", "-f", package, "Depends", "Description")
            print(fields, f"{package.stat().st_size / 1e6:.1f} MB")
            wanted = {"knotfit": "libtbb12", "libknotfit-dev": "knotfit (= ", "python3-knotfit": "python3-numpy"}[name]
            assert wanted in fields, fields
            output("dpkg", "-x", package, root)
        assert (root / "usr/include/knotfit/fit_surface.h").is_file()
        assert (root / "usr/lib/libknotfit.a").is_file() and (root / "usr/share/man/man1/knotfit.1").is_file()
        shown = output(root / "usr/bin/knotfit", "fit", Path(source) / "samples/face.uv.csv", "--control-points", "8x8",
                       "--knots", "uniform", "--json")
        assert '"fixed_size"' in shown
        environment = {**os.environ, "PYTHONPATH": str(root / "usr/lib/python3/dist-packages")}
        used = output("/usr/bin/python3", "-B", "-c",
                      "import sys, knotfit; assert knotfit.__file__.startswith(sys.argv[1]), knotfit.__file__;"
                      "print(knotfit.fit(sys.argv[2], control_points=8, knots='uniform').status)",
                      root, Path(source) / "samples/face.uv.csv", env=environment, cwd=folder)
        assert used == "fixed_size\n", used
    return 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
