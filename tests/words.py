#!/ usr / bin / env python3
"""Checks the English of comments, texts, pages and names: docstrings begin with a verb or a noun, and the words that
docs/glossary.md rejects do not occur."""
import pathlib
import re
import sys

COVERED = "app ui renderer bindings include examples docs scenes/README.md README.md CONTRIBUTING.md sim tests".split()
EXCEPT = ["docs/glossary.md", "tests/words.py"]

ROOT = pathlib.Path(__file__).resolve().parent.parent
CODE = {".h", ".cpp", ".c", ".cs", ".js", ".py", ".pyi", ".frag", ".vert", ".glsl", ".script"}
NAMED = {".h", ".cpp", ".c"}
OPENING = re.compile(r"(?:What|Whether|How|Of|of)\b")


def rejected_cells(page):
    """Returns the words in the last column of the glossary's tables of texts, and of its table of names."""
    words, names = set(), set()
    texts, _, table = page.partition("## Names in code")
    for part, found in (texts, words), (table, names):
        for line in part.splitlines():
            cells = [cell.strip() for cell in line.strip().strip("|").split("|")]
            if line.startswith("|") and len(cells) > 1 and cells[-1] != "not" and "…" not in cells[-1]:
                found.update(word.strip() for word in cells[-1].split(",") if word.strip(" -"))
    return words, names


def pattern_of_words(words):
    """Returns a pattern of words in texts."""
    return re.compile(r"(?<![\w/.:-])(" + "|".join(sorted(map(re.escape, words), key=len, reverse=True)) + r")(?![\w/-])", re.I)


def pattern_of_names(names):
    """Returns a pattern of words in names that are written as _snake_case_."""
    return re.compile("_(" + "|".join(sorted(names)) + ")(?=_)")


def snake_case(name):
    """Returns a name as _snake_case_."""
    return "_" + "_".join(re.findall(r"[A-Z]?[a-z]+|[A-Z]+(?![a-z])|\d+", name)).lower() + "_"


def names_of(text):
    """Yields line numbers and names of C or C++ code, without titles of tests, which are sentences."""
    keep_lines = lambda found: "\n" * found[0].count("\n") + '""'
    text = re.sub(r'R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|//[^\n]*|/\*.*?\*/|\bTEST\w*\([^)]*\)', keep_lines, text, flags=re.S)
    for number, line in enumerate(text.splitlines(), 1):
        for name in re.findall(r"[A-Za-z_]\w*", line):
            yield number, name


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
    comment = "#" if suffix in {
  ".py", ".pyi", ".script"
} else "//"
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


def problems_of(text, name, rejected, rejected_names):
    """Returns the problems of a file's text as lines."""
    suffix = pathlib.Path(name).suffix
    is_page = suffix == ".md"
    problems = []
    for number, part in texts_of_page(text) if is_page else texts_of_code(text, suffix):
        problems += [f"{name}:{number}: rejected by docs/glossary.md: {word}" for word in rejected.findall(part)]
    for number, part in [] if is_page else docstring_openings(text):
        if OPENING.match(part):
            problems.append(f'{name}:{number}: a docstring begins with a verb or a noun: "{part}"')
    for word in rejected_names.findall(snake_case(name)):
        problems.append(f"{name}: a file's name has a word rejected by docs/glossary.md: {word}")
    for number, found in names_of(text) if suffix in NAMED else []:
        words = rejected_names.findall(snake_case(found))
        problems += [f"{name}:{number}: {found} has a word rejected by docs/glossary.md: {word}" for word in words]
    return problems


def require_problems(rejected, rejected_names):
    """Checks that each kind of mistake is found, with its line, and that good text has none."""
    samples = [
        ("a.cpp", "int i;\n// A blow to the body.\n", 2),
        ("a.cpp", 'void f() { show("It sways a little."); }\n', 1),
        ("a.md", "# Title\n\nWaves of a shock.\n", 3),
        ("a.h", "/// Whether it moves.\nbool moves();\n", 1),
        ("a.h", "/// Returns it.\nvoid enter_shock();\n", 2),
        ("a.h", 'auto a = R"(one\ntwo)";\nstruct ShockRun {};\n', 3),
        ("shock.h", "", None),
        ("a.h", "/// Returns a shockwave.\nint explicit_run();  // `shock`\n", 0),
        ("a.md", "The key `hand_over` of a file.\n", 0),
    ]
    for name, text, line in samples:
        found = problems_of(text, name, rejected, rejected_names)
        expected = [] if line == 0 else [f"{name}:{line}: " if line else f"{name}: "]
        if len(found) != len(expected) or any(not f.startswith(e) for f, e in zip(found, expected)):
            raise AssertionError(f"of {name} {text!r}: {found}")


def main():
    words, names = rejected_cells((ROOT / "docs/glossary.md").read_text())
    rejected, rejected_names = pattern_of_words(words), pattern_of_names(names)
    require_problems(rejected, rejected_names)
    problems = []
    for file in covered_files():
        problems += problems_of(file.read_text(), str(file.relative_to(ROOT)), rejected, rejected_names)
    print("\n".join(problems))
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
