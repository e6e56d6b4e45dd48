# SPDX-License-Identifier: BSD-3-Clause
"""Units by dimension, with what a number in them is multiplied by to be SI: the one table of the package, for words of commands and for
laboratory files. Decks have their own, which the program reads; input_xml/jets/quantity.py repeats what its scripts need, because they
start without the package (a test compares them)."""

PSI = 6894.757293168361  # pound-force per square inch, exact by definition
UNITS = {
    "stress": {"Pa": 1.0, "kPa": 1e3, "MPa": 1e6, "GPa": 1e9, "bar": 1e5, "kbar": 1e8, "atm": 101325.0, "psi": PSI, "ksi": 1e3 * PSI,
        "N/mm2": 1e6, "N/mm^2": 1e6, "N/mm²": 1e6, "MN/m2": 1e6, "kN/m2": 1e3},
    "compliance": {"1/Pa": 1.0, "1/kPa": 1e-3, "1/MPa": 1e-6, "1/GPa": 1e-9},
    "strain": {"-": 1.0, "1": 1.0, "%": 1e-2, "percent": 1e-2, "permille": 1e-3, "millistrain": 1e-3, "microstrain": 1e-6, "mm/mm": 1.0,
        "m/m": 1.0, "mm/m": 1e-3, "um/m": 1e-6, "µm/m": 1e-6, "μm/m": 1e-6, "ustrain": 1e-6, "‰": 1e-3},
    "ratio": {"-": 1.0, "1": 1.0, "%": 1e-2},
    "force": {"N": 1.0, "kN": 1e3, "MN": 1e6, "lbf": 4.4482216152605, "kgf": 9.80665},
    "length": {"m": 1.0, "mm": 1e-3, "cm": 1e-2, "um": 1e-6, "µm": 1e-6, "μm": 1e-6, "in": 0.0254, "inch": 0.0254,
        "ft": 0.3048},
    "speed": {"m/s": 1.0, "km/s": 1e3, "mm/us": 1e3, "cm/us": 1e4},
    "time": {"s": 1.0, "ms": 1e-3, "us": 1e-6, "µs": 1e-6, "μs": 1e-6, "ns": 1e-9, "min": 60.0, "h": 3600.0},
    "density": {"kg/m3": 1.0, "g/cm3": 1e3},
}
