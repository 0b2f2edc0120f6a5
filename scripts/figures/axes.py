#!/usr/bin/env python3
"""Draws docs/figures/axes.svg: the axes, angles and polar paths of docs/axes.md.

Every arrow comes from the formulas of that page, not from a drawing hand: points are computed in
three dimensions with the rotations and directions as they are defined, then projected.

    scripts/figures/axes.py [OUTPUT.svg]
"""

import sys
from html import escape
from math import cos, hypot, radians, sin
from pathlib import Path

INK, GREY, PALE = "#2b2f36", "#8a929c", "#d5dae0"
RED, GREEN, BLUE = "#c0392b", "#2a8a4a", "#2468b2"  # x, y, z
ORANGE, VIOLET, TEAL = "#d07a00", "#6b3fa0", "#0d7f86"  # sun, camera, attitude
BODY, BODY_EDGE = "#c3ccd6", "#6d7885"
PANEL_WIDTH, PANEL_HEIGHT = 400, 392


# Vectors and the definitions of the page

def add(a, b):
    return tuple(p + q for p, q in zip(a, b))


def times(s, a):
    return tuple(s * p for p in a)


def direction(azimuth, elevation):
    """(sin A cos E, cos A cos E, sin E), degrees."""
    a, e = radians(azimuth), radians(elevation)
    return (sin(a) * cos(e), cos(a) * cos(e), sin(e))


def yawed(point, angle):
    a = radians(angle)
    x, y, z = point
    return (cos(a) * x - sin(a) * y, sin(a) * x + cos(a) * y, z)


def pitched(point, angle):
    a = radians(angle)
    x, y, z = point
    return (x, cos(a) * y - sin(a) * z, sin(a) * y + cos(a) * z)


def rolled(point, angle):
    a = radians(angle)
    x, y, z = point
    return (cos(a) * x + sin(a) * z, y, -sin(a) * x + cos(a) * z)


def span(start, end, steps=48):
    return [start + (end - start) * i / steps for i in range(steps + 1)]


# The aircraft: half a length is 1; x starboard, y nose, z up

def mirrored(half):
    return half + [(-x, y, z) for x, y, z in reversed(half)]


FUSELAGE = mirrored([(0, 1, 0), (0.05, 0.93, 0), (0.09, 0.78, 0), (0.1, 0.6, 0), (0.1, -0.55, 0),
                     (0.05, -0.98, 0)])
FUSELAGE_SIDE = [(0, 1, 0), (0, 0.9, 0.05), (0, 0.74, 0.08), (0, 0.62, 0.15), (0, 0.45, 0.15),
                 (0, 0.3, 0.1), (0, -0.55, 0.1), (0, -0.98, 0.05), (0, -0.98, 0.01),
                 (0, -0.55, -0.08), (0, 0.7, -0.1), (0, 0.9, -0.06)]
WING = [(0.08, 0.3, 0), (0.98, -0.12, 0), (0.98, -0.3, 0), (0.08, -0.12, 0)]
TAILPLANE = [(0.06, -0.66, 0), (0.4, -0.86, 0), (0.4, -0.97, 0), (0.04, -0.9, 0)]
FIN = [(0, -0.55, 0.09), (0, -0.83, 0.42), (0, -0.97, 0.42), (0, -0.93, 0.06)]


def port_of(polygon):
    return [(-x, y, z) for x, y, z in polygon]


AIRCRAFT = [port_of(WING), WING, port_of(TAILPLANE), TAILPLANE, FUSELAGE, FUSELAGE_SIDE, FIN]


class View:
    """An orthographic look at the world from azimuth and elevation, into a panel."""

    def __init__(self, centre, scale, azimuth, elevation):
        a, e = radians(azimuth), radians(elevation)
        self.centre, self.scale = centre, scale
        self.right = (-cos(a), sin(a), 0)
        self.up = (-sin(a) * sin(e), -cos(a) * sin(e), cos(e))

    def __call__(self, point):
        u = sum(p * q for p, q in zip(point, self.right))
        v = sum(p * q for p, q in zip(point, self.up))
        return (self.centre[0] + self.scale * u, self.centre[1] - self.scale * v)


class Drawing:
    def __init__(self, width, height):
        self.width, self.height, self.items = width, height, []

    def put(self, item):
        self.items.append(item)

    def line(self, points, colour, width=1.6, dash=None):
        text = " ".join(f"{x:.1f},{y:.1f}" for x, y in points)
        dashes = f' stroke-dasharray="{dash}"' if dash else ""
        self.put(f'<polyline points="{text}" fill="none" stroke="{colour}" stroke-width="{width}" '
                 f'stroke-linecap="round" stroke-linejoin="round"{dashes}/>')

    def polygon(self, points, fill, edge=None, width=1.0, opacity=1.0):
        text = " ".join(f"{x:.1f},{y:.1f}" for x, y in points)
        stroke = f'stroke="{edge}" stroke-width="{width}" stroke-linejoin="round"' if edge else ""
        self.put(f'<polygon points="{text}" fill="{fill}" fill-opacity="{opacity}" '
                 f'stroke-opacity="{opacity}" {stroke}/>')

    def dot(self, point, radius, fill, edge="none"):
        self.put(f'<circle cx="{point[0]:.1f}" cy="{point[1]:.1f}" r="{radius}" fill="{fill}" '
                 f'stroke="{edge}" stroke-width="1.4"/>')

    def text(self, point, words, colour=INK, size=14, anchor="start", weight="normal",
             style="normal"):
        self.put(f'<text x="{point[0]:.1f}" y="{point[1]:.1f}" fill="{colour}" font-size="{size}" '
                 f'text-anchor="{anchor}" font-weight="{weight}" font-style="{style}">'
                 f"{escape(words)}</text>")

    def arrow(self, points, colour, width=1.8, head=9):
        """A line with its head at the last point."""
        tip = points[-1]
        # The direction of the last stretch that is as long as the head.
        back = next((p for p in reversed(points) if hypot(p[0] - tip[0], p[1] - tip[1]) >= head),
                    points[0])
        length = hypot(tip[0] - back[0], tip[1] - back[1])
        ux, uy = (tip[0] - back[0]) / length, (tip[1] - back[1]) / length
        base = (tip[0] - head * ux, tip[1] - head * uy)
        kept = [p for p in points[:-1]
                if (p[0] - base[0]) * ux + (p[1] - base[1]) * uy < 0
                or hypot(p[0] - tip[0], p[1] - tip[1]) > 2 * head]
        self.line(kept + [base], colour, width)
        half = 0.42 * head
        self.polygon([tip, (base[0] - half * uy, base[1] + half * ux),
                      (base[0] + half * uy, base[1] - half * ux)], colour)

    def camera(self, position, target, colour=VIOLET):
        """A small camera that looks at the target."""
        length = hypot(target[0] - position[0], target[1] - position[1])
        ux, uy = (target[0] - position[0]) / length, (target[1] - position[1]) / length

        def at(along, across):
            return (position[0] + along * ux - across * uy, position[1] + along * uy + across * ux)

        self.polygon([at(2, -3), at(10, -7), at(10, 7), at(2, 3)], "#ffffff", colour, 1.5)
        self.polygon([at(-12, -6), at(2, -6), at(2, 6), at(-12, 6)], colour, colour, 1.0)

    def svg(self):
        return (f'<svg xmlns="http://www.w3.org/2000/svg" width="{self.width}" '
                f'height="{self.height}" viewBox="0 0 {self.width} {self.height}" '
                'font-family="DejaVu Sans, Helvetica, Arial, sans-serif">\n'
                "<title>Axes, angles and polar paths</title>\n"
                f'<rect width="{self.width}" height="{self.height}" fill="#ffffff"/>\n'
                + "\n".join(self.items) + "\n</svg>\n")


def aircraft(drawing, view, turn=lambda p: p, opacity=1.0, parts=AIRCRAFT):
    for part in parts:
        drawing.polygon([view(turn(p)) for p in part], BODY, BODY_EDGE, 1.0, opacity)


def axis(drawing, view, start, end, colour, words, offset, anchor="start"):
    drawing.arrow([view(start), view(end)], colour, 2.0)
    x, y = view(end)
    drawing.text((x + offset[0], y + offset[1]), words, colour, 14, anchor, "bold")


def panel(drawing, column, row, letter, title, note):
    left, top = column * PANEL_WIDTH, row * PANEL_HEIGHT
    drawing.put(f'<rect x="{left + 6}" y="{top + 6}" width="{PANEL_WIDTH - 12}" '
                f'height="{PANEL_HEIGHT - 12}" rx="6" fill="none" stroke="{PALE}"/>')
    drawing.text((left + 20, top + 32), letter, GREY, 16, weight="bold")
    drawing.text((left + 40, top + 32), title, INK, 16, weight="bold")
    for i, words in enumerate(note):
        drawing.text((left + 20, top + PANEL_HEIGHT - 21 - 18 * (len(note) - 1 - i)), words, INK, 13)
    return left + PANEL_WIDTH / 2, top + PANEL_HEIGHT / 2


BEHIND = (205, 30)  # from where the pictures in perspective are seen: behind and to the left


def world_and_sun(drawing):
    cx, cy = panel(drawing, 0, 0, "a", "World, and the direction to the sun",
                   ["A: azimuth, from north over east", "E: elevation, from the horizon up"])
    view = View((cx - 36, cy + 44), 178, *BEHIND)
    azimuth, elevation = 70, 38
    sun, shadow = direction(azimuth, elevation), direction(azimuth, 0)

    # The horizontal plane, the three axes, the sun with its angles.
    drawing.line([view(times(0.8, direction(a, 0))) for a in span(0, 360, 96)], PALE, 1.3)
    drawing.polygon([view((0, 0, 0))] + [view(times(0.8, direction(azimuth, e)))
                                         for e in span(0, elevation)], ORANGE, opacity=0.12)
    drawing.line([view((0, 0, 0)), view(times(0.8, shadow))], ORANGE, 1.2, "4 4")
    axis(drawing, view, (0, 0, 0), (1.12, 0, 0), RED, "x east", (-20, 22))
    axis(drawing, view, (0, 0, 0), (0, 1.15, 0), GREEN, "y north", (-8, -8), "middle")
    axis(drawing, view, (0, 0, 0), (0, 0, 1.0), BLUE, "z up", (0, -8), "middle")
    drawing.arrow([view(times(0.5, direction(a, 0))) for a in span(0, azimuth)], ORANGE)
    drawing.arrow([view(times(0.72, direction(azimuth, e))) for e in span(0, elevation)], ORANGE)
    drawing.line([view((0, 0, 0)), view(times(1.06, sun))], ORANGE, 1.6)
    x, y = view(times(1.14, sun))
    for a in range(0, 360, 45):
        drawing.line([(x + 13 * cos(radians(a)), y + 13 * sin(radians(a))),
                      (x + 18 * cos(radians(a)), y + 18 * sin(radians(a)))], ORANGE, 2.0)
    drawing.dot((x, y), 9, "#f4b13d", ORANGE)
    x, y = view(times(0.5, direction(28, 0)))
    drawing.text((x + 2, y - 7), "A", ORANGE, 16, "middle", "bold", "italic")
    x, y = view(times(0.72, direction(azimuth, elevation / 2)))
    drawing.text((x + 8, y + 2), "E", ORANGE, 16, "start", "bold", "italic")


def model_and_attitude(drawing):
    cx, cy = panel(drawing, 1, 0, "b", "Model, and its attitude",
                   ["R = Rz(yaw) · Rx(pitch) · Ry(roll)",
                    "yaw: counter-clockwise from above, heading = −yaw",
                    "pitch: nose up; roll: starboard down"])
    view = View((cx - 51, cy + 8), 118, *BEHIND)
    axis(drawing, view, (0, 0, 0), (0, 1.72, 0), GREEN, "y nose", (-4, -8), "middle")
    aircraft(drawing, view)
    axis(drawing, view, (0, 0, 0), (1.66, 0, 0), RED, "x starboard", (-34, 24))
    axis(drawing, view, (0, 0, 0), (0, 0, 1.12), BLUE, "z up", (0, -8), "middle")

    # Positive turns of a point near each axis.
    drawing.arrow([view(add((0, 0, 0.78), yawed((0.26, 0, 0), a))) for a in span(-150, 130)], TEAL)
    drawing.arrow([view(add((1.14, 0, 0), pitched((0, 0.23, 0), a))) for a in span(-120, 140)], TEAL)
    drawing.arrow([view(add((0, 1.34, 0), rolled((0, 0, 0.24), a))) for a in span(-150, 130)], TEAL)
    x, y = view((0, 0, 0.78))
    drawing.text((x + 38, y + 4), "yaw", TEAL, 14, weight="bold")
    x, y = view((1.14, 0, 0.23))
    drawing.text((x + 4, y - 10), "pitch", TEAL, 14, "middle", "bold")
    x, y = view((0, 1.34, 0))
    drawing.text((x - 34, y + 10), "roll", TEAL, 14, "end", "bold")


def camera_about_model(drawing):
    cx, cy = panel(drawing, 2, 0, "c", "Camera about the model",
                   ["c: reference point, d: range, e: elevation",
                    "α: azimuth from the nose, clockwise from above;",
                    "α = 0 looks at the nose, 90° sees starboard"])
    view = View((cx - 24, cy + 22), 124, *BEHIND)
    azimuth, elevation = 62, 32
    eye, foot = direction(azimuth, elevation), direction(azimuth, 0)
    circle = 1.22
    drawing.line([view(times(circle, direction(a, 0))) for a in span(0, 360, 96)], PALE, 1.3)
    for angle, words, offset, anchor in ((0, "α = 0", (-8, -8), "end"),
                                         (90, "90°", (10, -2), "start")):
        point = view(times(circle, direction(angle, 0)))
        drawing.dot(point, 3.2, GREY)
        drawing.text((point[0] + offset[0], point[1] + offset[1]), words, GREY, 13, anchor)
    small = View(view.centre, 74, *BEHIND)
    drawing.line([view((0, 0, 0)), view((0, circle, 0))], GREEN, 1.4, "4 4")
    aircraft(drawing, small)
    drawing.polygon([view((0, 0, 0))] + [view(times(circle, direction(azimuth, e)))
                                         for e in span(0, elevation)], VIOLET, opacity=0.1)
    drawing.line([view((0, 0, 0)), view(times(circle, foot))], VIOLET, 1.2, "4 4")
    drawing.arrow([view(times(0.95, direction(a, 0))) for a in span(0, azimuth)], VIOLET)
    drawing.arrow([view(times(1.0, direction(azimuth, e))) for e in span(0, elevation)], VIOLET)
    drawing.line([view((0, 0, 0)), view(times(1.22, eye))], VIOLET, 1.6)
    drawing.camera(view(times(1.3, eye)), view((0, 0, 0)))
    drawing.dot(view((0, 0, 0)), 4, INK)
    x, y = view((0, 0, 0))
    drawing.text((x - 6, y + 20), "c", INK, 15, "middle", "bold", "italic")
    x, y = view(times(0.95, direction(14, 0)))
    drawing.text((x + 4, y - 8), "α", VIOLET, 16, "middle", "bold", "italic")
    x, y = view(times(1.0, direction(azimuth, elevation / 2)))
    drawing.text((x + 9, y + 5), "e", VIOLET, 16, "start", "bold", "italic")
    x, y = view(times(0.9, eye))
    drawing.text((x - 9, y), "d", VIOLET, 16, "end", "bold", "italic")


def station(drawing, view, point, words, offset, anchor, start=False):
    place = view(point)
    drawing.camera(place, view((0, 0, 0)), VIOLET if start else "#a58cc4")
    for i, line in enumerate(words.split("\n")):
        drawing.text((place[0] + offset[0], place[1] + offset[1] + 17 * i), line,
                     VIOLET if start else INK, 13, anchor, "bold" if start else "normal")


def camera_azimuth(drawing):
    cx, cy = panel(drawing, 0, 1, "d", "Polar: Camera-Azimuth",
                   ["seen from above: clockwise from the nose",
                    "angle = α; the view offset is the camera's elevation e"])
    view = View((cx - 12, cy - 6), 66, 180, 90)
    radius = 1.62
    aircraft(drawing, view)
    drawing.line([view(times(radius, direction(a, 0))) for a in span(0, 360, 96)], PALE, 1.4)
    drawing.arrow([view(times(radius, direction(a, 0))) for a in span(12, 62)], VIOLET, 2.2, 11)
    for angle, words, offset, anchor in ((0, "0° start: nose", (20, -2), "start"),
                                         (90, "90°\nstarboard", (20, -3), "start"),
                                         (180, "180° tail", (20, 12), "start"),
                                         (270, "270°\nport", (-20, -3), "end")):
        station(drawing, view, times(radius, direction(angle, 0)), words, offset, anchor,
                angle == 0)


def camera_elevation(drawing):
    cx, cy = panel(drawing, 1, 1, "e", "Polar: Camera-Elevation",
                   ["seen from port: begins by moving down; in the model's",
                    "frame at d (0, cos φ, −sin φ), up in the picture",
                    "(blue) is (0, sin φ, cos φ)"])
    view = View((cx, cy - 16), 68, 270, 0)
    radius = 1.5

    def path(angle):
        a = radians(angle)
        return (0, radius * cos(a), -radius * sin(a))

    def up(angle):
        a = radians(angle)
        return (0, sin(a), cos(a))

    aircraft(drawing, view, parts=[FUSELAGE_SIDE, FIN])
    drawing.polygon([view((0, 0.3, -0.02)), view((0, -0.12, -0.02)), view((0, -0.3, 0.02)),
                     view((0, -0.12, 0.02))], BODY_EDGE)
    drawing.line([view(path(a)) for a in span(0, 360, 96)], PALE, 1.4)
    drawing.arrow([view(path(a)) for a in span(14, 64)], VIOLET, 2.2, 11)
    for angle, words, offset, anchor in ((0, "0° start\nfront", (-14, 28), "end"),
                                         (90, "90° belly", (20, 16), "start"),
                                         (180, "180°\ntail", (20, -3), "start"),
                                         (270, "270° top", (-20, -6), "end")):
        drawing.arrow([view(path(angle)), view(add(path(angle), times(0.5, up(angle))))], BLUE, 1.3,
                      7)
        station(drawing, view, path(angle), words, offset, anchor, angle == 0)


def model_yaw(drawing):
    cx, cy = panel(drawing, 2, 1, "f", "Polar: Model-Yaw",
                   ["seen from above: the camera stays, pitch = roll = 0",
                    "the model turns counter-clockwise;",
                    "after 90° it shows its starboard side"])
    view = View((cx, cy + 12), 78, 180, 90)
    turned = 55
    aircraft(drawing, view, lambda p: yawed(p, turned), 0.35)
    aircraft(drawing, view)
    drawing.arrow([view(yawed((0, 1.14, 0), a)) for a in span(4, turned)], TEAL, 2.2, 11)
    x, y = view(yawed((0, 1.14, 0), 32))
    drawing.text((x - 8, y - 8), "yaw", TEAL, 14, "end", "bold")
    place = view((0, 1.62, 0))
    drawing.camera(place, view((0, 0, 0)))
    drawing.text((place[0] + 20, place[1] - 4), "0° start", VIOLET, 13, "start", "bold")
    drawing.text((place[0] + 20, place[1] + 13), "nose to the camera", VIOLET, 13, "start", "bold")


def main():
    root = Path(__file__).resolve().parents[2]
    output = Path(sys.argv[1]) if len(sys.argv) > 1 else root / "docs" / "figures" / "axes.svg"
    drawing = Drawing(3 * PANEL_WIDTH, 2 * PANEL_HEIGHT)
    for draw in (world_and_sun, model_and_attitude, camera_about_model, camera_azimuth,
                 camera_elevation, model_yaw):
        draw(drawing)
    output.write_text(drawing.svg(), encoding="utf-8")


if __name__ == "__main__":
    main()
