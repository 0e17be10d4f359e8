"""Twenty rows on small data, with every kind of file and every option among them: those that scripts/test runs."""

import os

import inputs
import made
from rows import Row

# name -> options; a name without "made:" is a file of samples/.
ROWS = [
    ("face.uv.csv", dict(tolerance="5%", knots="error-model")),
    ("face.uv.csv", dict(measure="rms", size="20", knots="uniform")),
    ("jacksboro.asc", dict(tolerance="5%", measure="rms", knots="uniform")),
    ("jacksboro.asc", dict(tolerance="5%", measure="99.5%", stop="2 s")),
    ("blade_profile.csv", dict(tolerance="1%", knots="error-model")),
    ("made:small_scattered", dict()),
    ("made:small_scattered", dict(tolerance="1%", route="insert", knots="error-model")),
    ("made:small_scattered", dict(tolerance="0.1%", measure="99.5%", size="20")),
    ("made:small_grid", dict(tolerance="1%", measure="99.5%")),
    ("made:small_grid", dict(tolerance="5%", route="insert", knots="uniform")),
    ("made:small_grid", dict(size="40", knots="uniform")),
    ("made:small_npy", dict(tolerance="1%", measure="rms")),
    ("made:small_rows", dict(tolerance="1%")),
    ("made:small_obj", dict(tolerance="1%", measure="rms", knots="error-model")),
    ("made:small_off", dict(tolerance="5%", size="8")),
    ("made:small_ply", dict(tolerance="0.1%", measure="99.5%", knots="error-model")),
    ("made:small_stl", dict(tolerance="5%", knots="uniform")),
    ("made:small_las", dict(tolerance="5%", measure="99.5%", knots="error-model")),
    ("made:small_pcd", dict(tolerance="5%", knots="uniform")),
    ("made:circle", dict(tolerance="1%", measure="rms", knots="uniform")),
]


def rows(folder):
    """Rows over the samples and over small inputs made into `folder`."""
    samples, _ = inputs.in_folder(os.path.join(inputs.ROOT, "samples"), inputs.read_calls(inputs.CALLS))
    known = {i.name: i for i in samples + inputs.of_made(folder, made.SMALL)}
    return [Row(known[name], **options) for name, options in ROWS]
