"""Pages of the documentation by doxygen: README files, the public headers of the library, docstrings of the module.

docs.py SOURCE OUT DOXYGEN HEADERS: HEADERS is a file with a header a line; pages are OUT/html/index.html. What is public and
has no words is told in OUT/undocumented.txt; any other warning fails.
"""

import os
import re
import shutil
import subprocess
import sys

PAGES = ["README.md", "ARCHITECTURE.md", "CHANGELOG.md", "dem/README.md", "dem/material/README.md", "dem/lammps/README.md",
         "compare/README.md", "compare/python/README.md", "data/scenes/README.md", "data/materials/README.md",
         "data/published/README.md", "tests/README.md"]
MODULE = "compare/python/fiberchain"
LINK = re.compile(r"(!?)\[((?:[^\[\]]|\[[^\]]*\])*)\]\(([^)\s]+)\)")
CODE = re.compile(r"(```.*?```|`[^`\n]*`)", re.DOTALL)


def page_id(page):
    return "index" if page == "README.md" else "page_" + re.sub(r"\W", "_", page[:-len(".md")])


class Layout:
    """`source` below a directory, with what doxygen is to read."""

    def __init__(self, root, out, pages=PAGES):
        self.root, self.out = root, out
        self.pages = [page for page in pages if os.path.exists(os.path.join(root, page))]
        self.source, self.html = os.path.join(out, "source"), os.path.join(out, "html")
        for directory in (self.source, self.html):
            shutil.rmtree(directory, ignore_errors=True)
            os.makedirs(directory)

    def put(self, path, text):
        place = os.path.join(self.source, path)
        os.makedirs(os.path.dirname(place), exist_ok=True)
        with open(place, "w", encoding="utf-8") as file:
            file.write(text)

    def read(self, path):
        with open(os.path.join(self.root, path), encoding="utf-8") as file:
            return file.read()

    def link(self, page, match):
        """To another page, a picture, or a file, of which a copy goes beside the pages."""
        mark, words, target = match.groups()
        if re.match(r"[a-z]+:", target) or target.startswith("#"):
            return match.group(0) if not target.startswith("#") else words
        path = os.path.normpath(os.path.join(os.path.dirname(page), target.split("#")[0]))
        whole = os.path.join(self.root, path)
        if not os.path.exists(whole):
            raise SystemExit(f"{page}: the link to {target} leads nowhere")
        if os.path.isdir(whole):
            path = os.path.join(path, "README.md")
        if path in self.pages:
            return f"[{words}](@ref {page_id(path)})"
        if os.path.isdir(whole):
            return words
        copy = os.path.join(self.html, "files", path)
        os.makedirs(os.path.dirname(copy), exist_ok=True)
        shutil.copyfile(whole, copy)
        place = "files/" + path
        return f'<img src="{place}" alt="{words}" style="max-width:100%"/>' if mark else f'<a href="{place}">{words}</a>'

    def page(self, page):
        """Links rewritten, a name behind the title; code stays as it is."""
        parts = CODE.split(self.read(page))
        text = "".join(part if n % 2 else LINK.sub(lambda match: self.link(page, match), part)
                       for n, part in enumerate(parts))
        title = "mainpage" if page == "README.md" else page_id(page)
        self.put(page, re.sub(r"\A# (.*)\n", rf"# \1 {{#{title}}}\n", text))

    def header(self, path):
        """Comments are words: what looks like a tag in them is none."""
        def plain(match):
            return re.sub(r"<(?=[A-Za-z/])", r"\\<", match.group(0))
        self.put(path, re.sub(r"///(?!<).*|(?<=///<).*", plain, self.read(path)))

    def module(self):
        """Its public part: `_core` is told by the classes of the package."""
        directory = os.path.join(self.root, MODULE)
        for name in sorted(os.listdir(directory) if os.path.isdir(directory) else []):
            if name.endswith(".py"):
                self.put(os.path.join(MODULE, name), self.read(os.path.join(MODULE, name)))

    def namespaces(self):
        """Words on namespaces, without which doxygen leaves out functions of theirs that have none."""
        self.put("namespaces.hpp",
                 "/// @namespace fiberchain\n/// Flexible fibers as chains of spheres.\n\n"
                 "/// @namespace fiberchain::dem\n/// The library: chains, their motion and equilibria, packings.\n\n"
                 "/// @namespace fiberchain::compare\n/// Calibration of chains for a material.\n")


def warnings_of(out):
    """Those of doxygen's log: what has no words, and all others."""
    with open(os.path.join(out, "warnings.txt"), encoding="utf-8", errors="replace") as file:
        every = [line.replace(os.path.join(out, "source") + "/", "") for line in file.read().splitlines() if line.strip()]
    without_words = [line for line in every if line.endswith("is not documented.")]
    return without_words, [line for line in every if line not in without_words]


def make(root, out, doxygen, headers, pages=PAGES):
    """Makes the pages: what is public without words, and every other warning."""
    layout = Layout(root, out, pages)
    layout.namespaces()
    layout.module()
    for page in layout.pages:
        layout.page(page)
    for header in headers:
        layout.header(header)
    configuration = os.path.join(os.path.dirname(os.path.abspath(__file__)), "Doxyfile")
    subprocess.run([doxygen, configuration], cwd=out, check=True)
    return warnings_of(out)


def main():
    root, out, doxygen, list_of_headers = sys.argv[1:]
    with open(list_of_headers, encoding="utf-8") as file:
        headers = file.read().split()
    out = os.path.abspath(out)
    without_words, others = make(os.path.abspath(root), out, doxygen, headers)
    with open(os.path.join(out, "undocumented.txt"), "w", encoding="utf-8") as file:
        file.write("".join(line + "\n" for line in without_words))
    for line in others:
        print(line, file=sys.stderr)
    print(f"{os.path.join(out, 'html', 'index.html')}: {len(headers)} headers; "
          f"{len(without_words)} public items have no words: {os.path.join(out, 'undocumented.txt')}")
    return 1 if others else 0


if __name__ == "__main__":
    sys.exit(main())
