"""A scanned mesh to a CAD file.

python scan_to_step.py [FOLDER]   leaves scan.step and scan.png in FOLDER
"""

import sys
from pathlib import Path

import knotfit

folder = Path(sys.argv[1] if len(sys.argv) > 1 else ".")
samples = Path(__file__).resolve().parents[2] / "samples"

# Any object with .vertices and .faces (trimesh), .points and .cells (meshio) or .points and .faces (PyVista) will do.
scan = knotfit.load(samples / "face.obj")
fit = knotfit.fit_mesh(scan.vertices, scan.faces, control_points=(16, 16), knots="error-model", correct=10)
print(fit)

back = fit.surface.distance_to(scan.vertices, scan.faces, samples=200)
print(f"scan to surface: rms {back.to_surface['rms']:.4g}; surface to scan: rms {back.to_mesh['rms']:.4g}")

fit.save(folder / "scan.step", unit="mm", name="face", force=True)
(folder / "scan.png").write_bytes(fit.draw("png", width=1000, reflections=True))
