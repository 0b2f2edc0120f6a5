#!/usr/bin/env python3
"""One view by every way to its numbers, side by side.

    benchmarks/every_way.py SMAT_BATCH [--quick] [--module FOLDER] [--case NAME ...]

Takes intensity, contrast intensity and irradiance of each object from `image`, and holds against them
`polar`, `table` (of one and of several ranges), `time`, `condition`, the nominal row of `montecarlo`
where the model has scales, the in-band numbers of `spectrum`, `range`, `simulate`, the sums over the
pixels of the image, and the Python module (FOLDER that holds `smat`), each in antialiasing mode 5 and in
the default one. Differences are parts of the intensity, those of irradiance of what it would be without
a background. Leaves with 1 where one is more than 1e-5 in mode 5 or 1e-4 by default; a range curve, a table
of several ranges and frames of `simulate` may differ by their stated errors instead.

The cases: an aircraft and a ship by their facets, a jet and a ship with zones of hot gas, and two objects
below a pixel, one of them 35 degrees off the axis. `--quick` takes one band of each.
"""
import argparse
import csv
import json
import math
import os
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
SAMPLES = ROOT / "samples"
QUANTITIES = ["intensity", "contrast_intensity", "irradiance"]
LARGEST = {"5": 1e-5, "default": 1e-4}
MAY_DIFFER = ["range", "table, ranges", "simulate"]
#: Sensor and view of each case; what is not here is that of the sample.
CASES = {
    "turboprop4": {"azimuth": 60, "elevation": 12, "range": 900, "bands": ["8-12", "3-5"], "scales": True},
    "ship": {"azimuth": 120, "elevation": 0, "range": 1500, "bands": ["8-12", "3-5"], "fov": 8},
    "tern": {"azimuth": 120, "elevation": 12, "range": 1200, "bands": ["4.2-4.5", "3-5"], "fov": 3},
    "corvette": {"azimuth": 120, "elevation": 4, "range": 1500, "bands": ["3-5", "8-12"], "fov": 6},
    "off-axis": {"azimuth": 120, "elevation": 12, "range": 2500, "bands": ["3-5", "8-12"], "fov": 90,
                 "width": 128, "height": 128, "sample": "turboprop4", "beside": 35.0, "scales": True},
}


def run(program, *arguments):
    done = subprocess.run([program, *map(str, arguments)], capture_output=True, text=True)
    if done.returncode not in (0, 1):
        sys.exit(f"{' '.join(map(str, arguments))}:\n{done.stdout}{done.stderr}")
    return done.stdout


def direction(azimuth_deg, elevation_deg):
    a, e = math.radians(azimuth_deg), math.radians(elevation_deg)
    return [math.sin(a) * math.cos(e), math.cos(a) * math.cos(e), math.sin(e)]


class View:
    """A case as a project and as a scenario of one frame."""

    def __init__(self, name, case, folder):
        self.name, self.case, self.folder = name, case, folder
        sample = SAMPLES / case.get("sample", name)
        self.text = json.loads((sample / f"{sample.name}.smat").read_text())
        self.text.pop("analyses", None)
        environment = self.text["environment"]
        environment["atmospheres"] = [str((sample / file).resolve()) for file in environment["atmospheres"]]
        for key in [key for key in environment if key.startswith("terrain")]:
            del environment[key]
        target = self.text["models"][0]
        target |= {key: str(sample / target[key]) for key in ("file", "database")}
        # simulate takes positions of the origin of a model.
        target["referencePoint_m"] = [0, 0, 0]
        self.text["sensor"] |= {key: case[key] for key in ("fov", "width", "height") if key in case}
        self.text["camera"] = {key: case[key] for key in ("azimuth", "elevation", "range")}
        self.objects = [target["name"]]
        if "beside" in case:
            self.add_beside(case)
        self.project = folder / "project.smat"
        self.project.write_text(json.dumps(self.text))

    def camera_m(self):
        towards = direction(self.case["azimuth"], self.case["elevation"])
        above_m = self.text["target"]["altitude"]
        return [self.case["range"] * part + (above_m if i == 2 else 0.0) for i, part in enumerate(towards)]

    def add_beside(self, case):
        """A box twice as far, to the right of the axis."""
        box = json.loads((SAMPLES / "box/box.smat").read_text())["models"][0]
        camera = self.camera_m()
        a = math.radians(case["azimuth"])
        right = [-math.cos(a), math.sin(a), 0.0]
        forward = [-part for part in direction(case["azimuth"], case["elevation"])]
        angle = math.radians(case["beside"])
        place = [camera[i] + 2.0 * case["range"] *
                 (math.cos(angle) * forward[i] + math.sin(angle) * right[i]) for i in range(3)]
        # The axis goes down: the box stands higher than that.
        place[2] = self.text["target"]["altitude"]
        self.text["models"].append({"name": "box", "file": str(SAMPLES / "box" / box["file"]),
                                    "database": str(SAMPLES / "box" / box["database"]),
                                    "referencePoint_m": [0, 0, 0], "position_m": place})
        self.objects.append("box")

    def scenario(self, options):
        text = {key: self.text[key] for key in ("environment", "sensor")}
        text |= {"version": 1, "dt_s": 1, "end_s": 0, "scaling": {"use": False},
                 "render": self.text.get("render", {}) | options.get("render", {}), "entities": []}
        state = self.text.get("state", {})
        for model in self.text["models"]:
            entity = {key: model[key] for key in ("name", "database", "referencePoint_m")}
            entity |= {"model": model["file"],
                       "position_m": model.get("position_m", [0, 0, self.text["target"]["altitude"]])}
            if "position_m" not in model:
                entity |= {key: state[key] for key in ("power", "mach") if key in state}
                entity["timeOffset_s"] = state.get("time", 0)
            text["entities"].append(entity)
        text["sensors"] = [{"name": "eye", "track": self.objects[0], "position_m": self.camera_m(),
                            "sensor": {"band": options["band"]}}]
        file = self.folder / "scenario.json"
        file.write_text(json.dumps(text))
        return file


def table_of(file):
    """Rows of a result, by name without unit."""
    with open(file, encoding="utf-8") as lines:
        rows = list(csv.reader(line for line in lines if not line.startswith("#")))
    return [{name.split(" [")[0]: value for name, value in zip(rows[0], row)} for row in rows[1:]]


def numbers(row, objects, prefix=""):
    """{(object, quantity): value} of a row of a table, of all and of each object that has columns."""
    found = {}
    for name in ["all", *objects]:
        own = "" if name == "all" else f"{name}."
        if f"{own}{prefix}intensity" not in row:
            continue
        key = name if len(objects) > 1 else "all"
        for quantity in QUANTITIES:
            found[key, quantity] = float(row[f"{own}{prefix}{quantity}"])
            error = row.get(f"error_{own}{prefix}{quantity}")
            if error:
                found[key, f"error_{quantity}"] = float(error)
    return found


class Ways:
    """All ways to the numbers of a view, in a band and a mode."""

    def __init__(self, program, view, band, mode, module=None):
        self.program, self.view, self.module = program, view, module
        self.options = {"band": band}
        self.common = ["--band", band, "--mode", "spectral"]
        if mode != "default":
            self.common += ["--antialiasing", mode]
            self.options["render"] = {"antialiasing": int(mode)}
        self.out = view.folder / "result.csv"

    def rows(self, kind, *arguments):
        run(self.program, kind, self.view.project, *self.common, *arguments, "--out", self.out)
        return table_of(self.out)

    def of(self, row, prefix=""):
        return numbers(row, self.view.objects, prefix)

    def image(self):
        written = self.view.folder / "image.json"
        self.picture = self.view.folder / "image.exr"
        run(self.program, "image", self.view.project, *self.common, "--out", written, "--out", self.picture)
        columns = json.loads(written.read_text())["columns"]
        return self.of({column["name"]: column["values"][0] for column in columns})

    def pixels(self):
        compared = json.loads(run(self.program, "compare", self.picture, self.picture, "--json"))
        return compared["comparisons"][0]["contrast_intensity_a"]

    def all(self):
        case, state = self.view.case, self.view.text.get("state", {})
        azimuth, elevation, range_m = case["azimuth"], case["elevation"], case["range"]
        turn = ["--set", f"polar.from={azimuth}", "--set", f"polar.to={azimuth + 180}", "--set", "polar.step=180",
                "--set", f"polar.offset={elevation}"]
        yield "polar", self.of(self.rows("polar", *turn)[0])
        grid = ["--azimuth-step", azimuth, "--elevation-from", elevation, "--elevation-to", elevation]
        yield "table", self.of(self.rows("table", *grid)[1])
        yield "table, ranges", self.of(next(
            row for row in self.rows("table", *grid, "--ranges", f"{range_m},{2 * range_m}")
            if float(row["azimuth"]) == azimuth and float(row["range"]) == range_m))
        yield "range", self.of(self.rows("range", "--from", range_m, "--to", 1.5 * range_m, "--points", 2,
                                         "--steps", "fixed")[0])
        begin = state.get("time", 0)
        yield "time", self.of(self.rows("time", "--from", begin, "--to", begin + 1, "--step", 1)[0])
        power = state.get("power", 0)
        yield "condition", self.of(self.rows("condition", "--over", "power", "--from", power,
                                             "--to", power + 0.1, "--points", 2)[0])
        self.rows("spectrum")
        inside = dict(line[2:].split(": ") for line in self.out.read_text().splitlines()
                      if line.startswith("# ") and "in_band_" in line)
        yield "spectrum", self.of({key.split(" [")[0]: value for key, value in inside.items()}, "in_band_")
        if case.get("scales"):
            nominal = {}
            for quantity in QUANTITIES:
                rows = self.rows("montecarlo", "--kind", "polar", *turn, "--samples", 2, "--subpixel-shifts", 1,
                                 "--quantity", quantity)
                nominal["all", quantity] = float(rows[0]["nominal"])
            yield "montecarlo", nominal
        folder = self.view.folder / "frames"
        run(self.program, "simulate", self.view.scenario(self.options), "--mode", "spectral", "--out", folder)
        yield "simulate", self.of(table_of(folder / "eye.csv")[0])
        if self.module:
            yield "library", self.by_module(azimuth, elevation)

    def by_module(self, azimuth, elevation):
        """Of a process of its own, which has the module."""
        settings = {"sensor.band": self.options["band"], "sensor.mode": "spectral"}
        if "render" in self.options:
            settings["render.antialiasing"] = self.options["render"]["antialiasing"]
        code = ("import json, sys, smat\n"
                "project, settings = sys.argv[1], json.loads(sys.argv[2])\n"
                "image = smat.Project(project).with_settings(settings).image()\n"
                "table = image.table\n"
                "print(json.dumps({name: float(table[name][0]) for name in table}))\n")
        done = subprocess.run([sys.executable, "-c", code, str(self.view.project), json.dumps(settings)],
                              env=os.environ | {"PYTHONPATH": str(self.module)}, capture_output=True, text=True)
        if done.returncode:
            sys.exit(done.stderr)
        return self.of(json.loads(done.stdout))


def differences(truth, found):
    """{quantity: largest of all objects, as a part of the intensity}, and that over the stated errors."""
    worst, stated = {}, 0.0
    for (name, quantity), value in found.items():
        if quantity not in QUANTITIES:
            continue
        unit = truth[name, "intensity"]
        if quantity == "irradiance":
            # What there would be without a background.
            unit *= abs(truth[name, "irradiance"] / truth[name, "contrast_intensity"])
        off = abs(value - truth[name, quantity]) / unit
        worst[quantity] = max(worst.get(quantity, 0.0), math.inf if math.isnan(off) else off)
        # Both are within their own.
        error = math.hypot(found.get((name, f"error_{quantity}"), 0.0),
                           truth.get((name, f"error_{quantity}"), 0.0))
        if error:
            stated = max(stated, abs(value - truth[name, quantity]) / error)
    return worst, stated


def is_good(way, mode, worst, stated):
    return (all(off <= LARGEST[mode] for off in worst.values()) or
            way in MAY_DIFFER and stated <= 1.0)


def compare(program, name, case, band, mode, module):
    """(way, {quantity: difference}, difference over stated error) of each way."""
    with tempfile.TemporaryDirectory() as temporary:
        view = View(name, case, pathlib.Path(temporary))
        ways = Ways(program, view, band, mode, module)
        truth = ways.image()
        if len(view.objects) == 1:
            off = abs(ways.pixels() - truth["all", "contrast_intensity"]) / truth["all", "intensity"]
            yield "pixels", {"contrast_intensity": off}, 0.0
        for way, found in ways.all():
            yield (way, *differences(truth, found))


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("--quick", action="store_true", help="one band of each case")
    parser.add_argument("--module", type=pathlib.Path, help="folder of the Python module")
    parser.add_argument("--case", action="append", choices=CASES, help="only this one; may be repeated")
    given = parser.parse_args()
    bad = 0
    print("| case | band, um | mode | way | " + " | ".join(QUANTITIES) + " | over stated error |")
    print("|---|---|---|---|" + "---|" * (len(QUANTITIES) + 1))
    for name in given.case or CASES:
        case = CASES[name]
        for band in case["bands"][:1] if given.quick else case["bands"]:
            for mode in LARGEST:
                for way, worst, stated in compare(given.program.resolve(), name, case, band, mode, given.module):
                    bad += not is_good(way, mode, worst, stated)
                    print(f"| {name} | {band} | {mode} | {way} | " +
                          " | ".join(f"{worst.get(q, 0.0):.1e}" for q in QUANTITIES) +
                          f" | {stated:.2f} |{'' if is_good(way, mode, worst, stated) else ' <-'}", flush=True)
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
