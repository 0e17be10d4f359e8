"""Inputs of kinds that scans and maps bring and no sample has, made by a seed: `made:NAME`.

Each function gives the file's ending and bytes. MADE says how each file is called.
"""

import os

import numpy as np

import writers

SEED = 2026


def hills(u, v):
    """Smooth, some 3 features a direction, range about 1."""
    return (0.5 * np.sin(5 * u + 1) * np.cos(4 * v) + 0.35 * np.exp(-40 * ((u - 0.7) ** 2 + (v - 0.3) ** 2))
            + 0.2 * np.tanh(12 * (u + 0.4 * v - 0.7)))


def in_space(u, v):
    """A bent sheet, n x 3."""
    return np.stack([4 * u + 0.3 * np.sin(3 * v), 3 * v, hills(u, v)], axis=-1)


def with_parameters(u, v, values=None):
    values = in_space(u, v) if values is None else values
    return writers.text("x,y,z,u,v", np.column_stack([values, u, v]))


def spread(x):
    """To exactly [0,1]."""
    return (x - x.min()) / (x.max() - x.min())


def unequal_rows(rng):
    """16 rows at unequal heights, 150 points along each, ends and spacing different from row to row."""
    v = np.sort(np.concatenate([[0, 1], rng.random(14)]))
    u = np.concatenate([spread(np.sort(rng.random(150) ** (0.5 + 2 * t))) for t in v])
    return ".csv", with_parameters(u, np.repeat(v, 150))


def clusters(rng):
    """3 000 points in 40 clusters, 300 between them: density differs 1 000 to 1."""
    centre, width = rng.random((40, 2)), 10 ** rng.uniform(-3, -1.3, 40)
    which = rng.integers(0, 40, 3000)
    uv = np.concatenate([centre[which] + width[which, None] * rng.standard_normal((3000, 2)), rng.random((300, 2))])
    uv = np.unique(uv[((uv >= 0) & (uv <= 1)).all(axis=1)], axis=0)
    return ".csv", with_parameters(*uv.T)


def spiral(rng):
    """A turning probe: 40 turns, dense along the path, the corners of the square empty."""
    a = np.sqrt(np.linspace(0.001, 1, 6000)) * 40 * 2 * np.pi
    r = 0.5 * a / a.max()
    u, v = spread(0.5 + r * np.cos(a)), spread(0.5 + r * np.sin(a))
    return ".csv", with_parameters(u, v)


def repeated_strips(rng):
    """Flight strips that overlap, every third row measured twice, 2 mm of noise: heights over x, y."""
    out = []
    for strip in range(5):
        for row in range(30):
            x = np.linspace(0, 60, 61)
            y = np.full(61, strip * 24 + row)
            for _ in range(2 if row % 3 == 0 else 1):
                z = 10 * hills(x / 60, y / 130) + 0.002 * rng.standard_normal(61)
                out.append(np.column_stack([x, y, z]))
    return ".xyz", writers.text("x,y,z", np.concatenate(out))


def profiles(rng):
    """Nine straight lines of soundings that cross the map: dense along, nothing between."""
    out = []
    for _ in range(9):
        a, b = rng.random((2, 2))
        a[rng.integers(2)], b[rng.integers(2)] = rng.integers(2), rng.integers(2)
        t = np.sort(rng.random(220))[:, None]
        out.append(a + t * (b - a))
    xy = np.concatenate(out + [np.array([[0, 0], [0, 1], [1, 0], [1, 1]])])
    return ".csv", writers.text("x,y,z", np.column_stack([1000 * xy[:, 0], 800 * xy[:, 1], 30 * hills(*xy.T)]))


def far_ranges(rng):
    """Parameters of a machine: u in seconds to 40 000, v in metres to 0.02."""
    u, v = rng.random((2, 2500))
    u[:4], v[:4] = [0, 1, 0, 1], [0, 0, 1, 1]
    return ".csv", with_parameters(40000 * u, 0.02 * v, in_space(u, v))


def tiny(rng):
    """20 points: four more than a bicubic patch has control points."""
    u, v = rng.random((2, 20))
    u[:4], v[:4] = [0, 1, 0, 1], [0, 0, 1, 1]
    return ".csv", with_parameters(u, v)


def far_away(rng):
    """A relief of 3 m at coordinates of 1e7, to the millimetre."""
    xy = np.round(rng.random((4000, 2)) * [900, 700], 3)
    xy = np.unique(xy, axis=0)
    z = np.round(1.5 * hills(xy[:, 0] / 900, xy[:, 1] / 700), 3)
    return ".csv", writers.text("x,y,z", np.column_stack([xy + [1.2e7, 3.4e7], z + 1e7]))


def weighted(rng):
    """Weights from 1e-3 to 1e3; points of low weight are 5 % off."""
    u, v = rng.random((2, 3000))
    w = 10 ** rng.uniform(-3, 3, 3000)
    off = np.where(w < 0.01, 0.05, 0.0005)[:, None] * rng.standard_normal((3000, 3))
    return ".csv", writers.text("x,y,z,u,v,w", np.column_stack([in_space(u, v) + off, u, v, w]))


def repeated(rng):
    """Each place measured three times, with noise."""
    u, v = (np.repeat(x, 3) for x in rng.random((2, 900)))
    return ".csv", with_parameters(u, v, in_space(u, v) + 0.002 * rng.standard_normal((2700, 3)))


def holed(rng):
    """A raster with a disk, a ring, an L, a slit and a torn border without data."""
    y, x = np.mgrid[0:90, 0:120]
    z = 40 * hills(x / 119, 1 - y / 89) + 0.05 * rng.standard_normal(x.shape)
    r = np.hypot(x - 30, y - 25)
    ring = np.hypot(x - 85, y - 30)
    hole = (r < 9) | ((ring > 8) & (ring < 14)) | ((x > 20) & (x < 50) & (y > 55) & (y < 62))
    hole |= (x > 20) & (x < 27) & (y > 55) & (y < 80)
    hole |= (x > 70) & (x < 112) & (np.abs(y - 60 - 0.2 * (x - 70)) < 1.5)
    hole |= x > 112 + 5 * np.sin(y / 6)
    return ".asc", writers.grid(np.where(hole, np.nan, z), 500.0, 200.0, 5.0, 4.0)


def sharp_turn(rng):
    """Heights over u, v alone: a cliff between rows of points, the rest flat."""
    u, v = rng.random((2, 3500))
    return ".csv", writers.text("z,u,v", np.column_stack([np.tanh(80 * (v - 0.45 - 0.1 * np.sin(6 * u))), u, v]))


def graded_mesh(rng):
    """A mesh whose columns shrink 60 to 1 towards one side."""
    s = spread(np.cumsum(60 ** -np.linspace(0, 1, 45)))
    u, v = np.meshgrid(s, np.linspace(0, 1, 30))
    return ".obj", writers.obj(in_space(u.ravel(), v.ravel()), writers.sheet_triangles(45, 30))


def helix(rng):
    """A curve in space, its points in bursts."""
    t = np.unique(np.concatenate([np.linspace(0, 1, 40), (rng.random(300) ** 3)]))
    z = 3 * t + np.tanh(30 * (t - 0.6))
    return ".csv", writers.text("x,y,z", np.column_stack([np.cos(14 * t), np.sin(14 * t), z]))


def record(rng):
    """y over x: a burst in a quiet record, sampled unevenly."""
    x = np.sort(rng.random(700))
    return ".csv", writers.text("x,y", np.column_stack([100 * x, np.sin(90 * x) * np.exp(-200 * (x - 0.4) ** 2)]))


# Small ones, for the rows that run with the tests: one of each kind of file.

def small_sheet(columns=20, rows=16):
    u, v = np.meshgrid(np.linspace(0, 1, columns), np.linspace(0, 1, rows))
    return in_space(u.ravel(), v.ravel()), writers.sheet_triangles(columns, rows)


def small_obj(rng):
    return ".obj", writers.obj(*small_sheet())


def small_off(rng):
    return ".off", writers.off(*small_sheet())


def small_stl(rng):
    return ".stl", writers.stl(*small_sheet())


def small_ply(rng):
    return ".ply", writers.ply(*small_sheet())


def small_rows(rng):
    return ".rows", writers.rows([in_space(np.linspace(0, 1, 30), np.full(30, v)) for v in np.linspace(0, 1, 20)])


def small_npy(rng):
    u, v = np.meshgrid(np.linspace(0, 1, 40), np.linspace(1, 0, 30))
    return ".npy", writers.npy(hills(u, v))


def small_las(rng):
    """Ground (2) and what stands on it (1)."""
    xy = rng.random((1500, 2)) * [80, 60]
    ground = rng.random(1500) < 0.7
    z = 8 * hills(xy[:, 0] / 80, xy[:, 1] / 60) + np.where(ground, 0, 5 * rng.random(1500))
    return ".las", writers.las(np.column_stack([xy + [4e5, 5e6], z + 100]), np.where(ground, 2, 1))


def small_pcd(rng):
    u, v = rng.random((2, 900))
    return ".pcd", writers.pcd(in_space(u, v) * [1, 1, 0.5])


def small_scattered(rng):
    u, v = rng.random((2, 800))
    return ".csv", with_parameters(u, v)


def small_grid(rng):
    y, x = np.mgrid[0:40, 0:50]
    return ".asc", writers.grid(20 * hills(x / 49, 1 - y / 39), 0.0, 0.0, 2.0, 3.0)


def circle(rng):
    a = np.sort(rng.random(150)) * 2 * np.pi
    return ".csv", writers.text("x,y", np.column_stack([3 * np.cos(a), 2 * np.sin(a) + 0.3 * np.sin(3 * a)]))


# name -> (function, command, arguments beside the input)
MADE = {
    "unequal_rows": (unequal_rows, "fit", []),
    "clusters": (clusters, "fit", []),
    "spiral": (spiral, "fit", []),
    "repeated_strips": (repeated_strips, "fit", ["--height-field", "--duplicates", "mean"]),
    "profiles": (profiles, "fit", ["--height-field"]),
    "far_ranges": (far_ranges, "fit", ["--rescale-parameters"]),
    "tiny": (tiny, "fit", []),
    "far_away": (far_away, "fit", ["--height-field"]),
    "weighted": (weighted, "fit", []),
    "repeated": (repeated, "fit", ["--duplicates", "mean"]),
    "holed": (holed, "fit", []),
    "sharp_turn": (sharp_turn, "fit", []),
    "graded_mesh": (graded_mesh, "fit", []),
    "helix": (helix, "fit-curve", []),
    "record": (record, "fit-curve", ["--function"]),
}
SMALL = {
    "small_obj": (small_obj, "fit", []),
    "small_off": (small_off, "fit", []),
    "small_stl": (small_stl, "fit", []),
    "small_ply": (small_ply, "fit", []),
    "small_rows": (small_rows, "fit", []),
    "small_npy": (small_npy, "fit", []),
    "small_las": (small_las, "fit", ["--classes", "2", "--height-field"]),
    "small_pcd": (small_pcd, "fit", []),
    "small_scattered": (small_scattered, "fit", []),
    "small_grid": (small_grid, "fit", []),
    "circle": (circle, "fit-curve", ["--closed"]),
}


def write(folder, which):
    """Writes the inputs of a table like MADE: name -> path. A name's bytes depend on nothing but the name."""
    paths = {}
    for name, (make, _, _) in which.items():
        ending, content = make(np.random.default_rng([SEED, *name.encode()]))
        paths[name] = os.path.join(folder, name + ending)
        with open(paths[name], "wb") as file:
            file.write(content)
    return paths
