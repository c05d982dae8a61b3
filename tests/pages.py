#!/usr/bin/env python3
"""Checks pages: links lead to files and headings that exist, files, functions and tests that pages name exist, and the
programs in README.md are those of examples/."""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
PAGES = [ROOT / "README.md", ROOT / "CONTRIBUTING.md", ROOT / "scenes/README.md", *sorted((ROOT / "docs").glob("*.md"))]
PROGRAMS = ["examples/hello/shot.cpp", "examples/python/shot.py"]
FOLDERS = "app bindings examples include renderer sim tests ui docs scenes".split()
MAX_README_LINES = 120


def anchors_of(page):
    """Returns the anchors of a page's headings, as GitHub makes them."""
    headings = re.findall(r"^#+ (.*)$", page.read_text(), re.M)
    return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in headings}


def broken_links(page):
    """Yields the links of a page that lead nowhere."""
    for link in re.findall(r"\]\(([^)\s]+)\)", page.read_text()):
        path, _, anchor = link.partition("#")
        target = (page.parent / path).resolve() if path else page
        if "://" in link:
            continue
        if not target.exists():
            yield f"{page.relative_to(ROOT)}: {link} does not exist"
        elif anchor and anchor not in anchors_of(target):
            yield f"{page.relative_to(ROOT)}: {link} has no such heading"


def known_names():
    """Returns the paths of all files as one text, and all words of the sources."""
    files, words = "", set()
    for folder in FOLDERS:
        for file in sorted((ROOT / folder).rglob("*")):
            files += f"/{file.relative_to(ROOT)}\n"
            if file.suffix in {".h", ".cpp", ".py", ".cs", ".txt"}:
                words.update(re.findall(r"\w+", file.read_text()))
    return files, words


def missing_names(page, files, words):
    """Yields the files, functions and tests in `code` of a page that do not exist."""
    for code in set(re.findall(r"`([^`\n]+)`", page.read_text())):
        if re.fullmatch(r"[a-z][\w/]*\.(h|cpp|py)", code):
            found = f"/{code}\n" in files
        elif re.fullmatch(r"\w+\(\)", code):
            found = code[:-2] in words
        elif re.fullmatch(r"[A-Z][a-zA-Z]+\.[A-Z][a-zA-Z]{15,}", code):
            found = code.split(".")[1] in words or code.endswith("NativeArray")
        else:
            continue
        if not found and "NAME" not in code:
            yield f"{page.relative_to(ROOT)}: {code} does not exist"


def missing_programs():
    """Yields the programs that README.md does not contain as they are."""
    readme = (ROOT / "README.md").read_text()
    for name in PROGRAMS:
        block = "".join("    " + line if line.strip() else line for line in (ROOT / name).open())
        if block not in readme:
            yield f"README.md: {name} is not in it as it is"


def main():
    problems = [problem for page in PAGES for problem in broken_links(page)] + list(missing_programs())
    files, words = known_names()
    problems += [problem for page in PAGES for problem in missing_names(page, files, words)]
    if len((ROOT / "README.md").read_text().splitlines()) > MAX_README_LINES:
        problems.append(f"README.md: more than {MAX_README_LINES} lines")
    print("\n".join(problems))
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
