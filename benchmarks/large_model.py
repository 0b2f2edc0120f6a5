#!/usr/bin/env python3
"""Writes a large model for measurements of memory and time.

    large_model.py TRIANGLES FILE.stl|.obj|.ply

The model is a hull of 10 m with bumps in every direction, closed, with two wings that are sheets: inter-reflection,
spaces inside and open edges all have work to do. An .stl is binary, a .ply in little endian, an .obj has shared vertices
and no normals.
"""
import math
import struct
import sys


def hull(rows, columns, length=10.0, radius=1.0, centre=(0.0, 0.0, 0.0)):
    """Vertices in rows of columns, and triangles by their numbers."""
    vertices = []
    for i in range(rows + 1):
        polar = math.pi * i / rows
        for j in range(columns):
            turn = 2.0 * math.pi * j / columns
            bump = 1.0 + 0.05 * math.sin(12.0 * turn) * math.sin(9.0 * polar)
            across = radius * bump * math.sin(polar)
            vertices.append((centre[0] + across * math.cos(turn), centre[1] + 0.5 * length * math.cos(polar),
                             centre[2] + across * math.sin(turn)))
    triangles = []
    for i in range(rows):
        for j in range(columns):
            a, b = i * columns + j, i * columns + (j + 1) % columns
            c, d = a + columns, b + columns
            if i > 0:
                triangles.append((a, b, d))
            if i < rows - 1:
                triangles.append((a, d, c))
    return vertices, triangles


def sheet(side, first, origin, along, across):
    """A square of side times side quads, its vertices numbered from the first."""
    vertices = [tuple(origin[k] + along[k] * i / side + across[k] * j / side for k in range(3))
                for i in range(side + 1) for j in range(side + 1)]
    triangles = []
    for i in range(side):
        for j in range(side):
            a = first + i * (side + 1) + j
            triangles.append((a, a + 1, a + side + 2))
            triangles.append((a, a + side + 2, a + side + 1))
    return vertices, triangles


def model(count):
    side = max(1, int(math.sqrt(0.1 * count / 2.0)))
    rows = max(4, int(math.sqrt(0.8 * count / 4.0)))
    vertices, triangles = hull(rows, 2 * rows)
    for sign in (-1.0, 1.0):
        more, faces = sheet(side, len(vertices), (sign * 0.8, -1.0, 0.0), (sign * 4.0, 0.0, 0.2), (0.0, 1.5, 0.0))
        vertices += more
        triangles += faces
    return vertices, triangles


def write(name, vertices, triangles):
    with open(name, "wb") as out:
        if name.endswith(".stl"):
            out.write(b"large model".ljust(80) + struct.pack("<I", len(triangles)))
            facet = struct.Struct("<12fH")
            for a, b, c in triangles:
                out.write(facet.pack(0, 0, 0, *vertices[a], *vertices[b], *vertices[c], 0))
        elif name.endswith(".ply"):
            out.write(("ply\nformat binary_little_endian 1.0\nelement vertex %d\nproperty float x\nproperty float y\n"
                       "property float z\nelement face %d\nproperty list uchar int vertex_indices\nend_header\n"
                       % (len(vertices), len(triangles))).encode())
            for place in vertices:
                out.write(struct.pack("<3f", *place))
            for face in triangles:
                out.write(struct.pack("<B3i", 3, *face))
        else:
            for x, y, z in vertices:
                out.write(b"v %.6f %.6f %.6f\n" % (x, z, -y))
            for a, b, c in triangles:
                out.write(b"f %d %d %d\n" % (a + 1, b + 1, c + 1))


if __name__ == "__main__":
    if len(sys.argv) != 3 or not sys.argv[2].endswith((".stl", ".obj", ".ply")):
        sys.exit(__doc__)
    write(sys.argv[2], *model(int(sys.argv[1])))
