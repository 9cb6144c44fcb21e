"""The table of shaders/kernels/README.md matches the kernels' own header comments.

The comment at the top of a kernel ends with four entries, each of one or more lines:

    // reads: rays, hits, paths, materials
    // writes: photons, next rays and paths
    // threads: photon paths
    // computes: store; Russian roulette with the largest albedo as its probability
    //     of survival [Jensen01]

Run as a program, this writes the table: rows keep their order, which is that of a pass, and a new kernel's row is appended,
to be moved to its place.
"""

import pathlib
import re
import sys

RULE = "the table of kernels says what the kernels' heads say; python3 tests/house/kernel_table.py writes it"

README = "shaders/kernels/README.md"
ENTRIES = ("reads", "writes", "threads", "computes")
START, END = "<!-- generated: kernels -->\n", "<!-- end -->"


def head_of(text):
    """The entries of a kernel's first comment."""
    entries, name = {}, None
    for line in text.splitlines():
        if not line.startswith("//"):
            if entries or line.startswith("layout"):
                break
            continue
        match = re.match(r"// (\w+): (.*)", line)
        if match and match[1] in ENTRIES:
            name = match[1]
            entries[name] = match[2].strip()
        elif name and line.startswith("//     "):
            entries[name] += " " + line[2:].strip()
        else:
            name = None
    return entries


def rows_of(readme):
    """The names of the kernels in the table, in order."""
    table = readme.partition(START)[2].partition(END)[0]
    return re.findall(r"^\| (\w+) \|", table, re.M)[1:]  # the first is the heading


def table_of(kernels, order):
    """The table in Markdown; `kernels`: name -> text."""
    names = [name for name in order if name in kernels] + sorted(set(kernels) - set(order))
    lines = ["| kernel | reads | writes | threads | computes |", "|---|---|---|---|---|"]
    for name in names:
        head = head_of(kernels[name])
        lines.append(f"| {name} | " + " | ".join(head.get(entry, "") for entry in ENTRIES) + " |")
    return "\n".join(lines) + "\n"


def updated(readme, kernels):
    before, start, rest = readme.partition(START)
    return before + start + table_of(kernels, rows_of(readme)) + END + rest.partition(END)[2]


def kernels_in(tree):
    paths = tree.under("shaders/kernels/", ".comp")
    return {path: tree.text(path) for path in paths}


def name_of(path):
    return pathlib.PurePosixPath(path).stem


def check(tree):
    kernels = kernels_in(tree)
    if not kernels:
        return []
    found = [
        f"{path}: its head has no '// {entry}: …'"
        for path, text in kernels.items()
        for entry in ENTRIES
        if not head_of(text).get(entry)
    ]
    readme = tree.text(README) if README in tree.paths else ""
    if START not in readme or END not in readme.partition(START)[2]:
        return found + [f"{README}: no table between {START.strip()} and {END}"]
    if updated(readme, {name_of(path): text for path, text in kernels.items()}) != readme:
        found.append(f"{README}: the table is not what the kernels' heads say")
    return found


_KERNEL = (
    "#version 460\n// Adds numbers.\n// reads: numbers\n// writes: sums\n// threads: chunks\n"
    "// computes: first half of\n//     a prefix sum\n#include \"lib/thread.glsl\"\nlayout(local_size_x = 1) in;\n"
)
_TABLE = (
    "# Kernels\n\n" + START + "| kernel | reads | writes | threads | computes |\n|---|---|---|---|---|\n"
    "| sum_chunks | numbers | sums | chunks | first half of a prefix sum |\n" + END + "\n\nMore.\n"
)
CLEAN = {"shaders/kernels/sum_chunks.comp": _KERNEL, README: _TABLE}
PLANTED = [
    ("shaders/kernels/sum_chunks.comp", _KERNEL.replace("// writes: sums\n", ""), "no '// writes"),
    ("shaders/kernels/other.comp", "#version 460\nvoid main() {}\n", "no '// reads"),
    (README, _TABLE.replace("| sums |", "| sum |"), "not what the kernels' heads say"),
    (README, _TABLE.replace("| sum_chunks |", "| gone | a | b | c | d |\n| sum_chunks |"), "not what the kernels' heads say"),
    (README, "# Kernels\n", "no table between"),
]


def main():
    root = pathlib.Path(__file__).resolve().parents[2]
    kernels = {path.stem: path.read_text() for path in sorted((root / "shaders/kernels").glob("*.comp"))}
    readme = root / README
    text = readme.read_text()
    if START not in text:
        sys.exit(f"{README}: no {START.strip()}")
    readme.write_text(updated(text, kernels))


if __name__ == "__main__":
    main()
