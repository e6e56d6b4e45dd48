#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The notebooks of docs/guide: runs their code cells in order, as Jupyter would, but without Jupyter.

    notebooks.py BARRENO            runs them in a tree of their own and compares what they print with what they hold
    notebooks.py BARRENO --write    the same, and puts what they print and draw into them, and their pictures into docs/pictures

BARRENO is the program in its build folder (build/release/src/barreno). Words must agree, numbers to 5 %: compilers differ. Lines that a
cell prints on its way, with its times, are not compared. Exit code 77 without pandas or Matplotlib.
"""
import argparse
import ast
import base64
import contextlib
import io
import json
import os
import pathlib
import re
import sys
import tempfile

from lessons import make_tree

ROOT = pathlib.Path(__file__).resolve().parents[1]
GUIDE = ROOT / "docs" / "guide"
NUMBER = re.compile(r"[-+]?\d+\.?\d*(?:e[-+]?\d+)?")
LIKE = 0.05  # relative difference of numbers that counts as none
MOST_LINES = 10  # of code in a notebook
MOST_BYTES = 100_000  # of a notebook with its pictures
DOTS = 80  # per inch of a picture


def lines_of(text):
    return text.splitlines(keepends=True)


def run_cell(source, names):
    """The value of the last line, if it is an expression that has one."""
    tree = ast.parse(source)
    last = tree.body.pop() if tree.body and isinstance(tree.body[-1], ast.Expr) else None
    exec(compile(tree, "cell", "exec"), names)
    return eval(compile(ast.Expression(last.value), "cell", "eval"), names) if last else None


def drawn(plt):
    """The pictures that a cell has left open, as PNG."""
    found = []
    for number in plt.get_fignums():
        stream = io.BytesIO()
        plt.figure(number).savefig(stream, format="png", dpi=DOTS, bbox_inches="tight", metadata={"Software": None})
        found.append(stream.getvalue())
    plt.close("all")
    return found


def outputs_of(source, names, count, plt):
    """What Jupyter would store behind a cell: lines printed, value, pictures."""
    with contextlib.redirect_stdout(io.StringIO()) as printed:
        value = run_cell(source, names)
    pictures, out = drawn(plt), []
    if printed.getvalue():
        out.append({"name": "stdout", "output_type": "stream", "text": lines_of(printed.getvalue())})
    if value is not None and not pictures:
        data = {"text/plain": lines_of(repr(value))}
        out.append({"data": data, "execution_count": count, "metadata": {}, "output_type": "execute_result"})
    for picture in pictures:
        data = {"image/png": base64.b64encode(picture).decode(), "text/plain": ["<Figure>"]}
        out.append({"data": data, "metadata": {}, "output_type": "display_data"})
    return out


def code_cells(notebook):
    return [cell for cell in notebook["cells"] if cell["cell_type"] == "code"]


def run_notebook(notebook, folder, plt):
    """Runs all code cells in a folder; outputs of each, and the names that they leave."""
    names, outputs = {"__name__": "__main__"}, []
    with contextlib.chdir(folder):
        for count, cell in enumerate(code_cells(notebook), 1):
            outputs.append(outputs_of("".join(cell["source"]), names, count, plt))
    return outputs, names


def values_of(outputs):
    return ["".join(one["data"]["text/plain"]) for one in outputs if one["output_type"] == "execute_result"]


def pictures_of(outputs):
    return [base64.b64decode(one["data"]["image/png"]) for one in outputs if one["output_type"] == "display_data"]


def alike(text, other):
    """Whether two texts have the same words, and numbers that hardly differ."""
    numbers, others = ([float(number) for number in NUMBER.findall(one)] for one in (text, other))
    words, other_words = (re.sub(r"\s+", " ", NUMBER.sub("#", one)) for one in (text, other))
    return words == other_words and all(abs(a - b) <= LIKE * max(abs(a), abs(b)) for a, b in zip(numbers, others))


def differences(notebook, outputs):
    """What the notebook holds that the cells do not give any more."""
    for count, (cell, now) in enumerate(zip(code_cells(notebook), outputs), 1):
        held, given = values_of(cell["outputs"]), values_of(now)
        if len(held) != len(given) or not all(map(alike, held, given)):
            yield f"cell {count} holds\n" + "\n".join(held) + "\nbut gives\n" + "\n".join(given)
        if len(pictures_of(cell["outputs"])) != len(pictures_of(now)):
            yield f"cell {count} holds {len(pictures_of(cell['outputs']))} pictures and draws {len(pictures_of(now))}"


def size_faults(file, notebook, outputs):
    lines = sum(bool(line.strip()) for cell in code_cells(notebook) for line in cell["source"])
    if lines > MOST_LINES:
        yield f"{lines} lines of code, more than {MOST_LINES}"
    if file.stat().st_size > MOST_BYTES:
        yield f"{file.stat().st_size} bytes, more than {MOST_BYTES}"
    if not any(pictures_of(one) for one in outputs):
        yield "it draws no picture"


def depth_faults(names):
    """Of what the page claims: the depth falls with the stress, from run to run."""
    table = names["table"]
    stress, depth = table["Confinement/Pressure [MPa]"], table["penetration.depth"]
    if not (len(table) > 3 and (table["state"] == "finished").all() and stress.is_monotonic_increasing and (depth.diff()[1:] < 0.0).all()):
        yield f"the depth does not fall with the stress: {dict(zip(stress, depth))}"


CLAIMS = {"depth_against_stress": depth_faults}


def write(file, notebook, outputs):
    for count, (cell, now) in enumerate(zip(code_cells(notebook), outputs), 1):
        cell["outputs"], cell["execution_count"] = now, count
    file.write_text(json.dumps(notebook, indent=1, ensure_ascii=False, sort_keys=True) + "\n", encoding="utf-8")
    pictures = [picture for one in outputs for picture in pictures_of(one)]
    (ROOT / "docs" / "pictures" / f"{file.stem}.png").write_bytes(pictures[-1])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("barreno", type=lambda path: pathlib.Path(path).resolve(), help="the program in its build folder")
    parser.add_argument("--write", action="store_true", help="put what they print and draw into the notebooks")
    options = parser.parse_args()
    try:
        import matplotlib
        import pandas  # noqa: F401
    except ModuleNotFoundError as error:
        print(f"skipped: Python lacks {error.name} (apt-get install python3-pandas python3-matplotlib)")
        return 77
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    os.environ["BARRENO_PROGRAM"] = str(options.barreno)
    files, problems = sorted(GUIDE.glob("*.ipynb")), []
    for file in files:
        notebook = json.loads(file.read_text(encoding="utf-8"))
        with tempfile.TemporaryDirectory() as scratch:
            tree = make_tree(pathlib.Path(scratch).resolve(), options.barreno)
            (tree / "docs").unlink()
            (tree / "docs" / "guide").mkdir(parents=True)
            outputs, names = run_notebook(notebook, tree / "docs" / "guide", plt)
        if options.write:
            write(file, notebook, outputs)
        found = [*differences(notebook, outputs), *size_faults(file, notebook, outputs), *CLAIMS[file.stem](names)]
        problems += [f"{file.relative_to(ROOT)}: {problem}" for problem in found]
    print("\n".join(problems) or f"{len(files)} notebooks: all cells give what they hold")
    return 1 if problems or not files else 0


if __name__ == "__main__":
    sys.exit(main())
