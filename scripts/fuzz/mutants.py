#!/usr/bin/env python3
"""Mutants of small models of every format through smat-batch.

    scripts/fuzz/mutants.py BUILD [--count 500] [--seed 1] [--keep FOLDER]

Each mutant is a small model with some bytes changed, taken out, doubled or cut off. Tells, for each
format, how many were read, how many refused (exit code 2), and how many crashed, hung for 10 s of
processor time, were called a fault of the program, or were cut and read without a word of what is
missing. Exit code 1 where there is any of the latter.
"""

import argparse
import concurrent.futures
import json
import pathlib
import random
import re
import signal
import struct
import subprocess
import sys
import tempfile

SQUARES = 6  # two triangles each, in a row along x


def corners():
    for i in range(SQUARES):
        yield (i, 0, 0), (i + 1, 0, 0), (i + 1, 1, 0), (i, 1, 0)


def triangles():
    for a, b, c, d in corners():
        yield a, b, c
        yield a, c, d


def obj():
    text = "".join("v %d %d %d\n" % p for square in corners() for p in square)
    return (text + "".join("f %d %d %d %d\n" % tuple(4 * i + k for k in (1, 2, 3, 4))
                           for i in range(SQUARES))).encode()


def stl_text():
    text = "solid row\n"
    for facet in triangles():
        text += "facet normal 0 0 1\nouter loop\n"
        text += "".join("vertex %g %g %g\n" % p for p in facet) + "endloop\nendfacet\n"
    return (text + "endsolid row\n").encode()


def stl_binary():
    facets = list(triangles())
    return (b"row".ljust(80) + struct.pack("<I", len(facets)) +
            b"".join(struct.pack("<12fH", 0, 0, 1, *a, *b, *c, 0) for a, b, c in facets))


def ply():
    points = [p for square in corners() for p in square]
    head = ("ply\nformat ascii 1.0\nelement vertex %d\nproperty float x\nproperty float y\n"
            "property float z\nelement face %d\nproperty list uchar int vertex_indices\n"
            "end_header\n" % (len(points), SQUARES))
    return (head + "".join("%d %d %d\n" % p for p in points) +
            "".join("4 %d %d %d %d\n" % tuple(4 * i + k for k in range(4))
                    for i in range(SQUARES))).encode()


def studio():
    def chunk(kind, payload):
        return struct.pack("<HI", kind, 6 + len(payload)) + payload
    points = [p for square in corners() for p in square]
    faces = [(4 * i + a, 4 * i + b, 4 * i + c) for i in range(SQUARES)
             for a, b, c in ((0, 1, 2), (0, 2, 3))]
    mesh = chunk(0x4110, struct.pack("<H", len(points)) +
                 b"".join(struct.pack("<3f", *p) for p in points))
    mesh += chunk(0x4120, struct.pack("<H", len(faces)) +
                  b"".join(struct.pack("<4H", *f, 7) for f in faces))
    return chunk(0x4D4D, chunk(0x0002, struct.pack("<I", 3)) +
                 chunk(0x3D3D, chunk(0x4000, b"row\0" + chunk(0x4100, mesh))))


def ac():
    points = [p for square in corners() for p in square]
    text = ('AC3Db\nMATERIAL "m" rgb 1 1 1 amb 0.2 0.2 0.2 emis 0 0 0 spec 0 0 0 shi 0 trans 0\n'
            'OBJECT world\nkids 1\nOBJECT poly\nname "row"\nnumvert %d\n' % len(points))
    text += "".join("%d %d %d\n" % p for p in points) + "numsurf %d\n" % SQUARES
    for i in range(SQUARES):
        text += "SURF 0x10\nmat 0\nrefs 4\n" + "".join("%d 0 0\n" % (4 * i + k) for k in range(4))
    return (text + "kids 0\n").encode()


def dxf():
    text = "0\nSECTION\n2\nENTITIES\n"
    for square in corners():
        text += "0\n3DFACE\n8\nrow\n"
        for k, (x, y, z) in enumerate(square):
            text += "%d\n%g\n%d\n%g\n%d\n%g\n" % (10 + k, x, 20 + k, y, 30 + k, z)
    return (text + "0\nENDSEC\n0\nEOF\n").encode()


def directx():
    points = [p for square in corners() for p in square]
    # The plug-in keeps nothing of a mesh without a material.
    material = "Material m {\n1;1;1;1;;\n10;\n0;0;0;;\n0;0;0;;\n}\n"
    faces = ",\n".join("4;%d,%d,%d,%d;" % tuple(4 * i + k for k in range(4))
                       for i in range(SQUARES))
    chosen = ",\n".join("0" for _ in range(SQUARES))
    return ("xof 0303txt 0032\n\n%sFrame f {\nMesh row {\n%d;\n%s;\n%d;\n%s;\n"
            "MeshMaterialList {\n1;\n%d;\n%s;;\n{ m }\n}\n}\n}\n" % (
                material, len(points), ",\n".join("%d;%d;%d;" % p for p in points), SQUARES, faces,
                SQUARES, chosen)).encode()


WRITTEN = {"obj": obj, "stl": stl_text, "binary.stl": stl_binary, "ply": ply, "3ds": studio,
           "ac": ac, "dxf": dxf, "x": directx}
CONVERTED = ["osgt", "osgb", "ive", "osg", "osgx"]
# What a cut of these does not tell: a whole number of lines is a whole file.
CANNOT_TELL = {"obj"}


def mutant(rng, whole):
    """Bytes, and how many are left of a file that was only cut (else None)."""
    kind = rng.randrange(10)
    if kind == 0:
        size = rng.randrange(len(whole))
        return whole[:size], size
    bytes_ = bytearray(whole)
    for _ in range(rng.choice((1, 1, 2, 4, 16))):
        at = rng.randrange(len(bytes_))
        act = rng.randrange(5)
        if act == 0:
            bytes_[at] ^= 1 << rng.randrange(8)
        elif act == 1:
            bytes_[at] = rng.choice((0, 1, 0x7f, 0x80, 0xff, 0x20, 0x2d, 0x39))
        elif act == 2:
            bytes_[at:at + 4] = struct.pack("<I", rng.choice(
                (0, 1, 0x7fffffff, 0x80000000, 0xffffffff, 0x10000, 0xffff)))
        elif act == 3:
            del bytes_[at:at + rng.randrange(1, 16)]
        else:
            bytes_[at:at] = bytes_[at:at + rng.randrange(1, 64)]
        if not bytes_:
            break
    return bytes(bytes_), None


def faces_in(program, file):
    """Exit code (None for a hang), faces, and whether anything was remarked."""
    # 10 s of the processor, however busy the machine is.
    try:
        ran = subprocess.run(["prlimit", "--cpu=10", program, "--json", "model", "info", str(file)],
                             capture_output=True, timeout=200, check=False)
    except subprocess.TimeoutExpired:
        return None, 0, False
    if -ran.returncode in (signal.SIGXCPU, signal.SIGKILL):
        return None, 0, False
    faces, remarked = 0, False
    if ran.returncode == 0:
        said = json.loads(ran.stdout.decode("utf-8", "replace"))
        faces = sum(use["faces"] for use in said["codes"])
        remarked = bool(said["remarks"])
    return ran.returncode, faces, remarked


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--count", type=int, default=500)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", nargs="+", metavar="FORMAT", help="these formats alone")
    parser.add_argument("--keep", type=pathlib.Path, help="where mutants that did harm are kept")
    options = parser.parse_args()
    program = str(options.build / "bin/smat-batch")
    samples = pathlib.Path(__file__).resolve().parents[2] / "samples"
    bad = 0
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        wholes = {name: make() for name, make in WRITTEN.items()}
        flight = samples / "sphere/sphere.flt"
        wholes["flt"] = flight.read_bytes()
        (folder / "row.obj").write_bytes(wholes["obj"])
        for kind in CONVERTED:
            file = folder / ("row." + kind)
            subprocess.run([program, "convert", str(folder / "row.obj"), str(file)], check=True,
                           stdout=subprocess.DEVNULL)
            wholes[kind] = file.read_bytes()
        print("%-12s %6s %8s %8s %8s %8s %8s" % ("format", "read", "refused", "crashed", "hung",
                                                 "faults", "silent"))
        for kind, whole in sorted(wholes.items()):
            if options.only and kind not in options.only:
                continue
            rng = random.Random("%s %d" % (kind, options.seed))
            original = folder / ("whole." + kind)
            original.write_bytes(whole)
            all_faces = faces_in(program, original)[1]
            if all_faces == 0:
                sys.exit("the model of %s that mutants are made of is not read" % kind)
            files = []
            for i in range(options.count):
                bytes_, size = mutant(rng, whole)
                file = folder / ("%d.%s" % (i, kind))
                file.write_bytes(bytes_)
                files.append((file, size))
            counts = dict.fromkeys(("read", "refused", "crashed", "hung", "faults", "silent"), 0)
            with concurrent.futures.ThreadPoolExecutor(2) as pool:
                results = pool.map(lambda f: faces_in(program, f[0]), files)
                for (file, size), (code, faces, remarked) in zip(files, results):
                    silent = (code == 0 and size is not None and faces < all_faces and
                              not remarked and kind not in CANNOT_TELL)
                    what = ("hung" if code is None else "silent" if silent else
                            "read" if code == 0 else "refused" if code == 2 else
                            "crashed" if code < 0 or code > 100 else "faults")
                    counts[what] += 1
                    if what not in ("read", "refused"):
                        bad += 1
                        if options.keep:
                            options.keep.mkdir(parents=True, exist_ok=True)
                            name = re.sub(r"[^\w.]", "_", "%s-%s" % (what, file.name))
                            (options.keep / name).write_bytes(file.read_bytes())
                    file.unlink()
            print("%-12s %6d %8d %8d %8d %8d %8d" % ((kind,) + tuple(counts.values())), flush=True)
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
