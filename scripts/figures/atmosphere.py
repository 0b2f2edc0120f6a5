#!/usr/bin/env python3
"""Draws the figures of docs/atmosphere-accuracy.md from the curves that atmosphere-accuracy wrote,
and puts its tables into that page.

    scripts/figures/atmosphere.py CURVES TABLES.md
"""

import csv
import sys
from html import escape
from math import ceil, floor, log10
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
INK, GREY, PALE = "#2b2f36", "#8a929c", "#d5dae0"
BLUE, RED = "#2468b2", "#c0392b"
WIDTH, HEIGHT = 860, 250
LEFT, RIGHT, TOP, BOTTOM = 64, 16, 30, 42
BEGIN, END = "<!-- tables: begin -->", "<!-- tables: end -->"


def curves(file):
    """Columns of a CSV by name."""
    with open(file, encoding="utf-8") as lines:
        rows = [row for row in csv.reader(line for line in lines if not line.startswith("#"))]
    return {name: [float(row[i]) for row in rows[1:]] for i, name in enumerate(rows[0])}


class Panel:
    """One diagram. x and y are ranges; a logarithmic axis takes the exponents of its ends."""

    def __init__(self, title, x, y, x_name, y_name, logarithmic=False):
        self.title, self.x, self.y = title, x, y
        self.x_name, self.y_name, self.logarithmic = x_name, y_name, logarithmic
        self.lines = []

    def add(self, xs, ys, colour, dashed=False, name=""):
        self.lines.append((xs, ys, colour, dashed, name))

    def place(self, x, y):
        if self.logarithmic:
            x, y = log10(x), log10(y)
        across = (x - self.x[0]) / (self.x[1] - self.x[0])
        up = (min(max(y, self.y[0]), self.y[1]) - self.y[0]) / (self.y[1] - self.y[0])
        return (LEFT + across * (WIDTH - LEFT - RIGHT),
                HEIGHT - BOTTOM - up * (HEIGHT - TOP - BOTTOM))

    def ticks(self, ends):
        if self.logarithmic:
            return [10.0 ** e for e in range(ceil(ends[0]), floor(ends[1]) + 1)]
        step = 10.0 ** floor(log10((ends[1] - ends[0]) / 3))
        step *= next(f for f in (1, 2, 5, 10) if (ends[1] - ends[0]) / (f * step) <= 6)
        return [i * step for i in range(ceil(ends[0] / step - 1e-9), floor(ends[1] / step + 1e-9) + 1)]

    def svg(self, top):
        parts = [f'<g transform="translate(0 {top})">']
        text = '<text x="{:.1f}" y="{:.1f}" fill="{}" text-anchor="{}">{}</text>'
        parts.append(text.format(LEFT, TOP - 12, INK, "start", escape(self.title)))
        low = 10.0 ** self.x[0] if self.logarithmic else self.x[0]
        high = 10.0 ** self.x[1] if self.logarithmic else self.x[1]
        bottom = 10.0 ** self.y[0] if self.logarithmic else self.y[0]
        line = '<path d="M{:.1f} {:.1f}L{:.1f} {:.1f}" stroke="{}"/>'
        for tick in self.ticks(self.y):
            (a, y), (b, _) = self.place(low, tick), self.place(high, tick)
            parts.append(line.format(a, y, b, y, PALE))
            parts.append(text.format(LEFT - 6, y + 4, GREY, "end", f"{tick:g}"))
        for tick in self.ticks(self.x):
            x, y = self.place(tick, bottom)
            parts.append(line.format(x, y, x, y + 4, GREY))
            parts.append(text.format(x, y + 17, GREY, "middle", f"{tick:g}"))
        parts.append(text.format((LEFT + WIDTH - RIGHT) / 2, HEIGHT - 8, INK, "middle",
                                 escape(self.x_name)))
        parts.append(f'<text transform="translate(14 {(TOP + HEIGHT - BOTTOM) / 2:.1f}) rotate(-90)" '
                     f'fill="{INK}" text-anchor="middle">{escape(self.y_name)}</text>')
        names = WIDTH - RIGHT
        for xs, ys, colour, dashed, name in self.lines:
            points = [self.place(x, y) for x, y in zip(xs, ys)
                      if low <= x <= high and (y > 0 or not self.logarithmic)]
            path = "M" + "L".join(f"{x:.1f} {y:.1f}" for x, y in points)
            dash = ' stroke-dasharray="5 3"' if dashed else ""
            parts.append(f'<path d="{path}" fill="none" stroke="{colour}" stroke-width="1.3"{dash}/>')
            if name:
                parts.append(text.format(names, TOP - 12, colour, "end", escape(name)))
                names -= 8 * len(name) + 16
        parts.append("</g>")
        return "\n".join(parts)


def write(name, panels):
    body = "\n".join(panel.svg(i * HEIGHT) for i, panel in enumerate(panels))
    height = HEIGHT * len(panels)
    (ROOT / "docs" / "figures" / name).write_text(
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {height}" '
        f'font-family="DejaVu Sans, sans-serif" font-size="12">\n'
        f'<rect width="{WIDTH}" height="{height}" fill="#ffffff"/>\n{body}\n</svg>\n', encoding="utf-8")


def modtran(folder):
    run = curves(folder / "modtran-pyradi-horizon5kmtropical-fl7.csv")
    nu = run["wavenumber [cm-1]"]
    panels = []
    for low, high in ((700, 1400), (2000, 3400), (4000, 7000), (8000, 14000)):
        panel = Panel(f"5 km at the ground, tropical, rural 23 km, {low} to {high} cm⁻¹", (low, high),
                      (0, 1), "wavenumber, cm⁻¹", "transmittance")
        panel.add(nu, run["transmittance MODTRAN [1]"], RED, name="MODTRAN")
        panel.add(nu, run["transmittance ours [1]"], BLUE, name="ours")
        panels.append(panel)
    write("atmosphere-transmittance.svg", panels)

    panels = []
    for name, title, top in (("MLS23km", "midlatitude summer, rural 23 km", 2.2),
                             ("tropical5km", "tropical, rural 5 km", 2.8),
                             ("SW31km", "subarctic winter, Navy maritime 31 km", 0.4)):
        run = curves(folder / f"modtran-well-fill-{name}-tape7.csv")
        panel = Panel(f"5 km at the ground, {title}", (2000, 3350), (0, top), "wavenumber, cm⁻¹",
                      "path radiance, W/(m² sr µm)")
        nu = run["wavenumber [cm-1]"]
        panel.add(nu, run["path radiance MODTRAN [W m-2 sr-1 um-1]"], RED, name="MODTRAN")
        panel.add(nu, run["path radiance ours [W m-2 sr-1 um-1]"], BLUE, name="ours")
        panels.append(panel)
    write("atmosphere-radiance.svg", panels)


def wideband(folder):
    panels = []
    for band in ("1.5-2.5", "3-5", "4.1-4.5", "8-12"):
        run = curves(folder / f"wideband-{band}.csv")
        points = run["points [1]"]
        panel = Panel(f"{band} µm", (0.6, 2.5), (-3, 2), "number of points", "error, %", True)
        panel.add(points, run["trained RMS [%]"], BLUE, name="trained, RMS")
        panel.add(points, run["trained largest [%]"], BLUE, True, "largest")
        panel.add(points, run["sorted RMS [%]"], RED, name="sorted by absorption, RMS")
        panel.add(points, run["sorted largest [%]"], RED, True, "largest")
        panels.append(panel)
    write("atmosphere-wideband.svg", panels)


def sunset(folder):
    data = curves(folder / "sunset.csv")
    greatest = max(max(ys) for name, ys in data.items() if name.startswith("direct"))
    panel = Panel("Direct sun of 3.5-4.1 µm, W m⁻²: at 10 km, 3 km and at the ground",
                  (-4.0, 1.0), (0.0, 1.05 * greatest), "true elevation of the sun, degrees", "W m⁻²")
    for altitude, colour in ((10000, BLUE), (3000, GREY), (0, RED)):
        panel.add(data["true elevation [deg]"], data[f"direct sun at {altitude} m [W m-2]"], colour)
    write("atmosphere-sunset.svg", [panel])


def insert_tables(file):
    page = ROOT / "docs" / "atmosphere-accuracy.md"
    text = page.read_text(encoding="utf-8")
    before, rest = text.split(BEGIN)
    after = rest.split(END)[1]
    tables = Path(file).read_text(encoding="utf-8").strip()
    page.write_text(f"{before}{BEGIN}\n\n{tables}\n\n{END}{after}", encoding="utf-8")


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    modtran(Path(sys.argv[1]))
    wideband(Path(sys.argv[1]))
    sunset(Path(sys.argv[1]))
    insert_tables(sys.argv[2])
