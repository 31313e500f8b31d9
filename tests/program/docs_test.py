"""The pages of the documentation: made without warnings, every link among them leads somewhere."""

import os
import re
import shutil
import sys
import tempfile
import unittest
from html import unescape
from urllib.parse import unquote

SOURCE = os.environ["FIBERCHAIN_SOURCE_DIR"]
HEADERS = os.environ["FIBERCHAIN_PUBLIC_HEADERS"]
sys.path.insert(0, os.path.join(SOURCE, "cmake"))
import docs  # noqa: E402

DOXYGEN = shutil.which("doxygen")


def read(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


def broken_links(html):
    """Links of pages to files or places that are not there."""
    text, names, broken = {}, {}, []
    for name in os.listdir(html):
        if name.endswith(".html"):
            text[name] = read(os.path.join(html, name))
            names[name] = set(re.findall(r'(?:id|name)="([^"]+)"', text[name]))
    for page, content in text.items():
        for target in map(unescape, re.findall(r'(?:href|src)="([^"]+)"', content)):
            # doxygen links to the list of nested classes where all are private, which it leaves out
            if re.match(r"[a-z]+:", target) or target == "#nested-classes":
                continue
            file, _, place = target.partition("#")
            file = unquote(file) or page
            if not os.path.exists(os.path.join(html, file)) or (place and file in names and place not in names[file]):
                broken.append(f"{page}: {target}")
    return broken


class Docs(unittest.TestCase):
    def made(self, root, headers, pages):
        directory = tempfile.TemporaryDirectory()
        self.addCleanup(directory.cleanup)
        return directory.name, *docs.make(root, directory.name, DOXYGEN, headers, pages)

    def test_the_pages(self):
        headers = read(HEADERS).split()
        out, without_words, others = self.made(SOURCE, headers, docs.PAGES)
        self.assertEqual(others, [])
        html = os.path.join(out, "html")
        for page in docs.PAGES:
            title = re.match("# (.*)", read(os.path.join(SOURCE, page)))[1].replace("`", "")
            name = "index.html" if page == "README.md" else docs.page_id(page) + ".html"
            self.assertIn(title, unescape(re.sub("<[^>]+>", "", read(os.path.join(html, name)))), page)
        # the docstring of a part of the module is among them
        self.assertIn("Rods in space", read(os.path.join(html, "namespacemembers.html")) + "".join(
            read(os.path.join(html, name)) for name in os.listdir(html) if name.startswith("namespacefiberchain")))
        self.assertEqual(broken_links(html), [])
        # what has no words is of the headers and the module
        for line in without_words:
            self.assertTrue(line.split(":")[0] in headers or line.startswith(docs.MODULE), line)

    def test_what_is_amiss_is_told(self):
        with tempfile.TemporaryDirectory() as root:
            for name, text in (("README.md", "# Title\n\nSee [this](there.md), [that](odd.hpp).\n"),
                               ("there.md", "# There\n\n[back](README.md)\n"),
                               ("odd.hpp", "#pragma once\nnamespace fiberchain {\n/// A number, \\unknowncommand.\n"
                                           "int number();\nstruct Bare { int part; };\n}\n")):
                with open(os.path.join(root, name), "w", encoding="utf-8") as file:
                    file.write(text)
            out, without_words, others = self.made(root, ["odd.hpp"], ["README.md", "there.md"])
            self.assertEqual([line for line in others if "unknowncommand" not in line], [])
            self.assertTrue(others[0].startswith("odd.hpp:3"), others)
            self.assertTrue(any("Bare" in line for line in without_words), without_words)
            html = os.path.join(out, "html")
            self.assertEqual(broken_links(html), [])
            os.remove(os.path.join(html, "files", "odd.hpp"))
            self.assertEqual(broken_links(html), ["index.html: files/odd.hpp"])
            with open(os.path.join(root, "there.md"), "a", encoding="utf-8") as file:
                file.write("[gone](gone.md)\n")
            with self.assertRaisesRegex(SystemExit, "there.md: the link to gone.md leads nowhere"):
                self.made(root, ["odd.hpp"], ["README.md", "there.md"])


if __name__ == "__main__":
    if DOXYGEN is None:
        print("skipped: doxygen is not installed (packages of .ci/packages-docs.txt)")
        sys.exit(0)
    unittest.main(verbosity=2)
