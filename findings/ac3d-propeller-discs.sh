#!/bin/bash
# What one would guess: a propeller disc of an AC3D model (FlightGear's AI aircraft) is one sheet, whose
# SURF flag 0x20 says that it is seen from both sides.
# What it is: two sheets. The DH82's are both two-sided and 45 um apart, on an aircraft of 9 m; the
# Beech 1900D has a "fast" and a "slow" disc 0.35 mm apart or in one plane, each of two one-sided copies
# that turn to either side and share places but no vertices, some 1e-5 m apart.
# Version: flightgear-data-ai 1:2020.3.16+dfsg-1 (Debian 12). Source: the model files themselves; the
# format: AC3D file format, SURF flags (Inivis, "The AC3D file format").
# Why it matters here: at 7 km a distance in single precision is known to 0.4 mm. A renderer that looks up a
# surface by its distance finds either sheet; the inner sides see nothing but each other, and an aircraft
# seen from ahead was 3 % too bright. Copies of a facet also have no edge that only one facet has, so
# that a search for outlines finds none.
set -euo pipefail

version='1:2020.3.16+dfsg-1'
work="$(mktemp -d)"
trap 'rm -rf "$work"' EXIT
cd "$work"
apt-get download "flightgear-data-ai=$version" >/dev/null
dpkg-deb -x flightgear-data-ai_*.deb data
echo "flightgear-data-ai $version"

python3 - "$work/data/usr/share/games/flightgear/AI/Aircraft" <<'PYTHON'
import sys

root = sys.argv[1]


def objects(path):
    """Name, vertices and polygons (SURF flags, vertex numbers) of each object."""
    lines = open(path, encoding="latin-1").read().split("\n")
    found, i = {}, 0
    name, vertices, polygons = None, [], []
    while i < len(lines):
        words = lines[i].split()
        if words[:1] == ["OBJECT"]:
            name, vertices, polygons = None, [], []
        elif words[:1] == ["name"]:
            name = words[1].strip('"')
            found[name] = (vertices, polygons)
        elif words[:1] == ["numvert"]:
            for k in range(int(words[1])):
                vertices.append(tuple(float(w) for w in lines[i + 1 + k].split()[:3]))
            i += int(words[1])
        elif words[:1] == ["SURF"]:
            flags = int(words[1], 16)
            while not lines[i].startswith("refs"):
                i += 1
            count = int(lines[i].split()[1])
            polygons.append((flags, [int(lines[i + 1 + k].split()[0]) for k in range(count)]))
            i += count
        i += 1
    return found


def planes(vertices, polygons):
    """Along x, the axis of the propeller: where polygons lie, and how often they turn to +x and -x."""
    found = {}
    for flags, refs in polygons:
        a, b, c = (vertices[k] for k in refs[:3])
        turn = (b[1] - a[1]) * (c[2] - a[2]) - (b[2] - a[2]) * (c[1] - a[1])
        key = round(sum(vertices[k][0] for k in refs) / len(refs), 6)
        ways = found.setdefault(key, [0, 0])
        ways[0 if turn > 0 else 1] += 1
    return found


dh82 = objects(root + "/DH82/Models/DH82.ac")["propdisc"]
where = sorted(planes(*dh82))
gap_um = 1e6 * (where[-1] - where[0])
both = all(flags & 0x20 for flags, _ in dh82[1])
print(f"DH82 propdisc: planes at x = {where} m, {gap_um:.0f} um apart, all two-sided: {both}")

b1900d = objects(root + "/b1900d/Models/b1900d.ac")
parts = {name: planes(*b1900d[name]) for name in ("RHFastprop", "RHSlowprop")}
for name, found in parts.items():
    one = any(flags & 0x20 for flags, _ in b1900d[name][1])
    for x, (forward, back) in found.items():
        print(f"b1900d {name}: at x = {x} m, {forward} facets turn to +x, {back} to -x, two-sided: {one}")
apart_mm = 1e3 * abs(min(parts["RHFastprop"]) - min(parts["RHSlowprop"]))
print(f"b1900d fast and slow discs: {apart_mm:.2f} mm apart")

same = (
    len(where) >= 2
    and 40 < gap_um < 50
    and both
    and all(forward == back > 0 for found in parts.values() for forward, back in found.values())
    and 0.3 < apart_mm < 0.4
)
sys.exit(0 if same else "the files have changed")
PYTHON
