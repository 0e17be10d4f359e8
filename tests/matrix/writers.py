"""Small files of each kind that the program reads, from NumPy arrays."""

import struct

import numpy as np


def text(header, table):
    lines = [header] if header else []
    lines += [",".join(repr(float(x)) for x in row) for row in table]
    return ("\n".join(lines) + "\n").encode()


def rows(parts):
    """Rows of points, a blank line between them."""
    return "\n\n".join("\n".join(" ".join(repr(float(x)) for x in p) for p in part) for part in parts).encode() + b"\n"


def grid(heights, left, lower, dx, dy, nodata=-9999.0):
    """ESRI ASCII; the first row is the north; NaN is a hole."""
    rows_, cols = heights.shape
    head = [f"ncols {cols}", f"nrows {rows_}", f"xllcorner {left!r}", f"yllcorner {lower!r}", f"dx {dx!r}",
            f"dy {dy!r}", f"NODATA_value {nodata:g}"]
    lines = [" ".join(f"{z:.9g}" for z in row) for row in np.where(np.isnan(heights), nodata, heights)]
    return ("\n".join(head + lines) + "\n").encode()


def npy(array):
    header = repr({"descr": array.dtype.str, "fortran_order": False, "shape": array.shape}).encode()
    header += b" " * (-(len(header) + 11) % 64) + b"\n"
    return b"\x93NUMPY\x01\x00" + struct.pack("<H", len(header)) + header + np.ascontiguousarray(array).tobytes()


def sheet_triangles(columns, rows_):
    """Triangles of a columns x rows grid of vertices, numbered row by row."""
    a = (np.arange(rows_ - 1)[:, None] * columns + np.arange(columns - 1)).ravel()
    return np.concatenate([np.stack([a, a + 1, a + columns + 1], 1), np.stack([a, a + columns + 1, a + columns], 1)])


def off(vertices, triangles):
    lines = ["OFF", f"{len(vertices)} {len(triangles)} 0"]
    lines += [" ".join(repr(float(x)) for x in p) for p in vertices]
    lines += ["3 " + " ".join(map(str, t)) for t in triangles]
    return ("\n".join(lines) + "\n").encode()


def obj(vertices, triangles):
    lines = ["v " + " ".join(repr(float(x)) for x in p) for p in vertices]
    lines += ["f " + " ".join(map(str, t + 1)) for t in triangles]
    return ("\n".join(lines) + "\n").encode()


def stl(vertices, triangles):
    """Binary."""
    out = [b"knotfit matrix".ljust(80, b"\0"), struct.pack("<I", len(triangles))]
    for corner in vertices.astype("<f4")[triangles]:
        out.append(struct.pack("<3f", 0, 0, 0) + corner.tobytes() + b"\0\0")
    return b"".join(out)


def ply(vertices, triangles):
    """Binary; a mesh, or points where there are no triangles."""
    head = ["ply", "format binary_little_endian 1.0", f"element vertex {len(vertices)}"]
    head += [f"property double {c}" for c in "xyz"]
    faces = b""
    if len(triangles):
        head += [f"element face {len(triangles)}", "property list uchar int vertex_indices"]
        faces = b"".join(b"\x03" + t.astype("<i4").tobytes() for t in triangles)
    return ("\n".join(head + ["end_header"]) + "\n").encode() + vertices.astype("<f8").tobytes() + faces


def las(points, classes, scale=0.001):
    """LAS 1.2, point format 0."""
    origin = np.floor(points.min(axis=0))
    header = bytearray(227)
    header[0:4], header[24], header[25] = b"LASF", 1, 2
    struct.pack_into("<HI", header, 94, 227, 227)
    struct.pack_into("<BHI", header, 104, 0, 20, len(points))
    struct.pack_into("<6d", header, 131, scale, scale, scale, *origin)
    stored = np.rint((points - origin) / scale).astype(int)
    records = [struct.pack("<3iHBBbBH", *map(int, p), 0, 1 | 1 << 3, int(c), 0, 0, 0) for p, c in zip(stored, classes)]
    return bytes(header) + b"".join(records)


def pcd(points):
    n = len(points)
    head = ["VERSION .7", "FIELDS x y z", "SIZE 8 8 8", "TYPE F F F", "COUNT 1 1 1", f"WIDTH {n}", "HEIGHT 1",
            "VIEWPOINT 0 0 0 1 0 0 0", f"POINTS {n}", "DATA ascii"]
    return ("\n".join(head + [" ".join(repr(float(x)) for x in p) for p in points]) + "\n").encode()
