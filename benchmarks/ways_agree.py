#!/usr/bin/env python3
"""Image, simulate and sweep of the same views, side by side.

    benchmarks/ways_agree.py SMAT_BATCH [--quick]

Of two samples, seen from several azimuths and elevations in four bands, through haze from a table and
through computed air, in the spectral mode and in ck, it takes intensity and contrast from `image`,
from `simulate` and from `polar`, and prints the largest differences: of the intensity as a part of
it, of the contrast as a part of the intensity. Leaves with 1 where one is above 1e-5.
"""
import argparse
import csv
import json
import math
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
BANDS = ["3-5", "4.2-4.5", "4.4-4.6", "8-12"]
AIRS = {"haze": "resources/atmospheres/haze-23km.csv",
        "computed": "resources/atmospheres/midlatitude-summer-rural-23km.xml"}
SAMPLES = {"turboprop4": {"elevations": [-20, 0, 30], "range": 900.0, "altitude": 1500.0,
                          "power": 0.7, "mach": 0.4, "fov": 3.0},
           "ship": {"elevations": [0, 8, 30], "range": 1500.0, "altitude": 10.0,
                    "power": 0.0, "mach": 0.0, "fov": 8.0}}
AZIMUTHS = [0, 60, 120, 180]
LARGEST = 1e-5


def run(program, *arguments):
    done = subprocess.run([program, *map(str, arguments)], capture_output=True, text=True)
    if done.returncode:
        sys.exit(f"{' '.join(map(str, arguments))}:\n{done.stdout}{done.stderr}")


def settings(name, sample, air, mode):
    return {"environment": {"atmospheres": [str(ROOT / AIRS[air])], "sunAzimuth": 135,
                            "sunElevation": 40},
            "sensor": {"fov": sample["fov"], "mode": mode, "width": 320, "height": 256}}


def model(name):
    folder = ROOT / "samples" / name
    return {"database": str(folder / f"{name}.sigdb"), "referencePoint_m": [0, 0, 0], "name": name}


def project(folder, name, sample, air, mode):
    text = settings(name, sample, air, mode)
    text |= {"version": 1,
             "models": [model(name) | {"file": str(ROOT / "samples" / name / f"{name}.flt")}],
             "camera": {"range": sample["range"]},
             "target": {"altitude": sample["altitude"]},
             "state": {"power": sample["power"], "mach": sample["mach"]}}
    file = folder / "project.smat"
    file.write_text(json.dumps(text))
    return file


def scenario(folder, name, sample, air, mode, elevation, band):
    text = settings(name, sample, air, mode)
    # Scenarios draw scales where a model has some, unless they say otherwise.
    text |= {"version": 1, "dt_s": 1, "end_s": 0, "scaling": {"use": False},
             "entities": [model(name) | {"model": str(ROOT / "samples" / name / f"{name}.flt"),
                                         "position_m": [0, 0, sample["altitude"]],
                                         "power": sample["power"], "mach": sample["mach"]}],
             "sensors": []}
    distance, e = sample["range"], math.radians(elevation)
    for azimuth in AZIMUTHS:
        a = math.radians(azimuth)
        text["sensors"].append(
            {"name": f"from{azimuth}", "track": name, "sensor": {"band": band},
             "position_m": [distance * math.sin(a) * math.cos(e),
                            distance * math.cos(a) * math.cos(e),
                            sample["altitude"] + distance * math.sin(e)]})
    file = folder / "scenario.json"
    file.write_text(json.dumps(text))
    return file


def table(file):
    with open(file, encoding="utf-8") as lines:
        rows = list(csv.reader(line for line in lines if not line.startswith("#")))
    return [dict(zip(rows[0], map(float, row))) for row in rows[1:]]


def compare(program, name, sample, air, mode, elevations, bands, worst):
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(temporary)
        file = project(folder, name, sample, air, mode)
        for elevation in elevations:
            for band in bands:
                # Hot parts and with them windows follow the bands that are asked for together.
                run(program, "polar", file, "--offset", elevation, "--step", 60, "--band", band,
                    "--out", folder / "polar.csv")
                sweep = {row["angle [deg]"]: row for row in table(folder / "polar.csv")}
                run(program, "simulate",
                    scenario(folder, name, sample, air, mode, elevation, band),
                    "--out", folder / "sim")
                for azimuth in AZIMUTHS:
                    simulated = table(folder / "sim" / f"from{azimuth}.csv")[0]
                    run(program, "image", file, "--elevation", elevation, "--azimuth", azimuth,
                        "--band", band, "--out", folder / "image.json")
                    image = {c["name"]: c["values"][0]
                             for c in json.loads((folder / "image.json").read_text())["columns"]}
                    truth = sweep[float(azimuth)]["intensity [W sr-1]"]
                    for quantity in ["intensity", "contrast_intensity"]:
                        swept = sweep[float(azimuth)][f"{quantity} [W sr-1]"]
                        for way, value in [("image", image[quantity]),
                                           ("simulate",
                                            simulated[f"{name}.{quantity} [W sr-1]"])]:
                            error = abs(value - swept) / truth
                            key = (name, air, mode, way, quantity)
                            worst[key] = max(worst.get(key, (0.0, "")),
                                             (error, f"{elevation} deg, {azimuth} deg, {band} um"))


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("--quick", action="store_true", help="one elevation, two bands")
    options = parser.parse_args()
    worst = {}
    for name, sample in SAMPLES.items():
        for air in AIRS:
            for mode in ["spectral"] if air == "haze" else ["spectral", "ck"]:
                compare(options.program.resolve(), name, sample, air, mode,
                        sample["elevations"][1:2] if options.quick else sample["elevations"],
                        BANDS[:2] if options.quick else BANDS, worst)
    print("| sample | air | mode | against the sweep | quantity | largest difference | at |")
    print("|---|---|---|---|---|---|---|")
    for (name, air, mode, way, quantity), (error, where) in worst.items():
        print(f"| {name} | {air} | {mode} | {way} | {quantity} | {error:.2g} | {where} |")
    return max(error for error, _ in worst.values()) > LARGEST


if __name__ == "__main__":
    sys.exit(main())
