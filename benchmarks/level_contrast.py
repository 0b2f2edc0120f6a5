#!/usr/bin/env python3
"""Contrasts of level targets beside sums over lines of sight, near and far.

    benchmarks/level_contrast.py SMAT_BATCH [PROJECT] [--band 8-12] [--altitude M]

For ranges of 5 to 100 km along a level path it prints the contrast intensity that `polar` gives, and how far
two backgrounds are off: that at elevation 0, which a flat scene suggests, and the default. The witness
follows a ray through air of its own until it joins sensor and target, asks `radiative` for the background in
that direction, and takes it from the intensity: I - L A. The area A that the target hides follows from
two constant backgrounds. Leaves with 1 where the default is off by more than 0.2 % of the contrast and
3e-4 of the intensity, by which integrals over the bins of `radiative` differ from sums at their nodes;
`test_horizon` holds contrasts of small bodies to 1e-5 at the same nodes.
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
RADIUS_M = 6371.23e3
RANGES_M = [5e3, 10e3, 20e3, 30e3, 50e3, 100e3]


def run(program, *arguments):
    done = subprocess.run([program, *map(str, arguments)], capture_output=True, text=True)
    if done.returncode:
        sys.exit(f"{' '.join(map(str, arguments))}:\n{done.stdout}{done.stderr}")
    return done.stdout


def index_slope(altitude_m):
    """d n / d z of air whose refractivity is 2.7e-4 at 0 m and halves within 6.6 km."""
    return -2.7e-4 / 9500.0 * math.exp(-altitude_m / 9500.0)


def altitude_after(altitude_m, elevation_rad, range_m, steps=4000):
    step = range_m / steps
    for _ in range(steps):
        turn = math.cos(elevation_rad) * (1.0 / (RADIUS_M + altitude_m) + index_slope(altitude_m))
        middle = elevation_rad + 0.5 * step * turn
        altitude_m += step * math.sin(middle)
        elevation_rad += step * turn
    return altitude_m


def apparent_elevation(altitude_m, range_m):
    low, high = -0.05, 0.05
    for _ in range(40):
        middle = 0.5 * (low + high)
        if altitude_after(altitude_m, middle, range_m) < altitude_m:
            low = middle
        else:
            high = middle
    return 0.5 * (low + high)


class Case:
    def __init__(self, program, project, band, altitude_m):
        self.program, self.project, self.band, self.altitude_m = program, project, band, altitude_m
        self.atmosphere = [project.parent / name
                           for name in json.loads(project.read_text())["environment"]["atmospheres"]]

    def sums(self, range_m, *options):
        """Intensity and contrast intensity of all objects, W sr-1."""
        with tempfile.TemporaryDirectory() as folder:
            out = pathlib.Path(folder) / "polar.csv"
            run(self.program, "polar", self.project, "--band", self.band, "--range", range_m,
                "--altitude", self.altitude_m, "--elevation", 0, "--step", 180, "--mode", "spectral", *options,
                "--out", out)
            rows = [row for row in csv.reader(out.open()) if row and not row[0].startswith("#")]
        names = [name.strip() for name in rows[0]]
        def value(quantity):
            column = next(i for i, name in enumerate(names)
                          if name.split(" ")[0].split(".")[-1] == quantity)
            return float(rows[1][column])
        return value("intensity"), value("contrast_intensity")

    def background(self, elevation_rad):
        sun = json.loads(self.project.read_text())["environment"]
        with tempfile.TemporaryDirectory() as folder:
            out = pathlib.Path(folder) / "background.csv"
            run(self.program, "radiative", *self.atmosphere, "--band", self.band,
                "--quantity", "background", "--sensor-altitude", self.altitude_m,
                f"--los-elevation={math.degrees(elevation_rad):.9f}", "--los-azimuth", 180,
                "--sun-azimuth", sun.get("sunAzimuth", 180),
                "--sun-elevation", sun.get("sunElevation", 45), "--out", out)
            line = next(line for line in out.read_text().splitlines()
                        if line.startswith("#") and "in_band" in line)
        return float(line.split(":")[-1])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("project", nargs="?", type=pathlib.Path,
                        default=ROOT / "samples/turboprop4/turboprop4.smat")
    parser.add_argument("--band", action="append")
    parser.add_argument("--altitude", action="append", type=float)
    given = parser.parse_args()
    bad = 0
    print("band um, altitude m, range km: contrast W/sr, off by at elevation 0, off by as it is")
    for band in given.band or ["3-5", "8-12"]:
        for altitude_m in given.altitude or [100.0, 1500.0, 10000.0]:
            case = Case(given.program, given.project.resolve(), band, altitude_m)
            level = case.background(0.0)
            for range_m in RANGES_M:
                if range_m > 2.0 * math.sqrt(2.2 * RADIUS_M * altitude_m):
                    continue  # behind the horizon
                intensity, contrast = case.sums(range_m)
                area_m2 = (case.sums(range_m, "--background", "0")[1] -
                           case.sums(range_m, "--background", "1")[1])
                true = intensity - area_m2 * case.background(apparent_elevation(altitude_m, range_m))
                flat = intensity - area_m2 * level
                off = abs(contrast - true)
                bad += off > max(2e-3 * abs(true), 3e-4 * intensity)
                print(f"{band:>5} {altitude_m:7.0f} {range_m / 1e3:5.0f}: {true:12.5g} "
                      f"{100.0 * (flat / true - 1.0):+9.2f} % {100.0 * (contrast / true - 1.0):+9.3f} %"
                      f"   ({off / intensity:.1e} of the intensity)", flush=True)
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
