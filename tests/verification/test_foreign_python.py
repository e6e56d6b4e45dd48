#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The scripts of the repository can be called as their pages say: what begins with an interpreter is executable, and those of verification
say in one sentence which package a Python lacks."""
import os
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
FOLDERS = ("cmake", "docs", "input_xml", "verification")
SCRIPTS = ("verify.py", "pages.py", "trade.py", "predictions.py", "extremes.py", "paper.py", "deck_times.py", "depth_runs.py",
    "depth_at_rest.py", "converge_examples.py", "uncertainty_examples.py")


def not_executable():
    """Scripts with an interpreter in their first line and no run bit, and the other way round."""
    out = []
    for file in sorted(file for folder in FOLDERS for file in (ROOT / folder).rglob("*") if file.suffix in (".py", ".sh")
            and file.is_file()):
        starts, runs = file.read_bytes()[:2] == b"#!", os.access(file, os.X_OK)
        if starts != runs:
            out.append(f"{file.relative_to(ROOT)} "
                f"{'has an interpreter in its first line and no run bit' if starts else 'can be executed and names no interpreter'}")
    return out


def said_by_bare_python(script, *words):
    """Of a Python that sees no packages."""
    environment = {name: value for name, value in os.environ.items() if not name.startswith("PYTHON")}
    result = subprocess.run([sys.executable, "-S", script, *words], env=environment, cwd=ROOT, capture_output=True, text=True, timeout=120,
        check=False)
    return result.returncode, result.stderr


def check_script(name):
    words = {"verify.py": ("nowhere", "perforation")}.get(name, ("--help",))
    code, said = said_by_bare_python(ROOT / "verification" / name, *words)
    assert "Traceback" not in said and (code == 0 or said.count("\n") == 1 and "Python lacks " in said
        and "/usr/bin/python3" in said), f"{name}: exit {code}: {said}"
    return code != 0


def deep_scripts():
    """Those in folders of verification that import from beside their folder, which ./barreno python makes possible."""
    return [file for file in sorted((ROOT / "verification").glob("*/*.py")) if "__main__" in file.read_text()
        and "from tools import foreign_python" in file.read_text()]


def check_deep(script):
    """Started by itself it says in one sentence how to start it."""
    code, said = said_by_bare_python(script, "--help")
    assert code == 1 and said.count("\n") == 1 and f"./barreno python {script}" in said, f"{script}: exit {code}: {said}"


def main():
    wrong = not_executable()
    assert not wrong, "\n".join(wrong)
    lacking = [name for name in SCRIPTS if check_script(name)]
    assert {"verify.py", "pages.py"} <= set(lacking), lacking
    deep = deep_scripts()
    assert len(deep) > 15, deep
    for script in deep:
        check_deep(script)
    print(f"scripts can be called, {len(lacking)} of them say what a Python lacks, and {len(deep)} how to start them")


if __name__ == "__main__":
    main()
