#!/usr/bin/env python3
"""Includes that go up: include-order.py [--counts] [TREE]

Every folder of the product stands in the list below, lowest first, and includes what stands in its own line or in lines
before it. Prints each include that goes up, each of OpenSceneGraph, OpenGL or Qt where a floor does without it, and each
header of irsg from which includes lead to OpenSceneGraph, where it does not read or convert its graphs. Ends with 1 where
there is one, or where a folder with sources is missing in the list. --counts prints the files of each line, too.
"""
import argparse
import os
import re
import sys

# Folders of a line may include each other.
ORDER = [
    ["irsg/core"],
    ["irsg/radiometry"],
    ["irsg/karma"],
    ["irsg/atmosphere/path"],
    ["irsg/atmosphere/engine"],
    ["irsg/atmosphere/tables"],
    ["irsg/atmosphere", "irsg/atmosphere/ck", "irsg/atmosphere/import"],
    ["irsg/gas"],
    ["irsg/signature", "irsg/signature/random"],
    ["irsg/image"],
    ["irsg/scattering"],
    ["irsg/geometry/view"],
    ["irsg/geometry/reading", "irsg/geometry/reading/sandbox", "irsg/geometry/reading/text",
     "irsg/geometry/reading/assimp"],
    ["irsg/geometry/flight"],
    ["irsg/geometry/reader"],
    ["irsg/geometry/mesh"],
    ["irsg/geometry/conversion"],
    ["irsg/geometry/model"],
    ["irsg/geometry"],
    ["irsg/render/values"],
    ["irsg/render/sampling"],
    ["irsg/render/rays", "irsg/render/opengl"],
    ["irsg/render/background"],
    ["irsg/radiance", "irsg/radiance/exchange"],
    ["irsg/scene", "irsg/scene/scattering"],
    ["irsg/sensor"],
    ["irsg/reference"],
    ["smatcore/support"],
    ["smatcore/settings"],
    ["smatcore/data"],
    ["smatcore/project"],
    ["smatcore/tables"],
    ["smatcore/analysis", "smatcore/analysis/kinds"],
    ["smatcore/results"],
    ["smatcore/simulate", "smatcore/tools"],
    ["smatcore/jobs"],
    ["smatcore/selftest"],
    ["gui"],
    ["apps", "tools", "python"],
]
# Headers, and the folders whose sources, with those in folders below them, must not name them.
OSG = r"osg[A-Za-z]*/"
GL = r"GL/|EGL/"
QT = r"Q[A-Z]|qwt"
WITHOUT = [
    (OSG, ["irsg/render", "irsg/scene", "irsg/geometry/view", "irsg/geometry/mesh"]),
    (OSG + "|" + GL, ["irsg/core", "irsg/radiometry", "irsg/karma", "irsg/atmosphere", "irsg/signature", "irsg/image",
                      "irsg/scattering", "irsg/radiance", "irsg/thermal", "irsg/sensor", "smatcore"]),
    (QT, ["irsg", "smatcore"]),
]
# Folders of irsg whose headers may lead to OpenSceneGraph, or name its types.
OF_GRAPHS = ("irsg/geometry/reading/", "irsg/geometry/conversion/")

parser = argparse.ArgumentParser()
parser.add_argument("--counts", action="store_true")
parser.add_argument("tree", nargs="?", default=os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
asked = parser.parse_args()
level = {folder: number for number, line in enumerate(ORDER) for folder in line}
complaints, counts = [], [0] * len(ORDER)
included, of_osg = {}, set()  # headers that a header of irsg includes; those that name OpenSceneGraph


def level_of(folder):
    """Of the folder, or of gui, apps, tools and python that it lies in."""
    top = folder.split("/")[0]
    return level.get(folder, level.get(top) if top in ("gui", "apps", "tools", "python") else None)


for top in ("irsg", "smatcore", "gui", "apps", "tools", "python"):
    for place, _, names in os.walk(os.path.join(asked.tree, top)):
        folder = os.path.relpath(place, asked.tree)
        own = level_of(folder)
        for name in sorted(n for n in names if n.endswith((".h", ".cpp"))):
            path = os.path.join(folder, name)
            if own is None:
                complaints.append(f"{path}: the folder {folder} has no place in the order of scripts/include-order.py")
                continue
            counts[own] += 1
            with open(os.path.join(asked.tree, path), encoding="utf-8") as source:
                for number, line in enumerate(source, 1):
                    if path.endswith(".h") and re.search(rf"#\s*include\s+<{OSG}|\bosg\w*::|\bnamespace osg", line):
                        of_osg.add(path)
                    if match := re.match(r'\s*#\s*include\s+"([^"]+/[^"]+)"', line):
                        included.setdefault(path, []).append(match[1])
                        other = level_of(os.path.dirname(match[1]))
                        if other is not None and other > own:
                            complaints.append(f"{path}:{number}: {match[1]} lies above {folder}")
                    elif match := re.match(r"\s*#\s*include\s+<([^>]+)>", line):
                        for headers, floors in WITHOUT:
                            for floor in floors:
                                if (folder + "/").startswith(floor + "/") and re.match(headers, match[1]):
                                    complaints.append(f"{path}:{number}: {floor} does without <{match[1]}>")

def way_to_osg(path, passed=()):
    """The headers by which one leads to OpenSceneGraph, itself first; none where it does not."""
    if path in of_osg:
        return [path]
    ways = (way_to_osg(to, (*passed, path)) for to in included.get(path, []) if to not in (*passed, path))
    return next(([path, *way] for way in ways if way), [])


for path in sorted({*included, *of_osg}):
    if path.startswith("irsg/") and path.endswith(".h") and not path.startswith(OF_GRAPHS) and (way := way_to_osg(path)):
        complaints.append(f"{path}: a header that leads to OpenSceneGraph: {', '.join(way)}")

for complaint in complaints:
    print(complaint)
if asked.counts:
    for line, count in zip(ORDER, counts):
        print(f"{count:5} {' '.join(line)}")
sys.exit(1 if complaints else 0)
