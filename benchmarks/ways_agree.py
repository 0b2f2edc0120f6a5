#!/usr/bin/env python3
"""Image, its pixels, simulate and sweep of the same views, side by side.

    benchmarks/ways_agree.py SMAT_BATCH [--quick] [--air haze --air computed]

Of two samples, seen from several azimuths and elevations, each band by itself and two in one go,
through four airs, each in the spectral mode and in ck, it takes intensity and contrast from `image`,
from `simulate` and from `polar`, and the contrast once more from the pixels of the image, and prints the largest differences: of the intensity as a part of
it, of the contrast as a part of the intensity. Leaves with 1 where one is not at most 1e-5.

The airs: `haze` is homogeneous air of a table, `computed` an AtmosphereSmart, `family` a table of runs
over altitudes and ranges, which this script makes up in MODTRAN's CSV (absorbing air in lines, colder
with altitude) and has imported, and `modtran` a run of MODTRAN itself, one horizontal path at sea
level, where the shared material is (../shared, or the folder that SMAT_SHARED names). Runs have
neither sun nor ambient reflection nor a sky: through them these are off.

`every_way.py` holds one view by all other analyses and the library against the image.

An image of several bands is a file each, drawn for that band alone: it is compared with sweeps of
one band. `simulate` in several bands is compared with the sweep in the same bands.
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
SHARED = pathlib.Path(os.environ.get("SMAT_SHARED", ROOT.parent / "shared"))
MODTRAN = SHARED / "data/atmosphere/modtran/well-fill/MLS23km/tape7"
BANDS = ["3-5", "8-12", "4.2-4.5", "4.4-4.6"]
SEVERAL = "3-5,8-12"
# The run of MODTRAN ends at 3330 cm-1.
BANDS_OF_MODTRAN, SEVERAL_OF_MODTRAN = ["3.1-4.9", "4.2-4.5", "4.4-4.6"], "3.1-4.9,4.2-4.5"
FILES = {"haze": ROOT / "resources/atmospheres/haze-23km.csv",
         "computed": ROOT / "resources/atmospheres/midlatitude-summer-rural-23km.xml"}
AIRS = [*FILES, "family", "modtran"]
SAMPLES = {"turboprop4": {"elevations": [0, -20, 30], "range": 900.0, "altitude": 1500.0,
                          "power": 0.7, "mach": 0.4, "fov": 3.0},
           "ship": {"elevations": [8, 0, 30], "range": 1500.0, "altitude": 10.0,
                    "power": 0.0, "mach": 0.0, "fov": 8.0}}
AZIMUTHS = [0, 60, 120, 180]
QUANTITIES = ["intensity", "contrast_intensity"]
LARGEST = 1e-5


def run(program, *arguments):
    done = subprocess.run([program, *map(str, arguments)], capture_output=True, text=True)
    if done.returncode:
        sys.exit(f"{' '.join(map(str, arguments))}:\n{done.stdout}{done.stderr}")
    return done.stdout


def planck_W_cm2_sr_per_cm(wavenumber_per_cm, temperature_K):
    return (1.191042972e-12 * wavenumber_per_cm ** 3 /
            math.expm1(1.438776877 * wavenumber_per_cm / temperature_K))


def absorption_per_km(wavenumber_per_cm):
    """Of lines beside windows, and of carbon dioxide, in which the air is opaque."""
    lines = 0.03 + 2.0 * math.sin(0.37 * wavenumber_per_cm) ** 16
    return lines + 40.0 * math.exp(-((wavenumber_per_cm - 2320.0) / 50.0) ** 2)


def run_of(sensor_m, target_m, range_m):
    """A run of MODTRAN as CSV: absorbing air whose density falls by e in 8 km, at one temperature."""
    mean_m = 0.5 * (sensor_m + target_m)
    temperature_K = 288.15 - 0.0065 * mean_m
    column_km = 1e-3 * range_m * math.exp(-mean_m / 8000.0)
    level = sensor_m == target_m
    lines = [f"# ITYPE: {1 if level else 2}", "# IEMSCT: 1", f"# H1: {1e-3 * sensor_m:.9g}",
             f"# H2: {1e-3 * target_m:.9g}", f"# RANGE: {1e-3 * range_m:.9g}"]
    if not level:
        zenith_rad = math.acos((target_m - sensor_m) / range_m)
        lines.append(f"# ANGLE: {math.degrees(zenith_rad):.9g}")
    lines.append("freq,tot_trans,pth_thrml,total_rad")
    # From end to end of the bands, and hardly anything between them.
    for wavenumber_per_cm in [*range(820, 1261, 4), *range(1300, 1990, 50), *range(1990, 3351, 4)]:
        transmittance = math.exp(-absorption_per_km(wavenumber_per_cm) * column_km)
        emitted = (1.0 - transmittance) * planck_W_cm2_sr_per_cm(wavenumber_per_cm, temperature_K)
        lines.append(f"{wavenumber_per_cm},{transmittance:.9g},{emitted:.9g},{emitted:.9g}")
    return "\n".join(lines) + "\n"


def family(program, folder, sample):
    """A table of runs that surrounds every path of a sample."""
    altitude_m, range_m = sample["altitude"], sample["range"]
    rises_m = [range_m * math.sin(math.radians(elevation)) for elevation in sample["elevations"]]
    targets_m = sorted({max(0.0, altitude_m - 100.0), altitude_m, altitude_m + 100.0})
    sensors_m = sorted({max(0.0, altitude_m + 1.1 * min(rises_m)), altitude_m,
                        altitude_m + 0.5 * max(rises_m), altitude_m + 1.1 * max(rises_m)})
    files = []
    for sensor_m in sensors_m:
        for target_m in targets_m:
            for part in [0.8, 1.2]:
                files.append(folder / f"run{len(files)}.csv")
                files[-1].write_text(run_of(sensor_m, target_m, part * range_m))
    table = folder / "family.smatatm"
    run(program, "atmosphere", "import", *files, "--out", table)
    return table


class Air:
    """One of the airs for one sample, in one mode."""

    def __init__(self, name, file, mode):
        self.name = name
        self.mode = mode
        self.environment = {"atmospheres": [str(file)], "sunAzimuth": 135, "sunElevation": 40}
        self.render = {}
        if name not in FILES:
            # A background of 1 W m-2 sr-1, so that the contrast is not the intensity.
            self.render = {"sun": "off", "ambientReflection": "off", "background": 1}


def settings(sample, air):
    return {"environment": air.environment, "render": air.render,
            "sensor": {"fov": sample["fov"], "mode": air.mode, "width": 320, "height": 256}}


def model(name):
    folder = ROOT / "samples" / name
    return {"database": str(folder / f"{name}.sigdb"), "referencePoint_m": [0, 0, 0], "name": name}


def project(folder, name, sample, air):
    text = settings(sample, air)
    text |= {"version": 1,
             "models": [model(name) | {"file": str(ROOT / "samples" / name / f"{name}.flt")}],
             "camera": {"range": sample["range"]},
             "target": {"altitude": sample["altitude"]},
             "state": {"power": sample["power"], "mach": sample["mach"]}}
    file = folder / "project.smat"
    file.write_text(json.dumps(text))
    return file


def scenario(folder, name, sample, air, elevation, bands):
    text = settings(sample, air)
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
            {"name": f"from{azimuth}", "track": name, "sensor": {"band": bands},
             "position_m": [distance * math.sin(a) * math.cos(e),
                            distance * math.cos(a) * math.cos(e),
                            sample["altitude"] + distance * math.sin(e)]})
    file = folder / "scenario.json"
    file.write_text(json.dumps(text))
    return file


def table(file):
    with open(file, encoding="utf-8") as lines:
        rows = list(csv.reader(line for line in lines if not line.startswith("#")))
    numbers = [i for i, key in enumerate(rows[0]) if key != "warning"]
    return [{rows[0][i]: float(row[i]) for i in numbers} for row in rows[1:]]


def at(band, bands):
    """What stands behind names of columns and files where several bands are asked for."""
    return f"@{band}um" if "," in bands else ""


def swept(program, folder, file, elevation, bands):
    """{(azimuth, band): {"intensity": ..., "contrast_intensity": ...}} of polar."""
    # Hot parts and with them windows follow the bands that are asked for together.
    run(program, "polar", file, "--offset", elevation, "--step", 60, "--band", bands,
        "--out", folder / "polar.csv")
    return {(row["angle [deg]"], band): {quantity: row[f"{quantity}{at(band, bands)} [W sr-1]"]
                                         for quantity in QUANTITIES}
            for row in table(folder / "polar.csv") for band in bands.split(",")}


def simulated(program, folder, name, file, bands):
    """The same of simulate."""
    run(program, "simulate", file, "--out", folder / "sim")
    found = {}
    for azimuth in AZIMUTHS:
        row = table(folder / "sim" / f"from{azimuth}.csv")[0]
        for band in bands.split(","):
            found[azimuth, band] = {
                quantity: row[f"{name}.{quantity}{at(band, bands)} [W sr-1]"]
                for quantity in QUANTITIES}
    return found


def seen(program, folder, file, elevation, bands):
    """The same of images."""
    found = {}
    for azimuth in AZIMUTHS:
        run(program, "image", file, "--elevation", elevation, "--azimuth", azimuth, "--band", bands,
            "--out", folder / "image.json")
        for band in bands.split(","):
            written = json.loads((folder / f"image{at(band, bands)}.json").read_text())
            values = {column["name"]: column["values"][0] for column in written["columns"]}
            found[azimuth, band] = {quantity: values[quantity] for quantity in QUANTITIES}
    return found


def summed(program, folder, file, elevation, band):
    """The contrast of one band as the sum over the pixels of images."""
    found = {}
    image = folder / "image.exr"
    for azimuth in AZIMUTHS:
        run(program, "image", file, f"--elevation={elevation}", "--azimuth", azimuth, "--band", band,
            "--out", image)
        compared = json.loads(run(program, "compare", image, image, "--json"))
        found[azimuth, band] = {
            "contrast_intensity": compared["comparisons"][0]["contrast_intensity_a"]}
    return found


class Worst:
    """The largest differences by what was compared."""

    def __init__(self):
        self.found = {}

    def add(self, key, truth, values, elevation):
        for (azimuth, band), of_view in values.items():
            expected = truth[azimuth, band]
            for quantity in of_view:
                error = abs(of_view[quantity] - expected[quantity]) / expected["intensity"]
                found = (*key, quantity)
                # What is no number is the largest of all.
                self.found[found] = max(self.found.get(found, (0.0, "")),
                                        (math.inf if math.isnan(error) else error,
                                         f"{elevation} deg, {azimuth} deg, {band} um"))

    def agrees(self):
        return bool(self.found) and all(error <= LARGEST for error, _ in self.found.values())


def compare(program, name, sample, air, elevations, bands, several, worst):
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(temporary)
        file = project(folder, name, sample, air)

        def by_simulate(elevation, asked):
            return simulated(program, folder, name,
                             scenario(folder, name, sample, air, elevation, asked), asked)

        for elevation in elevations:
            alone = {}
            for band in bands:
                sweep = swept(program, folder, file, elevation, band)
                alone |= sweep
                key = (name, air.name, air.mode, "one band")
                worst.add((*key, "image"), sweep, seen(program, folder, file, elevation, band),
                          elevation)
                worst.add((*key, "pixels"), sweep, summed(program, folder, file, elevation, band),
                          elevation)
                worst.add((*key, "simulate"), sweep, by_simulate(elevation, band), elevation)
            key = (name, air.name, air.mode, "two bands")
            worst.add((*key, "image"), alone, seen(program, folder, file, elevation, several),
                      elevation)
            worst.add((*key, "simulate"), swept(program, folder, file, elevation, several),
                      by_simulate(elevation, several), elevation)


def views_of(name, air, program, folder, quick):
    """The sample as air needs it, the file of the air, elevations, bands and several of them."""
    sample = SAMPLES[name]
    if air == "modtran":
        # Its only path lies at 0 m.
        sample = sample | {"altitude": 0.0, "elevations": [0]}
    elevations = sample["elevations"][:1] if quick else sample["elevations"]
    bands, several = BANDS[:2] if quick else BANDS, SEVERAL
    if air == "modtran":
        bands, several = BANDS_OF_MODTRAN[:2] if quick else BANDS_OF_MODTRAN, SEVERAL_OF_MODTRAN
        return sample, MODTRAN, elevations, bands, several
    file = FILES[air] if air in FILES else family(program, folder, sample)
    return sample, file, elevations, bands, several


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("--quick", action="store_true", help="one elevation, two bands")
    parser.add_argument("--air", action="append", choices=AIRS,
                        help="only this one; may be given more than once")
    options = parser.parse_args()
    program = options.program.resolve()
    airs = options.air or AIRS
    if "modtran" in airs and not MODTRAN.is_file():
        print(f"left out: modtran, as there is no {MODTRAN}\n")
        airs = [air for air in airs if air != "modtran"]
    worst = Worst()
    for name in SAMPLES:
        for air in airs:
            with tempfile.TemporaryDirectory() as folder:
                sample, file, elevations, bands, several = views_of(
                    name, air, program, pathlib.Path(folder), options.quick)
                for mode in ["spectral", "ck"]:
                    compare(program, name, sample, Air(air, file, mode), elevations, bands, several,
                            worst)
    print("| sample | air | mode | asked for | against the sweep | quantity | largest difference "
          "| at |")
    print("|---|---|---|---|---|---|---|---|")
    for key, (error, where) in worst.found.items():
        print(f"| {' | '.join(key)} | {error:.2g} | {where} |")
    return 0 if worst.agrees() else 1


if __name__ == "__main__":
    sys.exit(main())
