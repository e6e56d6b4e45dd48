# SPDX-License-Identifier: BSD-3-Clause
"""Numbers of a run as rows of a table: (name, value)."""

from barreno.converge.report import error_text, unknown_text

MILLI, MICRO = 1e-3, 1e-6


def count_text(cells):
    text = f"{cells:.2g}"
    return f"{text} cell" if text == "1" else f"{text} cells"


def error_words(error):
    """What a summary says of the error of a depth."""
    if "value" in error:
        return (
            f"; error from the size of the cells {error_text(error)} at {count_text(error['cells_per_radius'])} per jet radius, as "
            f"{error['source']}"
        )
    return f"; error from the size of the cells {unknown_text(error)}" if "unknown" in error else ""


def depth_text(depth, penetration):
    """The depth with its interval: of a convergence study of the deck, or else the error that was measured with cells of that size."""
    if depth["depth"] <= 0.0:
        return "none: the jet has hit no target"
    if penetration.get("through"):
        return f"through: the jet has come out of the rear of the target, {depth['depth'] / MILLI:.2f} mm from its face"
    bodies = [(name, value) for name, value in penetration.get("depth_in_body", {}).items() if value > 0.0]
    text = f"{depth['depth'] / MILLI:.2f} mm"
    if len(bodies) > 1:
        text += " (" + ", ".join(f"{value / MILLI:.2f} mm in {name}" for name, value in reversed(bodies)) + ")"
    study, error = penetration.get("convergence"), penetration.get("depth_error", {})
    if study:
        cells = ", ".join(f"{size / MILLI:.3g}" for size in sorted(study["cells"], reverse=True))
        alone = "the two smallest, which agree" if study.get("verdict") == "two agree" else "spread, without an order"
        what = "grid convergence index" if study["extrapolated"] is not None else alone
        text += f"; {study['low'] / MILLI:.1f} to {study['high'] / MILLI:.1f} mm by cells of {cells} mm ({what})"
    return text + error_words(error)


def depth_interval(depth, penetration):
    """(low, high, words) in m: of a convergence study, or else of the error that was measured; None where neither is known."""
    study, error = penetration.get("convergence"), penetration.get("depth_error", {})
    if study:
        return study["low"], study["high"], "interval of barreno converge"
    if "value" in error and depth > 0.0:
        return depth / (1.0 + error["high"]), depth / (1.0 + error["low"]), "true depth by the measured error of such cells"
    return None


def resolution_rows(penetration):
    cells = penetration.get("cells_per_radius")
    if not cells:
        return []
    return [("cells per radius of the jet at impact",
        f"{cells['least']:.3g} to {cells['most']:.3g} (tip {cells['tip']:.3g}, tail {cells['tail']:.3g})")]


def entrance_rows(penetration):
    """Diameter of the hole in the face of every body on the path, the jet's nearest last."""
    found = [(name, value) for name, value in penetration.get("entrance_diameter_in_body", {}).items() if value > 0.0]
    return [("entrance diameter by body",
        ", ".join(f"{value / MILLI:.2f} mm in {name}" for name, value in reversed(found)))] if found else []


def rest_rows(penetration):
    """Whether the hole was at rest at the end, and why or why not; of launched jets."""
    sentence = penetration.get("rest", {}).get("sentence")
    return [("at the end", sentence)] if sentence else []


def probe_rows(depth, penetration):
    """How far the hole is as wide as the jet; of runs that know it."""
    if "probed_depth" not in depth or penetration.get("cells_per_radius") is None:
        return []
    error = penetration.get("probed_depth_error", {})
    return [("as wide as the jet's widest slug", f"to {depth['probed_depth'] / MILLI:.2f} mm" + error_words(error))]


def least_certain_rows(penetration):
    """The ranges of the rock's card that change the hole most; of cards that were measured."""
    sentence = penetration.get("least_certain", {}).get("sentence")
    return [("of the rock", sentence)] if sentence else []


def depth_rows(summary, depth):
    if not depth:
        return []
    return [
        ("depth", depth_text(depth, summary.get("penetration", {}))),
        *rest_rows(summary.get("penetration", {})),
        *resolution_rows(summary.get("penetration", {})),
        ("open channel", f"{depth['channel_depth'] / MILLI:.2f} mm (in whole cells of the finest size)"),
        *probe_rows(depth, summary.get("penetration", {})),
        ("channel radius at half depth", f"{depth['channel_radius_mid'] / MILLI:.2f} mm"),
        *entrance_rows(summary.get("penetration", {})),
        *least_certain_rows(summary.get("penetration", {})),
        ("jet mass inside", f"{depth['jet_mass_inside'] * 1e3:.3f} g"),
    ]


def numerical_shares(summary):
    """Shares of the energy put in that stress integration and transfer have added (+) or lost (-), in percent; None where unknown."""
    energy = summary.get("balances", {}).get("energy", {})
    if "transfer_share" not in energy:
        return None
    return 100.0 * energy["stress_integration_share"], 100.0 * energy["transfer_share"]


def energy_rows(summary):
    shares = numerical_shares(summary)
    if shares is None:
        return []
    warning = summary.get("numerical_energy", {}).get("warning")
    return [
        *([("warning", warning)] if warning else []),
        (
            "energy that the method itself has added (+) or lost (-)",
            f"{sum(shares):+.2g} % of the energy put in (stress integration {shares[0]:+.2g} %, transfer between particles and grid "
            f"{shares[1]:+.2g} %)",
        )
    ]


def cost_rows(summary):
    if "wall_seconds" not in summary:
        return []
    ranks = "1 rank" if summary["ranks"] == 1 else f"{summary['ranks']} ranks"
    return [
        ("wall time", f"{summary['wall_seconds']:.1f} s on {ranks}"),
        ("per particle-step", f"{summary['ns_per_particle_step']:.0f} ns"),
        ("state per particle", f"{summary['bytes_per_particle']:.0f} bytes"),
    ]


def run_rows(summary, history, depth):
    """What a run is, where it came to, and what it cost."""
    state = "finished" if summary.get("finished") else summary.get("reason", "not finished")
    rows = [("deck", summary.get("deck", "")), ("result", state)]
    rows += [("time", f"{history['time'] / MICRO:.4g} µs"), ("steps", f"{history['step']:.0f}"),
        ("particles", f"{history['particles']:.0f}")]
    rows += depth_rows(summary, depth) + energy_rows(summary)
    errors = (history[f"{name}_error"] for name in ("energy", "mass", "momentum"))
    rows.append(("what the balances then leave over", "energy {:+.2e}, mass {:+.1e}, axial momentum {:+.1e}".format(*errors)))
    removed = sum(value for name, value in history.items() if name.startswith("removed_")) - history["removed_kinetic"]
    return rows + [("particles removed", f"{removed:.0f}"), ("held", f"{history['held']:.0f}")] + cost_rows(summary)
