"""Holds what a reader of the site relies on: check_site.py HTML ends with 1 and says what does not hold.

- every link inside the site leads to a file, and to a place in it that exists;
- nothing is loaded from the network when a page is opened;
- each term of docs/site/pages.toml finds its page first: it is the main index entry of that page alone, which Sphinx's search
  ranks before titles and texts.
"""

import json
import sys
import tomllib
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit

plan = Path(__file__).with_name("pages.toml")
loading = {"script": "src", "img": "src", "link": "href", "iframe": "src", "source": "src"}


class Page(HTMLParser):
    def __init__(self, path):
        super().__init__()
        self.places, self.links, self.loads = set(), [], []
        self.feed(path.read_text(encoding="utf-8", errors="replace"))

    def handle_starttag(self, tag, attributes):
        values = dict(attributes)
        for key in ("id", "name"):
            if values.get(key):
                self.places.add(values[key])
        if tag == "a" and values.get("href"):
            self.links.append(values["href"])
        if tag in loading and values.get(loading[tag]) and values.get("rel") not in ("canonical", "next", "prev"):
            self.loads.append(values[loading[tag]])


def faults_of_links(folder):
    pages = {path: Page(path) for path in folder.rglob("*.html") if "cpp" not in path.relative_to(folder).parts[:1]}
    for path, page in pages.items():
        where = path.relative_to(folder)
        for target in page.loads:
            if urlsplit(target).netloc:
                yield f"{where}: loads {target}"
        for target in page.links + page.loads:
            parts = urlsplit(target)
            if parts.scheme or parts.netloc:
                continue
            file = (path.parent / unquote(parts.path)).resolve() if parts.path else path
            if not file.exists():
                yield f"{where}: {target} leads nowhere"
            elif parts.fragment and file in pages and unquote(parts.fragment) not in pages[file].places:
                yield f"{where}: {target} has no such place"


def faults_of_search(folder):
    text = (folder / "searchindex.js").read_text()
    index = json.loads(text[text.index("(") + 1 : text.rindex(")")])
    for term, page in tomllib.loads(plan.read_text())["terms"].items():
        entries = index["indexentries"].get(term.lower(), [])
        found = [index["docnames"][document] for document, _, is_main in entries if is_main]
        if found != [page]:
            yield f"search for {term}: finds {found or 'nothing'} first, not {page}"


def main(html):
    folder = Path(html).resolve()
    faults = [*faults_of_links(folder), *faults_of_search(folder)]
    for fault in faults:
        print(fault, file=sys.stderr)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
