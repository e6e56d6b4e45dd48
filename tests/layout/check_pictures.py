#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Rules of the Python commands that a script can hold: all pictures draw their texts through runs/plots.py, which reads no formulas
in them, and all files of a run folder are opened through runs/regular_file.py, which waits for no named pipe."""
import ast
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
NAMES = ("runs", "report", "compare", "jet", "flow", "converge", "sweeps", "uncertainties", "interface")
PACKAGES = [ROOT / "src" / "python" / "barreno" / name for name in NAMES]
PLOTS, FILES = "plots.py", "regular_file.py"
PLOTTING = ("matplotlib.pyplot", "matplotlib.figure", "pylab")
SETTINGS = {"use", "rc", "rc_context", "rcParams"}
READERS = {"read_text", "read_bytes"}  # of a pathlib.Path


def name_of(node):
    return node.id if isinstance(node, ast.Name) else node.attr if isinstance(node, ast.Attribute) else ""


def imported(node):
    if isinstance(node, ast.Import):
        return [alias.name for alias in node.names]
    if isinstance(node, ast.ImportFrom):
        return [node.module or "", *(f"{node.module}.{alias.name}" for alias in node.names)]
    return []


def picture_faults(tree):
    """Ways around plots.py: (line, what)."""
    draws = any("barreno.runs.plots" in name or name.startswith("matplotlib") for node in ast.walk(tree) for name in imported(node))
    for node in ast.walk(tree):
        if any(name.startswith(PLOTTING) or name == "matplotlib" for name in imported(node)):
            yield node.lineno, "imports Matplotlib itself; take plt from barreno.runs.plots"
        if isinstance(node, ast.Attribute) and node.attr in SETTINGS and name_of(node.value) in ("plt", "matplotlib"):
            yield node.lineno, f"sets how texts are read ({node.attr}), which barreno.runs.plots does"
        if isinstance(node, ast.keyword) and node.arg in ("parse_math", "usetex", "useMathText"):
            yield node.value.lineno, f"sets {node.arg}, which barreno.runs.plots does"
        if draws and isinstance(node, ast.Constant) and isinstance(node.value, str) and "$" in node.value:
            yield node.lineno, "has a dollar sign in a text, which would be drawn as it is; write √J₂ and the like"


def reading_faults(tree):
    """Ways around regular_file.py: (line, what)."""
    for node in ast.walk(tree):
        if not isinstance(node, ast.Call):
            continue
        called = name_of(node.func)
        writes = any(isinstance(one, ast.Constant) and one.value == "w" for one in node.args[1:2])
        if isinstance(node.func, ast.Name) and called == "open" or isinstance(node.func, ast.Attribute) and called in READERS:
            yield node.lineno, f"calls {called}; take read_text, read_bytes or open_regular of barreno.runs.regular_file"
        if called == "Dataset" and not writes and not (isinstance(node.args[0], ast.Call) and name_of(node.args[0].func) == "checked"):
            yield node.lineno, "opens a Dataset whose path barreno.runs.regular_file has not checked"


def faults_of(source, name):
    tree = ast.parse(source)
    return [*(() if name == PLOTS else picture_faults(tree)), *(() if name == FILES else reading_faults(tree))]


BAD = ("import matplotlib.pyplot as plt", "from matplotlib import pyplot", "from matplotlib.figure import Figure", "import matplotlib",
    "plt.rcParams['a'] = 1",
       "axes.set_title(name, parse_math=True)", "from barreno.runs.plots import plt\nplt.title('$x$')", "open('a')", "file.read_text()",
       "file.read_bytes()", "Dataset(file)",
       "with Dataset(file, 'r') as data: pass")  # fmt: skip
GOOD = ("from barreno.runs.plots import plt", "from matplotlib.lines import Line2D", "read_text(file)", "Dataset(checked(file))",
    "Dataset(file, 'w')", "SCRIPT = '$SLURM'")


def main():
    problems = [f"this script does not see what is wrong with: {source}" for source in BAD if not faults_of(source, "a.py")]
    problems += [f"this script refuses what is right: {source}" for source in GOOD if faults_of(source, "a.py")]
    files = [file for package in PACKAGES for file in sorted(package.rglob("*.py"))]
    for file in files:
        problems += [f"{file.relative_to(ROOT)}:{line}: {what}" for line, what in faults_of(file.read_text(encoding="utf-8"), file.name)]
    print("\n".join(problems) or f"{len(files)} files draw and read as they should")
    return 1 if problems or not files else 0


if __name__ == "__main__":
    sys.exit(main())
