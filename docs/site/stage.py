"""Fills the source folder of the site: pages of the repository with what they link to, and pages made from programs.

    stage.py PROGRAM FOLDER REFERENCE [MODULE]

PROGRAM is smat-batch, FOLDER is filled, REFERENCE is the C++ reference in HTML (may be missing), MODULE the folder that the
Python module is imported from. Ends with 1 and says why where a page has no place.
"""

import json
import os
import re
import shutil
import subprocess
import sys
import tomllib
from pathlib import Path

root = Path(__file__).resolve().parents[2]
link = re.compile(r"(!?\[(?:[^\[\]]|\[[^\]]*\])*\])\(([^()\s]+)\)")
fence = re.compile(r"^(```|~~~)")


def tracked():
    listed = subprocess.run(["git", "-C", root, "ls-files"], check=True, capture_output=True, text=True)
    return set(listed.stdout.split("\n")) - {""}


class Stage:
    def __init__(self, folder):
        self.folder = folder
        self.files = tracked()
        self.written = set()
        self.plan = tomllib.loads((root / "docs/site/pages.toml").read_text())

    def pages(self):
        return [page for chapter in self.plan["chapter"] for page in chapter["pages"]]

    def write(self, name, text):
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
        self.written.add(name)

    def copy(self, name):
        if name not in self.written:
            (self.folder / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(root / name, self.folder / name)
            self.written.add(name)

    def linked(self, page, match, todo):
        """The link as the site has it; what it leads to comes along."""
        text, target = match.groups()
        if re.match(r"[a-z]+:|#", target):
            return match.group(0)
        path, _, anchor = target.partition("#")
        name = (root / page).parent.joinpath(path).resolve()
        if not name.is_relative_to(root):
            return text.lstrip("!")[1:-1]
        name = name.relative_to(root).as_posix()
        if f"{name}/README.md" in self.files:
            return self.linked(page, re.match(link, f"{text}({path}/README.md)"), todo)
        if name not in self.files:
            return text.lstrip("!")[1:-1]
        if name.endswith(".md"):
            todo.append(name)
        else:
            self.copy(name)
        return f"{text}({path}{'#' + anchor if anchor else ''})"

    def add_page(self, name, todo):
        if name in self.written:
            return
        lines, inside = [], False
        for line in (root / name).read_text().split("\n"):
            inside ^= bool(fence.match(line))
            lines.append(line if inside else link.sub(lambda m: self.linked(name, m, todo), line))
        terms = [term for term, page in self.plan["terms"].items() if page + ".md" == name]
        head = "".join(f"```{{index}} ! {term}\n```\n\n" for term in terms)
        orphan = "" if name[:-3] in self.pages() else "---\norphan: true\n---\n\n"
        self.write(name, orphan + head + "\n".join(lines))


def help_of(program, words):
    ran = subprocess.run([program, *words, "--help"], capture_output=True, text=True, check=True)
    return ran.stdout.rstrip()


def commands_in(text):
    """The commands that a help lists: indented names below a heading of commands."""
    names, inside = [], False
    for line in text.split("\n"):
        if re.match(r"^[A-Z].*:$", line) or re.match(r"^\S", line):
            inside = "ommand" in line
        elif inside and (found := re.match(r"^  ([a-z][a-z0-9-]*)\s{2,}\S", line)):
            names.append(found.group(1))
    return names


def command_line(program):
    page = ["# Command line", "", "As `smat-batch --help` and the help of each command print it.", ""]

    def add(words, depth):
        text = help_of(program, words)
        title = " ".join(["smat-batch", *words])
        page.extend([f"{'#' * depth} {title}", "", "```text", text, "```", ""])
        for name in commands_in(text):
            add([*words, name], min(depth + 1, 4))

    add([], 2)
    return "\n".join(page)


def gallery(stage):
    page = ["# Gallery", "", "The samples that come with the program, as the window shows them at first.", ""]
    cards = []
    for picture in sorted(f for f in stage.files if re.fullmatch(r"samples/[^/]+/picture\.png", f)):
        readme = picture.replace("picture.png", "README.md")
        title = (root / readme).read_text().split("\n", 1)[0].lstrip("# ")
        cards += [f":::{{grid-item-card}} {title}", f":link: {readme[:-3]}", ":link-type: doc", f":img-top: {picture}", ":::", ""]
        stage.copy(picture)
    page += ["::::{grid} 1 2 2 3", ":gutter: 3", "", *cards, "::::", ""]
    page += ["## In Python", "", "Each script runs as it stands, and is a test.", ""]
    for script in sorted(f for f in stage.files if re.fullmatch(r"python/examples/[a-z_]+\.py", f)):
        stage.copy(script)
        name = Path(script).stem.replace("_", " ")
        page += [f"### {name[0].upper()}{name[1:]}", "", f"```{{literalinclude}} {script}", ":language: python", "```", ""]
    return "\n".join(page)


def python_reference(module):
    if module is None:
        return "# Python module\n\nThis site was made without the module; `help(smat)` describes it.\n"
    sys.path.insert(0, module)
    import smat

    page = ["# Python module", "", "[How it is used](../docs/python.md).", ""]
    kinds = {"Classes": [], "Functions": [], "Errors": []}
    for name in sorted(smat.__all__):
        thing = getattr(smat, name)
        if isinstance(thing, type):
            kinds["Errors" if issubclass(thing, BaseException) else "Classes"].append(name)
        elif callable(thing):
            kinds["Functions"].append(name)
    for title, names in kinds.items():
        page += [f"## {title}", ""]
        for name in names:
            directive = "autofunction" if title == "Functions" else "autoclass"
            page += [f"### {name}", "", "```{eval-rst}", f".. {directive}:: smat.{name}"]
            page += [] if title == "Functions" else ["   :members:"]
            page += ["```", ""]
    return "\n".join(page)


def index(stage):
    picture = "samples/heron/picture.png"
    stage.copy(picture)
    page = ["# SMAT", "", "Infrared signatures and scenes: a workbench, a command line, a library and a Python module.", ""]
    page += [f"![A patrol aircraft in 3 to 5 µm]({picture})", ""]
    for chapter in stage.plan["chapter"]:
        page += ["```{toctree}", f":caption: {chapter['title']}", ":hidden:", ":maxdepth: 1", ""]
        page += [*chapter["pages"], "```", ""]
    page += ["| | |", "|---|---|"]
    page += ["| first picture in a minute | [README](README.md) |", "| step by step | [user guide](docs/user-guide/README.md) |"]
    page += ["| which page answers what | [where to look](docs/README.md) |", "| equations and sources | [physics](docs/physics.md) |"]
    page += ["| how accurate it is | [accuracy](docs/accuracy.md) |", "| all commands | [command line](reference/command-line.md) |"]
    return "\n".join(page) + "\n"


def main(program, folder, reference, module=None):
    stage = Stage(Path(folder))
    shutil.rmtree(stage.folder, ignore_errors=True)
    todo = [page + ".md" for page in stage.pages() if page + ".md" in stage.files]
    stage.write("gallery.md", gallery(stage))
    stage.write("reference/command-line.md", command_line(program))
    stage.write("reference/python.md", python_reference(module))
    has_reference = Path(reference).is_dir()
    stage.write(
        "reference/cpp.md",
        "# C++ library\n\n"
        + (
            "The <a href=\"../cpp/index.html\">classes and functions of the public headers</a> of `irsg` and `smatcore`, and\n"
            "[a program of your own](../docs/embedding.md) that uses them.\n"
            if has_reference
            else "This site was made without doxygen; [a program of your own](../docs/embedding.md) shows the door.\n"
        ),
    )
    stage.write("index.md", index(stage))
    for name in sorted(stage.files):
        if re.fullmatch(r"samples/[^/]+/README\.md|docs/design/[^/]+\.md", name):
            todo.append(name)
    while todo:
        name = todo.pop()
        if name in stage.files:
            stage.add_page(name, todo)
    missing = [page for page in stage.pages() if page + ".md" not in stage.written]
    placeless = [f for f in stage.files if re.fullmatch(r"docs/(user-guide/)?[^/]+\.md", f) and f[:-3] not in stage.pages()]
    for page in missing:
        print(f"docs/site/pages.toml: {page} is no page", file=sys.stderr)
    for page in placeless:
        print(f"{page}: it stands in no chapter of docs/site/pages.toml", file=sys.stderr)
    version = json.loads((root / "codemeta.json").read_text())["version"]
    if version != os.environ["SMAT_VERSION"]:
        print(f"codemeta.json: version {version} is not {os.environ['SMAT_VERSION']}, that of CMakeLists.txt", file=sys.stderr)
        missing.append("codemeta.json")
    (stage.folder / "extra").mkdir()
    if has_reference:
        shutil.copytree(reference, stage.folder / "extra/cpp")
    (stage.folder / "static").mkdir()
    shutil.copy(root / "resources/icons/smat.svg", stage.folder / "static/smat.svg")
    return 1 if missing or placeless else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
