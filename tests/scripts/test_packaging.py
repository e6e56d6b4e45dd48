#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""packaging/ as far as it can be looked at without containers and without Spack: the Containerfile copies what is there, takes the
launcher's packages, builds what the release preset is; the recipe of Spack is read by Python, with directives that note what
they are told, and asks for every library that cmake/dependencies.cmake looks for; docs/install.md lists the same packages.

    test_packaging.py
"""
import ast
import contextlib
import json
import pathlib
import re
import shutil
import subprocess

ROOT = pathlib.Path(__file__).resolve().parents[2]
INSTRUCTIONS = {"FROM", "RUN", "COPY", "WORKDIR", "ARG", "ENV", "ENTRYPOINT", "CMD"}
NOT_IN_IMAGE = {"ccache"}  # of use to those who build twice
LIBRARIES = {  # what cmake/dependencies.cmake looks for -> package of Spack
    "MPI": "mpi", "Trilinos": "trilinos", "HDF5": "hdf5", "libdeflate.h": "libdeflate", "CGAL/IO/STL.h": "cgal", "CLI/App.hpp": "cli11",
    "nlohmann/json.hpp": "nlohmann-json",
}  # fmt: skip
TRILINOS = {"Tpetra": "tpetra", "Belos": "belos", "Ifpack2": "ifpack2", "MueLu": "muelu", "Kokkos": "kokkos"}


def launcher_packages(name):
    text = (ROOT / "barreno").read_text() + (ROOT / "src" / "commands.sh").read_text()
    words = re.search(rf"^{name}=\((.*?)\)", text, re.MULTILINE | re.DOTALL).group(1)
    others = re.findall(r'"\$\{(\w+_packages)\[@\]\}"', words)
    return {word for word in words.split() if "$" not in word}.union(*map(launcher_packages, others))


def instructions():
    text = re.sub(r"(?m)^\s*#.*\n", "", (ROOT / "packaging" / "Containerfile").read_text())
    for line in text.replace("\\\n", " ").splitlines():
        if line.strip():
            word, _, rest = line.partition(" ")
            assert word in INSTRUCTIONS, f"Containerfile: {line}"
            yield word, rest.strip()


def packages_of(line):
    return set(re.search(r"--no-install-recommends (.*?)(?:&&|$)", line).group(1).split())


def check_container():
    lines = list(instructions())
    stages = [rest for word, rest in lines if word == "FROM"]
    assert len(stages) == 2 and stages[0].endswith(" AS built"), stages
    copied = set()
    for word, rest in lines:
        if word == "COPY" and not rest.startswith("--from"):
            *sources, target = rest.split()
            assert target.startswith("/source/"), rest
            copied |= {source for source in sources if (ROOT / source).exists()}
            assert all((ROOT / source).exists() for source in sources), f"Containerfile copies what is not there: {rest}"
    assert {"CMakeLists.txt", "CMakePresets.json", "cmake", "materials", "src", "LICENSE"} <= copied, copied
    runs = [rest for word, rest in lines if word == "RUN"]
    python = launcher_packages("fit_packages") | launcher_packages("report_packages") | launcher_packages("plot_packages")
    assert packages_of(runs[0]) == (launcher_packages("build_packages")
        - NOT_IN_IMAGE) | python, packages_of(runs[0]) ^ launcher_packages("build_packages")
    presets = {preset["name"]: preset for preset in json.loads((ROOT / "CMakePresets.json").read_text())["configurePresets"]}
    assert presets["release"]["cacheVariables"]["BARRENO_TESTS"] == "OFF" and "cmake --preset release" in runs[1], runs[1]
    assert python <= packages_of(runs[2]), python - packages_of(runs[2])
    return packages_of(runs[0]) | packages_of(runs[2])


def check_names(packages):
    """Where the package manager of Debian 12 is."""
    release = pathlib.Path("/etc/os-release")
    if not shutil.which("apt-cache") or not release.exists() or "bookworm" not in release.read_text():
        return
    found = subprocess.run(["apt-cache", "show", "--no-all-versions", *sorted(packages)], capture_output=True, text=True,
        check=False).stdout
    known = set(re.findall(r"^Package: (\S+)", found, re.MULTILINE))
    if not known:  # no lists
        return
    virtual = {name for name in packages - known
        if "Reverse Provides" in subprocess.run(["apt-cache", "showpkg", name], capture_output=True, text=True, check=False).stdout}
    assert packages <= known | virtual, f"Debian 12 has no {sorted(packages - known - virtual)}"


class Recipe:
    """The directives of Spack that the recipe uses."""

    def __init__(self):
        self.specs, self.versions, self.variants, self.classes = [], [], [], []

    def names(self):
        def decorator(*_words, **_more):
            return lambda function: function

        @contextlib.contextmanager
        def when(spec):
            assert any(spec == f"+{name}" for name in self.variants), f"when({spec}) names no variant"
            yield

        recipe = self

        class CMakePackage:
            def __init_subclass__(cls, **more):
                recipe.classes.append(cls)

        return {
            "CMakePackage": CMakePackage, "when": when, "run_after": decorator, "on_package_attributes": decorator,
            "license": lambda name: self.__dict__.update(license=name), "version": self.versions.append,
            "variant": lambda name, default, description: self.variants.append(name), "depends_on": lambda spec,
            **more: self.specs.append(spec),
            "generator": lambda name: None, "join_path": lambda *parts: "/".join(map(str, parts)), "Executable": None,
        }  # fmt: skip


def check_recipe():
    source = (ROOT / "packaging" / "spack" / "package.py").read_text()
    tree = ast.parse(source)
    tree.body = [node for node in tree.body if not (isinstance(node, ast.ImportFrom) and node.module == "spack.package")]
    recipe = Recipe()
    exec(compile(tree, "package.py", "exec"), recipe.names())  # noqa: S102
    assert [cls.__name__ for cls in recipe.classes] == ["Barreno"] and recipe.license == "BSD-3-Clause", recipe.classes
    assert len(recipe.versions) == 1, recipe.versions
    asked = {re.split(r"[@ +]", spec)[0]: spec for spec in recipe.specs}
    dependencies = (ROOT / "cmake" / "dependencies.cmake").read_text()
    for sought, package in LIBRARIES.items():
        assert sought in dependencies and package in asked, f"{sought}: {package} is not asked for"
    looked_for = set(re.findall(r"find_package\((\w+)", dependencies)) | set(re.findall(r"find_path\(\w+ ([\w./]+)", dependencies))
    assert looked_for - {"exodusII.h"} == set(LIBRARIES), (
        f"{looked_for ^ set(LIBRARIES)}: Exodus comes with Trilinos, others need a package"
    )
    components = re.search(r"find_package\(Trilinos QUIET COMPONENTS ([^)]*)\)", dependencies).group(1).split()
    for component in components:
        if component != "Teuchos":
            assert f"+{TRILINOS[component]}" in asked["trilinos"], f"trilinos without {component}"
    least = re.search(r"cmake_minimum_required\(VERSION ([\d.]+)\)", (ROOT / "CMakeLists.txt").read_text()).group(1)
    assert asked["cmake"] == f"cmake@{least}:", asked["cmake"]
    defined = recipe.classes[0].cmake_args(Stand())
    options = set(re.findall(r"(?:option|set)\((BARRENO_\w+)", (ROOT / "CMakeLists.txt").read_text()))
    assert set(defined) <= options and "BARRENO_TESTS" in defined, f"{defined}: not all are options of CMakeLists.txt"


class Stand:
    """What cmake_args asks of a package."""

    spec = {"python": type("Python", (), {"command": type("Command", (), {"path": "/python3"})})}

    def define(self, name, value):
        return name

    define_from_variant = define


def check_page():
    page = (ROOT / "docs" / "install.md").read_text()
    rows = re.findall(r"^\| (?:tools|MPI|Trilinos|HDF5, Exodus, netCDF|libraries|Python|tests) \| ([^|]*) \|", page, re.MULTILINE)
    listed = {word for row in rows for word in row.split()}
    wanted = set().union(*(launcher_packages(name)
        for name in ("build_packages", "fit_packages", "report_packages", "plot_packages", "test_packages")))
    wanted = {name for name in wanted if "$" not in name}
    assert listed == wanted, f"docs/install.md and ./barreno differ: {sorted(listed ^ wanted)}"


def main():
    check_names(check_container())
    check_recipe()
    check_page()
    print("packaging agrees with the tree")


if __name__ == "__main__":
    main()
