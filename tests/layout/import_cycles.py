# SPDX-License-Identifier: BSD-3-Clause
"""Circles of imports among the Python files of a folder, imports inside functions included.

Scripts of one folder import each other by bare names. So a bare name is taken for every file of that name but the one that imports it. A
module of Python itself is no script, unless the import names a folder too ('extreme_rows.time').
"""
import ast
import sys


def names_imported(tree):
    """(folder or '', name) of every import."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            for alias in node.names:
                folder, _, name = alias.name.rpartition(".")
                yield folder.rpartition(".")[2], name
        elif isinstance(node, ast.ImportFrom) and node.module:
            folder, _, name = node.module.rpartition(".")
            yield folder.rpartition(".")[2], name
            for alias in node.names:  # from FOLDER import FILE
                yield name, alias.name


def imports_between(folder):
    """{file: files that it imports}"""
    files = sorted(folder.rglob("*.py"))
    named = {}
    for file in files:
        named.setdefault(file.stem, []).append(file)
    found = {}
    for file in files:
        found[file] = set()
        for where, name in names_imported(ast.parse(file.read_text())):
            if where:
                found[file].update(other for other in named.get(name, []) if other.parent.name == where)
                packages = (other for other in named.get("__init__", []) if other.parent.parts[-2:] == (where, name))
                found[file].update(other for other in packages if other != file)
            elif name not in sys.stdlib_module_names:
                found[file].update(other for other in named.get(name, []) if other != file)
    return found


def reachable(arrows, start):
    seen, ahead = set(), [start]
    while ahead:
        for file in arrows[ahead.pop()]:
            if file not in seen:
                seen.add(file)
                ahead.append(file)
    return seen


def circles(folder):
    """Groups of files that import each other in a circle, each as a sorted list."""
    arrows = imports_between(folder)
    ahead = {file: reachable(arrows, file) for file in arrows}
    groups = {tuple(sorted(other for other in ahead[file] if file in ahead[other])) for file in arrows if file in ahead[file]}
    return [list(group) for group in sorted(groups)]
