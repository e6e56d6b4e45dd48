#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Order and interval of `barreno converge`, against sequences whose order is known exactly."""
import json
import math
import pathlib
import tempfile

from barreno.converge import levels, order, report

LIMIT, SLOPE = 93.5, -7.0


def power_law(cells, p):
    return [LIMIT + SLOPE * h**p for h in cells]


def check_power_laws():
    """The order, the limit and the interval of f = f0 + C h^p, with equal and with unequal ratios, falling or growing."""
    for p in (0.6, 1.0, 1.5, 2.0):
        for cells in ([0.5, 1.0, 2.0], [0.25, 0.5, 1.0, 2.0], [1.0, 1.5, 2.7], [0.3, 0.9, 1.2]):
            for sign in (1.0, -1.0):
                values = [sign * value for value in power_law(cells, p)]
                found = order.judge(cells, values)
                assert found.kind == order.CONVERGES, f"{p}, {cells}: {found}"
                assert abs(found.order - p) < 1e-9 and abs(found.limit - sign * LIMIT) < 1e-9, f"{p}, {cells}: {found}"
                width = 1.25 * abs(LIMIT - sign * values[0])
                assert abs(found.high - found.low - 2.0 * width) < 1e-9 and abs(found.low + width
                    - values[0]) < 1e-9, f"{p}, {cells}: {found}"


def check_published():
    """The example of Celik et al. (2008), table 1: reattachment length on 18000, 8000 and 4500 cells, of r = 1.5 and 1.333; p = 1.53,
    extrapolated 6.1685, GCI 2.2 %."""
    cells = [1.0, 1.5, 1.5 * 1.333]
    found = order.judge(cells, [6.063, 5.972, 5.863])
    assert abs(found.order - 1.53) < 0.01 and abs(found.limit - 6.1685) < 1e-3, found
    assert abs((found.high - found.value) / found.value - 0.022) < 5e-4, found


def check_limited_order():
    """An order above the formal one is not used: the interval is that of the formal order, with the factor of two levels unless the orders
    are near each other."""
    cells = [0.5, 1.0, 2.0]
    found = order.judge(cells, power_law(cells, 3.0), formal=2.0)
    assert found.kind == order.CONVERGES and abs(found.order - 3.0) < 1e-9 and found.order_used == 2.0, found
    step = abs(SLOPE) * (1.0 - 0.125)
    assert abs(found.high - found.value - 3.0 * step / 3.0) < 1e-12, found
    near = order.judge(cells, power_law(cells, 2.15), formal=2.0)
    step = abs(near.value - power_law(cells, 2.15)[1])
    assert near.order_used == 2.0 and abs(near.high - near.value - 1.25 * step / 3.0) < 1e-12, near


REFUSED = {  # what: (cells, values, words of judge, kind, words of the sentence)
    "oscillating": ([0.5, 1, 2], [5.0, 6.0, 5.5], {}, order.OSCILLATES, "change their sign"),
    "diverging": ([0.5, 1, 2], [1.0, 3.0, 4.0], {}, order.DIVERGES, "do not fall"),
    "constant differences": ([0.5, 1, 2], [1.0, 2.0, 3.0], {}, order.DIVERGES, "do not fall"),
    "low order": ([0.5, 1, 2], power_law([0.5, 1, 2], 0.4), {}, order.OUT_OF_RANGE, "0.40, is outside of 0.5 to 4"),
    "high order": ([0.5, 1, 2], power_law([0.5, 1, 2], 5.0), {}, order.OUT_OF_RANGE, "5.00, is outside of 0.5 to 4"),
    "order above that of a method of first order": ([0.5, 1, 2], power_law([0.5, 1, 2], 2.5), {"formal": 1.0}, order.OUT_OF_RANGE,
        "0.5 to 2"),
    "two that agree": ([0.5, 1, 2], [4.0, 4.0, 5.0], {}, order.OUT_OF_RANGE, "above any bound"),
    "two levels": ([0.5, 1], [4.0, 5.0], {}, order.FEW, "two levels"),
    "unresolved": ([0.5, 1, 2], power_law([0.5, 1, 2], 1.0), {"resolved": 1}, order.UNRESOLVED, "wider than the radius"),
    "two that resolve and differ": ([0.5, 1, 2], [88.2, 80.0, 79.5], {"resolved": 2}, order.UNRESOLVED, "wider than the radius"),
}


def check_refusals():
    """No limit without an order, and the spread of the levels instead, with the reason."""
    for what, (cells, values, words, kind, said) in REFUSED.items():
        found = order.judge(cells, values, **words)
        assert found.kind == kind and found.limit is None and found.order_used is None, f"{what}: {found}"
        width = max(values) - min(values)
        assert abs(found.low - (values[0] - width)) < 1e-12 and abs(found.high - (values[0] + width)) < 1e-12, f"{what}: {found}"
        sentence = order.sentence(found, words.get("formal", 2.0))
        assert said in sentence and "without a level of confidence" in sentence, f"{what}: {sentence}"


def check_two_that_agree():
    """Depths of 88.2, 88.0 and 79.5 mm, the last with cells that do not resolve the jet: the spread, 79.5 to 96.9 mm, says less than the
    two that do."""
    cells = [0.5, 1.0, 2.0]
    found = order.judge(cells, [88.2, 88.0, 79.5], resolved=2)
    assert (
        found.kind == order.TWO_AGREE and found.limit is None and found.order_used is None and 86.5 < found.low < 88.0
        and 88.4 < found.high < 90.0
    ), found
    assert order.judge(cells, [88.2, 88.0, 79.5], resolved=1).kind == order.UNRESOLVED
    said = order.sentence(found)
    assert "are left out" in said and "agree to 2 %" in said and "3 times" in said, said


def check_coverage():
    """The interval of two that agree holds the limit of every sequence, whatever the cells say that do not resolve it."""
    count = 0
    for ratio in (1.3, 1.5, 2.0, 3.0, 4.0):
        cells = [1.0, ratio, ratio**2]
        for p in (0.5, 0.6, 0.75, 1.0, 1.5, 2.0, 3.0):
            for slope in (-3.0, -1.0, -0.3, 0.02, 0.3, 1.0, 3.0):
                for second in (0.0, 0.3 * slope, slope):  # a term of twice the order beside the first
                    values = [LIMIT + slope * h**p + second * h ** (2.0 * p) for h in cells]
                    for coarse in (values[2], 0.5 * LIMIT, 0.9 * LIMIT, 1.2 * LIMIT):
                        found = order.judge(cells, [*values[:2], coarse], resolved=2)
                        if found.kind != order.TWO_AGREE:
                            assert found.kind in (order.UNRESOLVED, order.EQUAL), found
                            continue
                        count += 1
                        assert found.low <= LIMIT + 1e-9 and LIMIT - 1e-9 <= found.high, (
                            f"ratio {ratio}, order {p}, slope {slope}, {second}: {found}"
                        )
    assert count > 300, count


def check_equal_by_chance():
    """Two errors of opposite sign that happen to be equal: the difference to the cells left out widens the interval."""
    found = order.judge([0.5, 1.0, 2.0], [90.0, 90.0, 80.0], resolved=2)
    assert found.kind == order.TWO_AGREE and found.high - found.low > 3.0, found


def check_names():
    """Cells are named with where they lie: those along the path of a jet are smaller than the others."""
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        deck = '<ParameterList><ParameterList name="Jet"><Parameter name="Cells Per Radius" value="{}"/></ParameterList></ParameterList>'
        for along, shares, name in (
            ("1.8", {"0.555556 mm": 0.7, "1.11111 mm": 0.3}, "0.001111 m (0.0005556 m along the jet's path)"),
            ("0", {"0.555556 mm": 0.7, "1.11111 mm": 0.3}, "0.001111 m (0.0005556 m where refined)"), ("1.8", None, "0.001111 m"),
        ):  # fmt: skip
            (folder / "summary.json").write_text(json.dumps({"particle_steps_by_cell_size": shares} if shares else {}))
            level = levels.Level([], deck.format(along), folder, cells=1.0 / 900.0)
            assert level.name() == name, level.name()
            assert name in report.table("depth", [level], [(1e-5, [0.09], order.spread(order.FEW, [0.09]))])
    assert '--set "Grid/Cell Size=0.0005 m" --set "Jet/Cells Per Radius=8.0"' in report.offer(["Grid/Cell Size=0.0005 m",
        "Jet/Cells Per Radius=8.0"])


def check_equal():
    found = order.judge([0.5, 1, 2], [3.0, 3.0, 3.0])
    assert found.kind == order.EQUAL and found.limit == found.low == found.high == 3.0 and order.sentence(found) == "", found
    assert order.judge([0.5, 1, 2], [0.0, 0.0, 0.0]).kind == order.EQUAL


def check_three_smallest():
    """What coarser levels do does not count."""
    cells = [0.25, 0.5, 1.0, 2.0]
    found = order.judge(cells, [*power_law(cells[:3], 1.0), 1e3])
    assert abs(found.order - 1.0) < 1e-9, found


def check_equation():
    """right_side is the equation of the module's text."""
    p, r21, r32 = 1.3, 1.4, 2.2
    assert math.isclose(order.right_side(p, r21, r32), r21**p * (r32**p - 1) / (r21**p - 1), rel_tol=1e-12)
    try:
        order.observed_order([1.0, 0.5, 2.0], [1.0, 2.0, 3.0])
    except ValueError:
        return
    raise AssertionError("cells that do not grow were taken")


def check_cells():
    """Cells along the path of a jet are halved with the others; a deck without such cells is left alone."""
    deck = '<ParameterList><ParameterList name="Grid"><Parameter name="Cell Size" value="0.001"/></ParameterList>{}</ParameterList>'
    jet = '<ParameterList name="Jet"><Parameter name="Cells Per Radius" value="{}"/></ParameterList>'
    assert levels.cell_settings(deck.format(""), 5e-4) == ["Grid/Cell Size=0.0005 m"]
    assert levels.cell_settings(deck.format(jet.format("0")), 5e-4) == ["Grid/Cell Size=0.0005 m"]
    assert levels.cell_settings(deck.format(jet.format("4")), 5e-4) == ["Grid/Cell Size=0.0005 m", "Jet/Cells Per Radius=8.0"]


def check_measured_error():
    """What the smallest cells were measured to do to a depth, or why that is unknown; nothing without a jet, or of another quantity."""

    class Named:
        def __init__(self, name):
            self.name = name

    known = {"value": -0.07, "low": -0.15, "high": -0.03, "cells_per_radius": 1.0, "source": "measured"}
    cases = [
        ({"depth_error": known}, "which are 1 per jet radius: -7 % (-15 to -3 %), measured."),
        ({"depth_error": {"unknown": "it was measured until 90 us only"}}, "(it was measured until 90 us only); the interval above"),
        ({}, ""),
    ]
    with tempfile.TemporaryDirectory() as scratch:
        level = levels.Level([], "", pathlib.Path(scratch), cells=1e-3)
        for penetration, words in cases:
            (level.folder / "summary.json").write_text(json.dumps({"penetration": penetration}))
            line = report.measured_error(Named("depth"), level)
            assert words in line and bool(words) == bool(line), line
            assert report.measured_error(Named("kinetic"), level) == ""


def main():
    for check in (check_measured_error, check_cells, check_equation, check_power_laws, check_published, check_limited_order, check_refusals,
                  check_equal, check_three_smallest, check_two_that_agree, check_coverage, check_equal_by_chance, check_names):
        check()
    print("orders and intervals are those of the sequences")


if __name__ == "__main__":
    main()
