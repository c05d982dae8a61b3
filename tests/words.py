#!/usr/bin/env python3
"""Checks the English of comments, texts and pages: docstrings begin with a verb or a noun, and the words that
docs/glossary.md rejects do not occur."""
import pathlib
import re
import sys

COVERED = """app ui renderer bindings include examples docs scenes/README.md README.md CONTRIBUTING.md
sim/core sim/geometry sim/mesh sim/meshing sim/scene sim/recording sim/timeline sim/splinters sim/fracture sim/elasticity sim/explicit
tests""".split()
EXCEPT = ["docs/glossary.md"]

ROOT = pathlib.Path(__file__).resolve().parent.parent
CODE = {".h", ".cpp", ".c", ".cs", ".js", ".py", ".pyi", ".frag", ".vert", ".glsl", ".script"}
OPENING = re.compile(r"(?:What|Whether|How|Of|of)\b")


def rejected_words():
    """Returns a pattern of the last column of the glossary's tables."""
    words = set()
    for line in (ROOT / "docs/glossary.md").read_text().splitlines():
        cells = [cell.strip() for cell in line.strip().strip("|").split("|")]
        if line.startswith("|") and len(cells) > 1 and cells[-1] != "not" and "…" not in cells[-1]:
            words.update(word.strip() for word in cells[-1].split(",") if word.strip(" -"))
    return re.compile(r"(?<![\w/.:-])(" + "|".join(sorted(map(re.escape, words), key=len, reverse=True)) + r")(?![\w/-])", re.I)


def covered_files():
    """Yields the files whose English is checked."""
    for name in COVERED:
        path = ROOT / name
        for file in sorted(path.rglob("*")) if path.is_dir() else [path]:
            if file.suffix in CODE | {".md"} and str(file.relative_to(ROOT)) not in EXCEPT:
                yield file


def texts_of_page(text):
    """Yields line numbers and texts of a page, without names in `code` and tables that a program writes."""
    is_written = False
    for number, line in enumerate(text.splitlines(), 1):
        is_written = line.startswith("<!-- table") or (is_written and line != "<!-- end -->")
        if not is_written:
            yield number, re.sub(r"`[^`]*`|\]\([^)]*\)|<!--.*?-->", " ", line)


def texts_of_code(text, suffix):
    """Yields line numbers and texts of comments and of string literals that contain a blank."""
    comment = "#" if suffix in {".py", ".pyi", ".script"} else "//"
    for number, line in enumerate(text.splitlines(), 1):
        for literal in re.findall(r'"((?:[^"\\]|\\.)*)"', line):
            if " " in literal:
                yield number, literal
        bare = re.sub(r'"(?:[^"\\]|\\.)*"', '""', line)
        if comment in bare:
            yield number, re.sub(r"`[^`]*`", " ", bare[bare.index(comment) :])
        elif re.match(r"\s*(/?\*|\"\"\")", line) or (suffix == ".py" and not re.search(r"[=()]", line)):
            yield number, re.sub(r"`[^`]*`", " ", line)


def docstring_openings(text):
    """Yields line numbers and texts of docstrings, without their continuation lines."""
    continues = False
    for number, line in enumerate(text.splitlines(), 1):
        found = re.search(r"(?:///<?|\"\"\"|/\*\*?) *(?:<summary>)?(.*)", line)
        if found and (not continues or line[: found.start()].strip()):
            yield number, found[1]
        continues = bool(re.search(r"///", line))


def problems_of(file, rejected):
    """Returns the problems of a file as lines."""
    text = file.read_text()
    name = file.relative_to(ROOT)
    is_page = file.suffix == ".md"
    problems = []
    for number, part in texts_of_page(text) if is_page else texts_of_code(text, file.suffix):
        problems += [f"{name}:{number}: rejected by docs/glossary.md: {word}" for word in rejected.findall(part)]
    for number, part in [] if is_page else docstring_openings(text):
        if OPENING.match(part):
            problems.append(f'{name}:{number}: a docstring begins with a verb or a noun: "{part}"')
    return problems


def main():
    rejected = rejected_words()
    problems = [problem for file in covered_files() for problem in problems_of(file, rejected)]
    print("\n".join(problems))
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
