#!/usr/bin/env python3
"""wheel-licences.py WHEEL: puts a list of the libraries that a wheel holds, with the terms of each, into the wheel.

The wheel is one that auditwheel repaired on this Debian system: each library is found again by its name, and its
terms are /usr/share/doc/PACKAGE/copyright of the package it is from. A library of no package is an error. What our
libraries hold of others, headers and a font, is listed, too.
"""

from __future__ import annotations

import base64
import csv
import hashlib
import io
import pathlib
import re
import subprocess
import sys
import tempfile
import zipfile

COMPILED_IN = ("fonts-dejavu-core", "libboost-dev", "libsqlitecpp-dev", "nlohmann-json3-dev")


def packages() -> dict[str, str]:
    """The Debian package of each shared library of this system, by its file name."""
    listed = subprocess.run(["dpkg", "-S", "*.so*"], capture_output=True, text=True, check=True).stdout
    owners: dict[str, str] = {}
    for line in listed.splitlines():
        owner, _, path = line.partition(": ")
        owners.setdefault(pathlib.PurePath(path).name, owner.split(",")[0].split(":")[0])
    return owners


def original(name: str) -> str:
    """The name that a library had before auditwheel put a hash into it."""
    return re.sub(r"-[0-9a-f]{8}(?=\.so|\.|$)", "", name, count=1)


def listing(libraries: dict[str, str]) -> str:
    """Text of packages, their libraries and terms. `libraries` has the package of each."""
    by_package: dict[str, list[str]] = {}
    for library, package in libraries.items():
        by_package.setdefault(package, []).append(library)
    for package in COMPILED_IN:
        by_package[package] = ["compiled into our libraries"]
    table = ["This wheel holds these libraries of others, each under the terms of its own below.", ""]
    terms = []
    for package, names in sorted(by_package.items()):
        version = subprocess.run(
            ["dpkg-query", "-W", "-f", "${source:Package} ${source:Version}", package],
            capture_output=True, text=True, check=True,
        ).stdout
        table.append(f"{version} of Debian: {', '.join(sorted(names))}")
        text = pathlib.Path("/usr/share/doc", package, "copyright").read_text("utf-8", "replace")
        terms.append(f"{'=' * 100}\n{package}\n{'=' * 100}\n\n{text}")
    shared = pathlib.Path("/usr/share/common-licenses")
    mentioned = set(re.findall(rf"{shared}/([A-Za-z0-9.-]*[A-Za-z0-9])", "".join(terms)))
    for name in sorted(name for name in mentioned if (shared / name).is_file()):
        text = (shared / name).read_text("utf-8", "replace")
        terms.append(f"{'=' * 100}\n{shared / name}\n{'=' * 100}\n\n{text}")
    return "\n".join([*table, "", *terms])


def main(wheel: pathlib.Path) -> None:
    owners = packages()
    with zipfile.ZipFile(wheel) as archive:
        names = archive.namelist()
        info = next(name.split("/")[0] for name in names if name.endswith(".dist-info/RECORD"))
        libraries: dict[str, str] = {}
        for name in names:
            base = pathlib.PurePosixPath(name).name
            if ".so" not in base or re.match(r"lib(irsg|smat)|_core\.", base):
                continue
            plain = original(base)
            if plain not in owners:
                sys.exit(f"{wheel}: found {base}, expected a library of a Debian package")
            libraries[plain] = owners[plain]
        text = listing(libraries).encode()
        target = f"{info}/licenses/LICENSES-of-libraries.txt"
        digest = base64.urlsafe_b64encode(hashlib.sha256(text).digest()).rstrip(b"=").decode()
        with tempfile.NamedTemporaryFile(dir=wheel.parent, suffix=".whl", delete=False) as temporary:
            with zipfile.ZipFile(temporary, "w", zipfile.ZIP_DEFLATED) as changed:
                for item in archive.infolist():
                    if item.filename == f"{info}/RECORD":
                        rows = [row for row in csv.reader(io.StringIO(archive.read(item).decode())) if row[0] != target]
                        rows.append([target, f"sha256={digest}", str(len(text))])
                        written = io.StringIO()
                        csv.writer(written, lineterminator="\n").writerows(rows)
                        changed.writestr(item, written.getvalue())
                    elif item.filename != target:
                        changed.writestr(item, archive.read(item))
                changed.writestr(target, text)
    pathlib.Path(temporary.name).chmod(0o644)
    pathlib.Path(temporary.name).replace(wheel)
    print(f"{wheel}: {len(libraries)} libraries of {len(set(libraries.values()))} packages listed")


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit("wheel-licences.py: found no wheel, expected one")
    main(pathlib.Path(sys.argv[1]))
