#!/usr/bin/env python3
"""Draws how far two sensors see two targets in two airs, docs/figures/detection-*.svg, and prints the table of docs/sensor.md.

    scripts/figures/detection.py FOLDER_OF_THE_PROGRAMS [DEGREES [TARGET...]]

A run takes about a quarter of an hour of processor time at the step of 10 degrees. Targets that are not named keep their figures. The airs are those of the samples, temperate sea air with a
visibility of 23 km, and the same with one of 5 km."""

import csv
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
FIGURES = ROOT / "docs" / "figures"
TARGETS = {"corvette": ["--set", "polar.offset=2"], "heron": []}
SENSORS = {"cooled MWIR": "cooled-mwir", "scanning LWIR": "lwir-scanner"}
VISIBILITIES_KM = [23, 5]


def run(*words):
    subprocess.run([str(word) for word in words], check=True, stdout=subprocess.DEVNULL)


def ranges_of(file):
    with open(file, encoding="utf-8") as lines:
        rows = csv.DictReader(line for line in lines if not line.startswith("#"))
        return [(float(row["angle [deg]"]), float(row["detection_range [m]"])) for row in rows]


def main():
    programs, step = Path(sys.argv[1]), sys.argv[2] if len(sys.argv) > 2 else "10"
    targets = sys.argv[3:] or TARGETS
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        airs = {}
        for visibility_km in VISIBILITIES_KM:
            airs[visibility_km] = folder / f"air-{visibility_km}.xml"
            run(programs / "smat-batch", "atmosphere", "set", ROOT / "resources/atmospheres/temperate-maritime.xml",
                f"Visibility={1000 * visibility_km}", "--out", airs[visibility_km])
        print("| target, sensor, visibility | least range, km (aspect) | greatest range, km (aspect) |\n|---|---|---|")
        for target in targets:
            options, curves = TARGETS[target], []
            for sensor, file in SENSORS.items():
                for visibility_km, air in airs.items():
                    curves.append(folder / target / f"{sensor}, {visibility_km} km.csv")
                    curves[-1].parent.mkdir(exist_ok=True)
                    run(programs / "smat-batch", "detection", ROOT / f"samples/{target}/{target}.smat",
                        "--sensor", ROOT / f"resources/sensors/{file}.smatsensor", "--step", step, "--criterion", "johnson", "--task", "recognition",
                        "--atmosphere", air, "--set", "environment.terrain=", *options, "--out", curves[-1])
                    ranges = ranges_of(curves[-1])
                    ends = [min(ranges, key=lambda one: one[1]), max(ranges, key=lambda one: one[1])]
                    cells = " | ".join(f"{range_m / 1000:.1f} ({angle:.0f}°)" for angle, range_m in ends)
                    print(f"| {target}, {sensor}, {visibility_km} km | {cells} |", flush=True)
            run(programs / "smat", "plot", *curves, "--quantity", "detection_range",
                "-o", FIGURES / f"detection-{target}.svg")


if __name__ == "__main__":
    main()
