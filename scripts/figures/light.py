#!/usr/bin/env python3
"""Measures what shadows of the sun and light between surfaces change of the intensity of the samples, and
puts the table into docs/light.md.

    scripts/figures/light.py SMAT-BATCH
"""

import csv
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PAGE = ROOT / "docs/light.md"
SAMPLES = ["turboprop4", "heron", "ship", "corvette"]
BANDS_UM = ["3-5", "8-12"]
STEP_DEG = 45
SHOWN_DEG = range(0, 360, 45)
# What is switched on, and what that is compared with.
WAYS = {
    "neither": ["--shadows", "off", "--bounces", "0"],
    "shadows": ["--shadows", "point", "--bounces", "0"],
    "all": ["--shadows", "point", "--bounces", "converged"],
}
CHANGES = {"shadows": ("shadows", "neither"), "between surfaces": ("all", "shadows")}


def intensities(program, sample, way, folder):
    """By band: W sr-1 for each aspect."""
    file = Path(folder) / "polar.csv"
    subprocess.run(
        [program, "polar", ROOT / f"samples/{sample}/{sample}.smat", "--band", ",".join(BANDS_UM),
         "--step", str(STEP_DEG), "--fov", "30", "--set", "environment.terrain=",
         "--out", file, *WAYS[way]],
        check=True, stdout=subprocess.DEVNULL)
    with open(file, encoding="utf-8") as lines:
        rows = list(csv.DictReader(line for line in lines if not line.startswith("#")))
    return {band: [float(row[f"intensity@{band}um [W sr-1]"]) for row in rows] for band in BANDS_UM}


def percent(value):
    return f"{100 * value:+.1f}".replace("-", "−")


def main():
    program = Path(sys.argv[1]).resolve()
    head = ["sample", "band, µm", "what", *[f"{angle}°" for angle in SHOWN_DEG], "mean", "largest"]
    lines = ["| " + " | ".join(head) + " |", "|---" * len(head) + "|"]
    with tempfile.TemporaryDirectory() as folder:
        for sample in SAMPLES:
            found = {way: intensities(program, sample, way, folder) for way in WAYS}
            for band in BANDS_UM:
                for what, (new, old) in CHANGES.items():
                    changes = [a / b - 1 for a, b in zip(found[new][band], found[old][band])]
                    worst = max(range(len(changes)), key=lambda i: abs(changes[i]))
                    shown = [percent(changes[angle // STEP_DEG]) for angle in SHOWN_DEG]
                    row = [sample, band.replace("-", "–"), what, *shown,
                           percent(sum(changes) / len(changes)),
                           f"{percent(changes[worst])} at {worst * STEP_DEG}°"]
                    lines.append("| " + " | ".join(row) + " |")
    begin, end = "<!-- changes: begin -->", "<!-- changes: end -->"
    page = PAGE.read_text(encoding="utf-8")
    before, rest = page.split(begin)
    after = rest.split(end)[1]
    PAGE.write_text(before + begin + "\n\n" + "\n".join(lines) + "\n\n" + end + after, encoding="utf-8")


main()
