# SPDX-License-Identifier: BSD-3-Clause
"""Imported first by the scripts of verification: a Python that lacks a package, as another one on the path may, ends them with one
sentence."""
import sys

PACKAGES = {"numpy": "python3-numpy", "scipy": "python3-scipy", "matplotlib": "python3-matplotlib", "mpmath": "python3-mpmath",
    "h5py": "python3-h5py", "netCDF4": "python3-netcdf4", "pandas": "python3-pandas", "PIL": "python3-pil",
    "vtkmodules": "python3-vtk9"}  # fmt: skip
usual = sys.excepthook


def sentence(error):
    name = (error.name or "").split(".")[0]
    if name == "barreno":
        return (
            f"{sys.argv[0]}: Python lacks barreno, the package of src/python; start the script with ./barreno python {sys.argv[0]}, or set "
            "PYTHONPATH=src/python for another Python, as /usr/bin/python3."
        )
    package = f" (Debian: apt-get install {PACKAGES[name]})" if name in PACKAGES else ""
    return (
        f"{sys.argv[0]}: Python lacks {name} ('{sys.executable}' runs this script); install it{package}, or call the script with another "
        "Python of 3.11 or later, as /usr/bin/python3."
    )


def say_missing(kind, error, trace):
    if issubclass(kind, ModuleNotFoundError):
        print(sentence(error), file=sys.stderr)
    else:
        usual(kind, error, trace)


sys.excepthook = say_missing
