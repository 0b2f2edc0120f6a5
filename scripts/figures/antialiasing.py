#!/usr/bin/env python3
"""Draws the figures of antialiasing with smat plot from what antialiasing-study wrote, and puts its
tables into docs/accuracy-sampling.md.

    scripts/figures/antialiasing.py RESULTS SMAT
"""

import csv
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PAGE, FIGURES = ROOT / "docs/accuracy-sampling.md", ROOT / "docs/figures"
BEGIN, END = "<!-- antialiasing: begin -->", "<!-- antialiasing: end -->"
DRAWN_BODIES = {"sphere": "sphere", "L turned by 7 deg": "plate", "plane at 30 deg": "plane"}
# A figure holds eight curves that can be told apart; the tables have all methods.
DRAWN = ["supersampling 0", "supersampling 1", "supersampling 2", "aligned 3", "aligned 4",
         "aligned 5", "sills 4", "sills 5"]
TIMED = DRAWN[:3] + ["supersampling 2 whole frame"] + DRAWN[3:7]
SIDES = {3: 128, 4: 256, 5: 512}


def rows_of(file):
    with open(file, encoding="utf-8") as lines:
        return list(csv.DictReader(lines))


def method_of(row):
    whole = " whole frame" if row.get("whole_frame") == "1" else ""
    return f"{row['strategy']} {row['mode']}{whole}"


def title(method):
    """As a table names it."""
    strategy, mode, *rest = method.split(" ", 2)
    size = f"{1 << int(mode)} an axis" if int(mode) < 3 else f"{SIDES[int(mode)]}"
    return f"{mode}: {strategy} {size}" + (", whole frame" if rest else "")


def ordered(values):
    return list(dict.fromkeys(values))


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|---" * len(head) + "|"]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows]) + "\n"


def percent(value):
    return f"{value:.2g}" if value < 100 else f"{value:.0f}"


def worst_table(errors):
    """Over all sizes, RMS / largest error."""
    bodies = ordered(row["body"] for row in errors)
    result = []
    for method in ordered(method_of(row) for row in errors):
        cells = []
        for body in bodies:
            mine = [r for r in errors if r["body"] == body and method_of(r) == method]
            rms = max(float(r["rms_error [%]"]) for r in mine)
            largest = max(float(r["largest_error [%]"]) for r in mine)
            cells.append(f"{percent(rms)} / {percent(largest)}")
        result.append([title(method)] + cells)
    return table(["mode, RMS / largest error over all sizes, %"] + bodies, result)


def by_size(rows, body, quantity, text):
    mine = [row for row in rows if row["body"] == body]
    sizes = ordered(row["size [px]"] for row in mine)
    cells = {(method_of(row), row["size [px]"]): float(row[quantity]) for row in mine}
    methods = ordered(method_of(row) for row in mine)
    return table([f"{body}, pixels"] + [f"{float(size):.2g}" if float(size) < 100 else "101"
                                        for size in sizes],
                 [[title(m)] + [text(cells[m, size]) for size in sizes] for m in methods])


def largest_rise(times):
    """By method and body: how much longer than at any larger size a frame takes, at most."""
    bodies = ordered(row["body"] for row in times)
    result = []
    for method in ordered(method_of(row) for row in times):
        cells = []
        for body in bodies:
            rise, quickest = 0.0, float("inf")
            for row in times: # sizes descend
                if row["body"] == body and method_of(row) == method:
                    now = float(row["time [ms]"])
                    rise, quickest = max(rise, now / quickest - 1.0), min(quickest, now)
            cells.append(f"{100 * rise:.0f}")
        result.append([title(method)] + cells)
    return table(["largest rise of the time as the body shrinks, %"] + bodies, result)


def against_supersampling(times):
    """Time of mode 4 over that of mode 2, the whole frame and the object's window."""
    bodies = ordered(row["body"] for row in times)
    result = []
    for name, other in (("the whole frame", "supersampling 2 whole frame"),
                        ("the object's window", "supersampling 2")):
        cells = []
        for body in bodies:
            mine = {method_of(r): {} for r in times}
            for row in times:
                if row["body"] == body:
                    mine[method_of(row)][row["size [px]"]] = float(row["time [ms]"])
            ratios = [mine["aligned 4"][size] / mine[other][size] for size in mine[other]]
            cells.append(f"{min(ratios):.2g} to {max(ratios):.2g}")
        result.append([name] + cells)
    return table(["time of mode 4 in terms of mode 2 over"] + bodies, result)


def parts_table(parts):
    result = []
    for way in ordered(row["way"] for row in parts):
        mine = [row for row in parts if row["way"] == way]
        errors = [float(row["error [%]"]) for row in mine]
        rms = (sum(error * error for error in errors) / len(errors)) ** 0.5
        time = sum(float(row["time [ms]"]) for row in mine) / len(mine)
        result.append([way, percent(rms), percent(max(map(abs, errors))), f"{time:.1f}"])
    return table(["four-engined aircraft, 200 to 12.5 pixels", "RMS, %", "largest, %",
                  "ms a frame"], result)


def angles_sentence(angles):
    errors = [float(row["rms_error [%]"]) for row in angles]
    above = [row for row in angles if float(row["rms_error [%]"]) > 0.1]
    worst = max(angles, key=lambda row: float(row["rms_error [%]"]))
    return (f"The L turned in steps of half a degree, mode 4: RMS above 0.1 % in {len(above)} of "
            f"{len(errors)} cases, at worst {percent(float(worst['rms_error [%]']))} % "
            f"({worst['angle [deg]']}° at {worst['size [px]']} pixels).\n")


def plot(smat, files, quantity, output, *options):
    subprocess.run([smat, "plot", *map(str, files), "--quantity", quantity, *options,
                    "-o", str(FIGURES / output)], check=True)


def curves_of(errors, body, folder):
    """A CSV for each method, in the form that smat plot takes."""
    folder.mkdir(parents=True, exist_ok=True)
    files = []
    for method in DRAWN:
        files.append(folder / f"{method}.csv")
        with open(files[-1], "w", encoding="utf-8") as file:
            file.write("size [px],rms_error [%]\n")
            for row in errors:
                if row["body"] == body and method_of(row) == method:
                    file.write(f"{row['size [px]']},{row['rms_error [%]']}\n")
    return files


def main():
    results, smat = Path(sys.argv[1]), sys.argv[2]
    errors, times = rows_of(results / "errors.csv"), rows_of(results / "times.csv")
    parts, angles = rows_of(results / "parts.csv"), rows_of(results / "angles.csv")

    for body, name in DRAWN_BODIES.items():
        plot(smat, curves_of(errors, body, results / "curves" / name), "rms_error",
             f"antialiasing-error-{name}.svg", "--log-x", "--log-y")
    plot(smat, [results / "time" / f"{method}.csv" for method in TIMED], "time_per_frame",
         "antialiasing-time.svg", "--log-x", "--log-y")
    for name, methods in {"": ["supersampling 0", "supersampling 1", "supersampling 2",
                               "aligned 4"],
                          "-sills": ["sills 3", "sills 4", "sills 5", "aligned 4"]}.items():
        plot(smat, [results / "intensity" / f"{method}.csv" for method in methods],
             "contrast_intensity", f"antialiasing-intensity{name}.svg", "--log-x")

    number = lambda ms: f"{ms:.2f}" if ms < 10 else f"{ms:.0f}"
    tables = "\n".join([worst_table(errors),
                        against_supersampling(times),
                        largest_rise(times),
                        parts_table(parts),
                        angles_sentence(angles),
                        "RMS error, %:\n",
                        *(by_size(errors, body, "rms_error [%]", percent)
                          for body in ordered(row["body"] for row in errors)),
                        "Median time of a frame of 640 × 512 pixels, ms:\n",
                        *(by_size(times, body, "time [ms]", number)
                          for body in ("sphere", "plane at 30 deg"))])
    page = PAGE.read_text(encoding="utf-8")
    before, rest = page.split(BEGIN)
    PAGE.write_text(before + BEGIN + "\n\n" + tables + "\n" + END + rest.split(END)[1],
                    encoding="utf-8")


if __name__ == "__main__":
    main()
