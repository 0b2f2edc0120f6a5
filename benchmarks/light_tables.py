#!/usr/bin/env python3
"""Makes the table of docs/light.md that holds models of others against a path tracer.

    benchmarks/light_tables.py BENCH_EXCHANGE [--from PRINTED]

Runs `bench_exchange --public` and puts what comes of it between the marks `public` of the page. With --from it
reads what such a run has printed.
"""
import argparse
import pathlib
import re
import subprocess
import sys

PAGE = pathlib.Path(__file__).resolve().parent.parent / "docs/light.md"


def cases_of(printed):
    """What a run has printed, row by row, with names of columns as it has them."""
    rows = [[cell.strip() for cell in line.strip().strip("|").split("|")]
            for line in printed.splitlines() if line.startswith("|")]
    if len(rows) < 3:
        sys.exit("a run of bench_exchange has printed no cases")
    head = rows[0]
    return [dict(zip(head, row)) for row in rows[2:]]


def table(head, rows):
    lines = ["| " + " | ".join(row) + " |" for row in [head, *rows]]
    return "\n".join([lines[0], "|---" * len(head) + "|", *lines[1:]])


def public(cases):
    head = ["model", "triangles", "rms, %", "largest, %", "within the stated error"]

    def row(name, some):
        errors = [float(one["total, %"]) for one in some]
        covered = sum(one["covered"] == "yes" for one in some)
        triangles = re.match(r"(\d+) triangles", some[0]["variant"])
        return [name, f"{int(triangles[1]):,}" if name != "all" and triangles else "",
                f"{(sum(e * e for e in errors) / len(errors)) ** 0.5:.2f}",
                f"{max(map(abs, errors)):.2f}", f"{covered} of {len(some)}"]

    names = list(dict.fromkeys(one["case"] for one in cases))
    rows = [row(name, [one for one in cases if one["case"] == name]) for name in names]
    return table(head, [*rows, row("all", cases)])


def put(page, name, made):
    begin, end = f"<!-- {name}: begin -->", f"<!-- {name}: end -->"
    if page.count(begin) != 1 or page.count(end) != 1:
        sys.exit(f"{PAGE} needs the marks '{begin}' and '{end}' once each")
    before, rest = page.split(begin)
    return before + begin + "\n\n" + made + "\n\n" + end + rest.split(end)[1]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("--from", dest="printed", type=pathlib.Path, metavar="PRINTED")
    given = parser.parse_args()
    if given.printed:
        text = given.printed.read_text(encoding="utf-8")
    else:
        text = subprocess.run([given.program.resolve(), "--public"], check=True, capture_output=True,
                              text=True).stdout
    page = put(PAGE.read_text(encoding="utf-8"), "public", public(cases_of(text)))
    PAGE.write_text(page, encoding="utf-8")


if __name__ == "__main__":
    main()
