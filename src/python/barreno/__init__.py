# SPDX-License-Identifier: BSD-3-Clause
"""Barreno from Python (docs/python.md).

Examples
--------
>>> import barreno
>>> run = barreno.run("input_xml/perforation_quick.xml", set={"Time/End Time": "12 us"}, out="runs/quick")
>>> run.depth["depth"].iloc[-1], run.depth.attrs["units"]["depth"]
>>> run.particles("12 us", ["pressure", "speed"])

Nothing but the package itself is loaded until a name is used: NumPy, pandas and the rest only where a call needs them.
"""

__version__ = "0.1.0"

_HOMES = {  # name: module that has it
    "open": "barreno.interface.opened",
    "Run": "barreno.interface.opened",
    "run": "barreno.interface.start",
    "check": "barreno.interface.deck",
    "Deck": "barreno.interface.deck",
    "sweep": "barreno.interface.swept",
    "uncertainty": "barreno.interface.studied",
    "Uncertainty": "barreno.interface.studied",
    "Material": "barreno.materials",
    "Fault": "barreno.runs.faults",
}
__all__ = sorted(_HOMES)


def __getattr__(name):
    if name not in _HOMES:
        raise AttributeError(f"module 'barreno' has no attribute '{name}'; it has {', '.join(__all__)}")
    from barreno.runs.faults import needed

    value = globals()[name] = getattr(needed(_HOMES[name]), name)
    return value


def __dir__():
    return sorted([*globals(), *__all__])
