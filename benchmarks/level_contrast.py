#!/usr/bin/env python3
"""Contrasts of level targets beside sums over lines of sight, near and far.

    benchmarks/level_contrast.py SMAT_BATCH [--target box] [--band 8-12] [--altitude M]

For ranges of 5 to 100 km along a level path it prints the contrast intensity that `polar` gives, and how far
two backgrounds are off: that at elevation 0, which a flat scene suggests, and the default. The witness
follows a ray through air of its own (hydrostatic, of the temperature that `temperature-profile` reports)
until it joins sensor and target, asks `radiative` for the background in that direction and in those of
all rows of a picture of the target, and takes their mean by what the rows hide from the intensity: I - L A.
The area A that the target hides follows from two constant backgrounds.

The targets: the sample box, grey and small, whose background is integrated over the same wavelengths as that
of `radiative`: it shows whether the direction is right. And turboprop4, which reaches over 10 m of altitude
and has spectral paints, so that its integrals are sums at other wavelengths (up to 5e-4 beside those of
`radiative`, in intensity and background alike). The witness's backgrounds are multiplied with the ratio that
one row (`--background-rows 1`) shows: it tells whether the mean over the target is right.

The witness's own error is that of its refraction, taken as 2 % of it, and half of what 64 rows change beside 32.
Leaves with 1 where the default is off by more than 0.2 % of the contrast and 1e-5 of the intensity beside that.
"""
import argparse
import bisect
import csv
import json
import math
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
RADIUS_M = 6371.23e3
#: Whether its integrals are sums at other wavelengths than those of `radiative`.
TARGETS = {"box": False, "turboprop4": True}
#: Of the picture that tells what the target hides.
ROWS, FRAME_M = 64, 40.0
RANGES_M = [5e3, 10e3, 20e3, 30e3, 50e3, 100e3]


def run(program, *arguments):
    done = subprocess.run([program, *map(str, arguments)], capture_output=True, text=True)
    if done.returncode:
        sys.exit(f"{' '.join(map(str, arguments))}:\n{done.stdout}{done.stderr}")
    return done.stdout


STEP_M = 50.0


class Refraction:
    """Air in hydrostatic balance: what a ray does in it."""

    def __init__(self, temperatures_K):
        """Temperatures from 0 m on, each STEP_M apart."""
        pressure_hPa, refractivity = 1013.25, []
        for i, temperature_K in enumerate(temperatures_K):
            if i:
                mean_K = 0.5 * (temperature_K + temperatures_K[i - 1])
                pressure_hPa *= math.exp(-9.80665 * 0.0289644 * STEP_M / (8.314462618 * mean_K))
            # Dry air in the infrared: 2.726e-4 at 288.15 K and 1013.25 hPa.
            refractivity.append(7.752e-5 * pressure_hPa / temperature_K)
        self.slopes = [(b - a) / STEP_M for a, b in zip(refractivity, refractivity[1:])]

    def slope(self, altitude_m):
        """d n / d z, a straight line between the middles of the steps."""
        place = min(max(altitude_m / STEP_M - 0.5, 0.0), len(self.slopes) - 1.001)
        below = int(place)
        return self.slopes[below] + (place - below) * (self.slopes[below + 1] - self.slopes[below])

    def altitude_after(self, altitude_m, elevation_rad, range_m, scale, steps=4000):
        step = range_m / steps
        for _ in range(steps):
            turn = math.cos(elevation_rad) * (1.0 / (RADIUS_M + altitude_m) + scale * self.slope(altitude_m))
            middle = elevation_rad + 0.5 * step * turn
            altitude_m += step * math.sin(middle)
            elevation_rad += step * turn
        return altitude_m

    def apparent_elevation(self, altitude_m, range_m, scale=1.0):
        low, high = -0.05, 0.05
        for _ in range(40):
            middle = 0.5 * (low + high)
            if self.altitude_after(altitude_m, middle, range_m, scale) < altitude_m:
                low = middle
            else:
                high = middle
        return 0.5 * (low + high)


def halved(rows):
    """Two rows as one."""
    joined = []
    for (above, part), (below, other) in zip(rows[0::2], rows[1::2] + [(rows[-1][0], 0.0)]):
        joined.append((0.5 * (above + below), part + other))
    return joined


class Case:
    def __init__(self, program, name, band, altitude_m, folder):
        self.program, self.band, self.altitude_m = program, band, altitude_m
        air = ROOT / "samples/turboprop4/turboprop4.smat"
        text = json.loads(air.read_text())
        self.sun = text["environment"]
        self.atmosphere = [str((air.parent / file).resolve()) for file in self.sun["atmospheres"]]
        self.sun["atmospheres"] = self.atmosphere
        text.pop("analyses", None)
        # The altitude of the target is that of its origin, at which the sensor is to look levelly:
        # a metre higher the background is 2e-4 off in 3-5 um.
        sample = ROOT / "samples" / name
        text["models"] = [{"name": name, "file": str(sample / f"{name}.flt"),
                           "database": str(sample / f"{name}.sigdb"), "referencePoint_m": [0, 0, 0]}]
        self.project = folder / "level.smat"
        self.project.write_text(json.dumps(text))
        with tempfile.TemporaryDirectory() as folder:
            out = pathlib.Path(folder) / "temperatures.csv"
            run(program, "temperature-profile", *self.atmosphere, "--min", 0, "--max", 20000, "--step", STEP_M,
                "--out", out)
            rows = [row for row in csv.reader(out.open()) if row and not row[0].startswith("#")]
        self.air = Refraction([float(row[1]) for row in rows[1:]])

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

    def silhouette(self, range_m):
        """(radians above the reference point, part of what is hidden) of the rows of a picture."""
        fov_deg = math.degrees(2.0 * math.atan(0.5 * FRAME_M / range_m))
        pictures = []
        for background in (0, 1):
            with tempfile.TemporaryDirectory() as folder:
                out = pathlib.Path(folder) / "picture.csv"
                run(self.program, "image", self.project, "--band", self.band, "--range", range_m, "--altitude",
                    self.altitude_m, "--elevation", 0, "--azimuth", 0, "--fov", fov_deg, "--width", ROWS,
                    "--height", ROWS, "--background", background, "--bounces", 0, "--errors", "off", "--out", out)
                pictures.append([[float(value) for value in row] for row in csv.reader(out.open())
                                 if row and not row[0].startswith("#")])
        hidden = [sum(1.0 + black - white for black, white in zip(*rows)) for rows in zip(*pictures)]
        pitch = FRAME_M / range_m / ROWS
        return [((0.5 * ROWS - 0.5 - y) * pitch, part / sum(hidden)) for y, part in enumerate(hidden)
                if part > 1e-4]

    def seen_over(self, rows, middle_rad):
        """The background by elevation: straight lines between its values about the rows; a node at
        elevation 0, where it bends."""
        low, high = (middle_rad + end(above for above, _ in rows) for end in (min, max))
        low, high = low - 1e-5, high + 1e-5
        nodes = sorted({low + (high - low) * i / 16 for i in range(17)} | ({0.0} if low < 0.0 < high else set()))
        values = [self.background(node) for node in nodes]

        def at(elevation_rad):
            i = min(max(bisect.bisect(nodes, elevation_rad), 1), len(nodes) - 1)
            part = (elevation_rad - nodes[i - 1]) / (nodes[i] - nodes[i - 1])
            return values[i - 1] + part * (values[i] - values[i - 1])
        return at

    def background(self, elevation_rad):
        with tempfile.TemporaryDirectory() as folder:
            out = pathlib.Path(folder) / "background.csv"
            run(self.program, "radiative", *self.atmosphere, "--band", self.band,
                "--quantity", "background", "--sensor-altitude", self.altitude_m,
                f"--los-elevation={math.degrees(elevation_rad):.9f}", "--los-azimuth", 180,
                "--sun-azimuth", self.sun.get("sunAzimuth", 180),
                "--sun-elevation", self.sun.get("sunElevation", 45), "--out", out)
            line = next(line for line in out.read_text().splitlines()
                        if line.startswith("#") and "in_band" in line)
        return float(line.split(":")[-1])


def mean(seen, rows, middle_rad):
    return sum(part * seen(middle_rad + above) for above, part in rows)


def run_all(given, folder):
    bad = 0
    print("target, band um, altitude m, range km: contrast W/sr, off by at elevation 0, off by as it is, by the "
          "witness, beside its background by other wavelengths")
    for name in given.target or TARGETS:
        for band in given.band or ["3-5", "8-12"]:
            for altitude_m in given.altitude or [100.0, 1500.0, 10000.0]:
                case = Case(given.program, name, band, altitude_m, folder)
                level = case.background(0.0)
                for range_m in RANGES_M:
                    if range_m > 2.0 * math.sqrt(2.2 * RADIUS_M * altitude_m):
                        continue  # behind the horizon
                    intensity, contrast = case.sums(range_m)
                    area_m2 = (case.sums(range_m, "--background", "0")[1] -
                               case.sums(range_m, "--background", "1")[1])
                    rows = case.silhouette(range_m)
                    middle = case.air.apparent_elevation(altitude_m, range_m)
                    seen = case.seen_over(rows, middle)
                    ratio = 1.0
                    if TARGETS[name]:
                        one_row = (intensity - case.sums(range_m, "--background-rows", 1)[1]) / area_m2
                        ratio = one_row / seen(middle)
                    behind = ratio * mean(seen, rows, middle)
                    bent = case.air.apparent_elevation(altitude_m, range_m, 0.98)
                    refraction = abs(mean(seen, rows, bent) - mean(seen, rows, middle))
                    if TARGETS[name]: # the ratio holds the direction
                        refraction = abs(mean(seen, rows, bent) / seen(bent) * seen(middle) - behind / ratio)
                    own = area_m2 * (refraction + 0.5 * abs(mean(seen, halved(rows), middle) - behind / ratio))
                    true = intensity - area_m2 * behind
                    flat = intensity - area_m2 * level * ratio
                    off = abs(contrast - true)
                    is_bad = off > max(2e-3 * abs(true), 1e-5 * intensity) + own
                    bad += is_bad
                    print(f"{name:>10} {band:>5} {altitude_m:7.0f} {range_m / 1e3:5.0f}: {true:12.5g} "
                          f"{100.0 * (flat / true - 1.0):+9.2f} % {100.0 * (contrast / true - 1.0):+9.3f} %"
                          f" ±{abs(100.0 * own / true):.3f} %   ({off / intensity:.1e} ± {own / intensity:.1e} "
                          f"of the intensity) {ratio - 1.0:+.1e}{' <-' if is_bad else ''}", flush=True)
    return 1 if bad else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--target", action="append", choices=TARGETS)
    parser.add_argument("--band", action="append")
    parser.add_argument("--altitude", action="append", type=float)
    given = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        return run_all(given, pathlib.Path(folder))


if __name__ == "__main__":
    sys.exit(main())
