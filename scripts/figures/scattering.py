#!/usr/bin/env python3
"""Draws the figures of scattering with smat plot, the pictures of the board in fog with smat-batch, and
puts the tables into docs/scattering.md.

    scripts/figures/scattering.py RESULTS BIN
"""

import csv
import math
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PAGE, FIGURES = ROOT / "docs/scattering.md", ROOT / "docs/figures"
PROJECT = ROOT / "samples/fog/fog.smat"
DEPTHS = ["0.25", "0.5", "1", "2", "3", "4", "6", "8"]
# Two figures of four depths each: as many curves as can be told apart.
FIGURE_DEPTHS = {"thin": DEPTHS[:4], "thick": DEPTHS[4:]}
RANGES_M = [50, 100, 200, 300, 400, 600, 800, 1000, 1200]
PICTURED_M = [50, 200, 400, 800]
SIDE_PX, SQUARES = 256, 8
BOARD_OF_FIELD = 0.75 # of the picture's width


def rows_of(file):
    with open(file, encoding="utf-8") as lines:
        return list(csv.DictReader(line for line in lines if not line.startswith("#")))


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|---" * len(head) + "|"]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows]) + "\n"


def put(name, text):
    begin, end = f"<!-- {name}: begin -->", f"<!-- {name}: end -->"
    page = PAGE.read_text(encoding="utf-8")
    before, rest = page.split(begin)
    after = rest.split(end)[1]
    PAGE.write_text(before + begin + "\n" + text + end + after, encoding="utf-8")


def plot(programs, files, quantity, output, *options):
    subprocess.run([programs / "smat", "plot", *map(str, files), "--quantity", quantity, *options,
                    "-o", str(output)], check=True)


def write_curve(file, columns):
    names = list(columns)
    file.parent.mkdir(parents=True, exist_ok=True)
    with open(file, "w", encoding="utf-8") as out:
        out.write(",".join(names) + "\n")
        for row in zip(*columns.values()):
            out.write(",".join(map(repr, row)) + "\n")


def column(rows, name):
    key = next(key for key in rows[0] if key == name or key.startswith(name + " ["))
    return [float(row[key]) for row in rows]


def compare(results, programs):
    theory, traced = (rows_of(results / f"{name}.csv") for name in ("small-angle", "monte-carlo"))
    frequency = column(theory, "frequency")
    lines = []
    for depth in DEPTHS:
        a, b = column(theory, f"mtf_{depth}"), column(traced, f"mtf_{depth}")
        error = column(traced, f"error_mtf_{depth}")
        # Where photons are too few to tell they are no witness.
        told = [i for i in range(len(a)) if error[i] < 0.01 * b[i]]
        worst = max(told, key=lambda i: abs(a[i] / b[i] - 1.0))
        fine = [i for i in range(len(a)) if frequency[i] >= 10.0]
        narrow = max(abs(a[i] - b[i]) / error[i] for i in fine)
        lines.append([depth, f"{a[0]:.4g}", f"{b[0]:.4g} ± {error[0]:.2g}",
                      f"{100 * (a[worst] / b[worst] - 1):.2g} % at {frequency[worst]:.2g}",
                      f"{100 * error[worst] / b[worst]:.2g} %", f"{narrow:.2g}"])
        write_curve(results / "curves" / f"theory, {depth}.csv",
                    {"frequency [rad-1]": frequency[1:], "mtf": a[1:]})
        write_curve(results / "curves" / f"photons, {depth}.csv",
                    {"frequency [rad-1]": frequency[1:], "mtf": b[1:], "error_mtf": error[1:]})
    for name, depths in FIGURE_DEPTHS.items():
        plot(programs, [results / "curves" / f"{kind}, {depth}.csv" for depth in depths
                        for kind in ("theory", "photons")],
             "mtf", FIGURES / f"scattering-mtf-{name}.svg", "--log-x", "--log-y")
    put("theory", table(["τ", "MTF(0), theory", "MTF(0), photons", "largest difference, at cycles/rad",
                         "standard error there", "largest from 10 cycles/rad on, in standard errors"], lines))


def board(programs, results, range_m, scattering):
    """Picture of the board at a range, with a field of view that keeps its size."""
    fov = math.degrees(2 * math.atan(0.5 * SQUARES / BOARD_OF_FIELD / range_m))
    out = results / "board" / f"{range_m}-{'haze' if scattering else 'clear'}.csv"
    subprocess.run([programs / "smat-batch", "image", PROJECT, "--range", str(range_m), "--fov",
                    str(fov), "--set",
                    f"render.scattering={str(scattering).lower()}", "--out", out,
                    "--out", out.with_suffix(".png")], check=True, stdout=subprocess.DEVNULL)
    with open(out, encoding="utf-8") as lines:
        return [[float(cell) for cell in line.split(",")]
                for line in lines if line[:1] in "-0123456789"]


def contrast(picture):
    """(bright - dark) / (bright + dark) between the middles of the inner 6 x 6 squares."""
    square = BOARD_OF_FIELD * SIDE_PX / SQUARES
    sums = [0.0, 0.0]
    for row in range(1, SQUARES - 1):
        for col in range(1, SQUARES - 1):
            x, y = (0.5 * SIDE_PX + (at - 0.5 * SQUARES + 0.5) * square for at in (col, row))
            sums[(row + col) % 2] += picture[int(y)][int(x)]
    return abs(sums[0] - sums[1]) / (sums[0] + sums[1])


def fade(results, programs):
    (results / "board").mkdir(parents=True, exist_ok=True)
    curves = {kind: [contrast(board(programs, results, r, kind == "with scattering"))
                     for r in RANGES_M] for kind in ("with scattering", "without scattering")}
    for kind, values in curves.items():
        write_curve(results / f"{kind}.csv", {"range [m]": RANGES_M, "contrast": values})
    plot(programs, [results / f"{kind}.csv" for kind in curves], "contrast",
         FIGURES / "scattering-contrast.svg", "--log-y")
    put("contrast", table(["range, m", "contrast with scattering", "without"],
                          [[str(r), f"{a:.3g}", f"{b:.3g}"] for r, a, b in
                           zip(RANGES_M, curves["with scattering"], curves["without scattering"])]))
    for range_m in PICTURED_M:
        for kind in ("haze", "clear"):
            (PROJECT.parent / f"{kind}-{range_m}m.png").write_bytes(
                (results / "board" / f"{range_m}-{kind}.png").read_bytes())


def filter_times(results):
    lines = (results / "filter.txt").read_text(encoding="utf-8").splitlines()[2:]
    put("filter", table(["frame, px", "object, px", "support, px", "points of ours", "ours, ms",
                         "report's way, ms", "ratio"], [line.split() for line in lines]))


def main():
    results, programs = Path(sys.argv[1]), Path(sys.argv[2])
    compare(results, programs)
    fade(results, programs)
    filter_times(results)


if __name__ == "__main__":
    main()
