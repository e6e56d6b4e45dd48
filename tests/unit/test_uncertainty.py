#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The parts of `barreno uncertainty` without a run: intervals and shares of functions whose answers are known, ranges and where they come
from, decks with other jets, designs, words and picture."""
import argparse
import json
import math
import pathlib
import tempfile
import xml.etree.ElementTree as xml

import numpy

from barreno import places
from barreno.compare.results import Row
from barreno.fit import card as fitted_card
from barreno.runs.effective_deck import value_in
from barreno.runs.faults import Fault
from barreno.uncertainties import answers, command, decks, design, known, picture, ranges, report, spread, words
from barreno.uncertainties.ranges import Range
from refusals import refused

NORMAL_90 = 1.6449  # of standard deviations to either side


def near(found, wanted, within):
    assert abs(found - wanted) <= within, f"{found} is not within {within} of {wanted}"


def hypercube(dimensions, runs, seed):
    return numpy.array(design.latin(range(dimensions), runs, seed))


def linear(shares, slopes):
    return 10.0 + (2.0 * shares - 1.0) @ numpy.array(slopes)


def check_exact_line():
    """Without scatter the shares are those of the slopes, b^2 over their sum, and the interval that of the sum of even distributions."""
    shares = hypercube(3, 24, 1)
    found = spread.by_regression(shares, linear(shares, (3.0, -2.0, 1.0)))
    for effect, wanted, slope in zip(found.effects, (9 / 14, 4 / 14, 1 / 14), (3.0, -2.0, 1.0)):
        near(effect.share, wanted, 1e-9)
        assert effect.told and math.isclose(effect.at_high, slope) and math.isclose(effect.at_low, -slope), effect
    near(found.rest, 0.0, 1e-9)
    near(found.foretold, 1.0, 1e-9)
    one = spread.by_regression(shares[:, :1], linear(shares[:, :1], (5.0,)))
    near(one.low, 10.0 - 0.9 * 5.0, 0.06)  # an even distribution from 5 to 15
    near(one.high, 10.0 + 0.9 * 5.0, 0.06)
    near(one.median, 10.0, 0.15)


def normal_content(low, high, slopes, sigma, generator):
    """Part of all cases of a line with scatter that an interval holds."""
    cases = linear(generator.uniform(0.0, 1.0, (4000, len(slopes))), slopes) + sigma * generator.standard_normal(4000)
    return float(((cases >= low) & (cases <= high)).mean())


def check_coverage():
    """Over many small samples the interval holds 90 % of new cases in the mean, and shares and scatter are right in the mean; also with as
    many ranges as a card has."""
    for slopes, sigma in (((3.0, 2.0, 1.0), 1.0), ((2.0, *(0.0,) * 11), 0.5), ((0.0, 0.0), 1.0)):
        generator, contents, found = numpy.random.default_rng(5), [], []
        for seed in range(120):
            shares = hypercube(len(slopes), 24, seed)
            one = spread.by_regression(shares, linear(shares, slopes) + sigma * generator.standard_normal(24))
            contents.append(normal_content(one.low, one.high, slopes, sigma, generator))
            found.append([effect.share for effect in one.effects] + [one.rest])
        near(float(numpy.mean(contents)), 0.9, 0.02)
        variances = numpy.array([slope**2 / 3.0 for slope in slopes] + [sigma**2])
        for mean, wanted in zip(numpy.mean(found, axis=0), variances / variances.sum()):
            near(float(mean), float(wanted), 0.06)


def check_selection():
    """Fewer runs than ranges: the interval holds nearly its part of new cases, whether few ranges matter or all alike; the clear ones are
    found with their shares, and others hardly ever."""
    for slopes, sigma in (((3.0, 2.0, *(0.0,) * 33), 1.0), ((0.0,) * 35, 1.0), ((1.0,) * 35, 1.0)):
        generator, contents, found, told = numpy.random.default_rng(5), [], [], []
        for seed in range(40):
            shares = hypercube(len(slopes), 24, seed)
            one = spread.of_hypercube(shares, linear(shares, slopes) + sigma * generator.standard_normal(24))
            contents.append(normal_content(one.low, one.high, slopes, sigma, generator))
            found.append([effect.share for effect in one.effects])
            told.append([effect.told for effect in one.effects])
        near(float(numpy.mean(contents)), 0.9, 0.03)
        if slopes[0] == slopes[1]:
            continue
        for mean, wanted in zip(numpy.mean(found, axis=0)[:2], (9.0 / 16.0, 4.0 / 16.0)):
            near(float(mean), wanted, 0.1)
        assert numpy.mean(told, axis=0)[0] > 0.9 and numpy.sum(told, axis=1).mean() < 2.4, numpy.mean(told, axis=0)


def check_selected_exactly():
    """Without scatter a line of two of many ranges is found as it is; a constant has no effects."""
    shares = hypercube(30, 20, 3)
    slopes = numpy.zeros(30)
    slopes[[4, 17]] = 3.0, -1.0
    found = spread.of_hypercube(shares, linear(shares, slopes))
    assert [j for j, effect in enumerate(found.effects) if effect.told] == [4, 17], found
    near(found.effects[4].at_high, 3.0, 1e-9)
    near(found.foretold, 1.0, 1e-9)
    assert not any(effect.told for effect in spread.of_hypercube(shares, numpy.full(20, 2.0)).effects)


def check_told():
    """A range without effect is called so in nine of ten samples."""
    generator, told = numpy.random.default_rng(6), []
    for seed in range(200):
        shares = hypercube(3, 24, seed)
        one = spread.by_regression(shares, linear(shares, (3.0, 0.0, 0.0)) + generator.standard_normal(24))
        assert one.effects[0].told, seed
        told += [effect.told for effect in one.effects[1:]]
    near(float(numpy.mean(told)), 0.1, 0.04)


def ishigami(shares):
    """sin x1 + 7 sin^2 x2 + 0.1 x3^4 sin x1, x from -pi to pi. First order shares 0.314, 0.442 and 0."""
    x = numpy.pi * (2.0 * shares - 1.0)
    return numpy.sin(x[:, 0]) + 7.0 * numpy.sin(x[:, 1]) ** 2 + 0.1 * x[:, 2] ** 4 * numpy.sin(x[:, 0])


def check_ishigami():
    """A function that bends and mixes: the shares are called doubtful, the second range's 0.442 is not found, the rest says how much is
    missing, and the interval still holds nearly its part."""
    cases = ishigami(numpy.random.default_rng(7).uniform(0.0, 1.0, (20000, 3)))
    contents, rests = [], []
    for seed in range(60):
        shares = hypercube(3, 24, seed)
        found = spread.by_regression(shares, ishigami(shares))
        answer = answers.Answer("y", "y", "", 1.0, list(ishigami(shares)), runs=found)
        contents.append(float(((cases >= found.low) & (cases <= found.high)).mean()))
        rests.append(found.rest)
        assert found.effects[1].share < 0.35, found
        if found.foretold < spread.FAIR:
            assert len(report.doubts([answer])) == 1 and "The shares say little" in report.doubts([answer])[0]
        else:
            assert seed not in range(20), (seed, found.foretold)
    near(float(numpy.mean(contents)), 0.9, 0.04)
    assert numpy.mean(rests) > 0.5, rests


def check_parabolas():
    """One at a time: curves of second order and their variances are exact, wherever the middle is."""
    u = numpy.linspace(0.0, 1.0, 200001)
    for a, b, middle in ((2.0, -1.0, 0.5), (-3.0, 4.0, 0.2), (0.0, 1.0, 0.9)):
        curve = lambda x, a=a, b=b: a * x * x + b * x  # noqa: E731
        got = spread.parabola(middle, curve(0.0) - curve(middle), curve(1.0) - curve(middle))
        near(got[0], a, 1e-9)
        near(got[1], b, 1e-9)
        near(got[2], -curve(middle), 1e-9)
        near(spread.variance_of(a, b), float(numpy.var(curve(u))), 1e-5)
    rows = design.one_at_a_time([given(own=0.2), given(own=0.5)])
    assert rows == [[0.2, 0.5], [0.0, 0.5], [1.0, 0.5], [0.2, 0.0], [0.2, 1.0]], rows
    found = spread.one_at_a_time(rows, [4.0 * x * x + 2.0 * y for x, y in rows])
    total = 16.0 * 4.0 / 45.0 + 4.0 / 12.0
    near(found.effects[0].share, 16.0 * 4.0 / 45.0 / total, 1e-9)
    near(found.effects[1].share, 4.0 / 12.0 / total, 1e-9)
    cases = numpy.random.default_rng(8).uniform(0.0, 1.0, (200000, 2))
    for end, part in (("low", 0.05), ("median", 0.5), ("high", 0.95)):
        near(getattr(found, end), float(numpy.quantile(4.0 * cases[:, 0] ** 2 + 2.0 * cases[:, 1], part)), 0.05)
    assert found.rest is None and found.foretold is None


def check_order_statistics():
    """Of 24 runs, by the formula and by trial."""
    near(spread.confidence_of_span(24), 1.0 - 24 * 0.9**23 + 23 * 0.9**24, 1e-12)
    trials = numpy.random.default_rng(9).uniform(0.0, 1.0, (20000, 24))
    near(float((trials.max(axis=1) - trials.min(axis=1) >= 0.9).mean()), spread.confidence_of_span(24), 0.01)
    assert report.percent(spread.confidence_of_span(24)) == "71 %"


def given(path="A/B", low=0.0, high=1.0, own=0.5, **more):
    return Range(path, f"{low:g}", f"{high:g}", low=low, high=high, own=own, given_by=f'--vary "{path}"', **more)


def rows_of(depths, **more):
    return [Row(f"run {i}", pathlib.Path("x"), [], scalars={"penetration.depth": depth, **more}) for i, depth in enumerate(depths)]


def check_cells():
    """Depths that cells of that size make too small are made larger; an error that one run does not know is not counted, and said."""
    error = {"penetration.depth_error.low": -0.33, "penetration.depth_error.value": -0.2, "penetration.depth_error.high": -0.1}
    shares = hypercube(1, 24, 1)
    depths = list(0.01 * linear(shares, (1.0,)))
    found, remarks = answers.answers_of(rows_of(depths, **error), [])
    answers.analyse_all(found, words.LATIN, shares, rows_of(depths, **error))
    (depth,) = found
    assert not remarks and not depth.cells_unknown
    near(depth.runs.low, 0.091, 5e-4)
    near(depth.runs.high, 0.109, 5e-4)
    near(depth.whole.low, depth.runs.low / 0.9, 1e-12)
    near(depth.whole.median, depth.runs.median / 0.8, 1e-12)
    near(depth.whole.high, depth.runs.high / 0.67, 1e-12)
    said = report.sentence(depth, [given("Materials/Rock/FSLOPE")])
    assert said.startswith("Depth 125 mm, 101 to 163 mm at 90 % (with the measured error of the cells; the runs themselves 100 mm)"), said
    assert said.endswith("of its variance 100 % from Rock/FSLOPE."), said
    rows = rows_of(depths, **error)
    for row in rows[:3]:
        row.scalars = {"penetration.depth": row.scalars["penetration.depth"], "penetration.depth_error.unknown": "it was never measured"}
    answers.analyse_all(found, words.LATIN, shares, rows)
    assert found[0].cells_unknown == "it was never measured (3 of 24 runs)", found[0]
    said = report.sentence(found[0], [given()])
    why = "(the error of the cells is not in it: it was never measured (3 of 24 runs))"
    assert said.startswith(f"Depth 100 mm, 91 to 109 mm at 90 % {why}"), said


def check_cells_of_flow():
    """The error of the core flow efficiency counts with --flow radial, for which it was measured, and with nothing else."""
    error = {f"penetration.core_flow_efficiency_error.{end}": value for end, value in (("low", -0.2), ("value", 0.0), ("high", 0.25))}
    shares = hypercube(1, 24, 1)
    flows = 0.2 + 0.01 * linear(shares, (1.0,))
    rows = [Row(f"run {i}", pathlib.Path("x"), [], scalars={answers.EFFICIENCY: flow, **error}) for i, flow in enumerate(flows)]
    (found,), remarks = answers.answers_of(rows, [])
    assert not remarks, remarks
    answers.analyse_all([found], words.LATIN, shares, rows, "radial")
    assert found.cells_unknown == "", found
    near(found.whole.low, found.runs.low / 1.25, 1e-12)
    near(found.whole.high, found.runs.high / 0.8, 1e-12)
    answers.analyse_all([found], words.LATIN, shares, rows, "axial")
    assert found.whole is None and found.cells_unknown == "it was measured for radial flow alone", found


def check_left_out():
    """No depth behind a target, none that a run lacks, none that is always the same; a number that is asked for, and lengths above 0."""
    for more, depths, said in (({"penetration.through": True}, [1.0, 2.0], "depth is left out: the jet has come out of the rear"),
            ({}, [1.0, None], "1 of 2 runs have no such number"), ({}, [1.0, 1.0], "it is the same in all runs")):
        found, remarks = answers.answers_of(rows_of(depths, **more), [])
        assert not found and len(remarks) == 1 and said in remarks[0], remarks
    found, remarks = answers.answers_of(rows_of([1.0, 2.0], **{"penetration.zones_in_body.Rock.skin": 3.0}), ["steps", "penetration.depth"])
    assert [one.words for one in found] == ["depth"] and len(remarks) == 2 and remarks[1].startswith("steps is left out"), remarks
    shares = hypercube(1, 4, 3)
    found, _ = answers.answers_of(rows_of([0.0, 0.001, 0.0, 0.001]), [])
    answers.analyse_all(found, words.LATIN, shares, rows_of([0.0] * 4))
    assert found[0].runs.low == 0.0 < found[0].runs.high, found[0].runs


def check_ranges(folder):
    """Wide ranges are drawn in their logarithm; a file comes back as it was written; what is wrong with one is a sentence."""
    assert [given(low=1.0, high=9.0).value_at(share) for share in (0.0, 0.5, 1.0)] == [1.0, 3.0, 9.0]
    assert [given(low=1.0, high=2.0).value_at(share) for share in (0.0, 0.5, 1.0)] == [1.0, 1.5, 2.0]
    near(given(low=-9.0, high=-1.0).value_at(0.5), -3.0, 1e-12)
    assert not given(low=-1.0, high=9.0).is_wide() and given(low=1.0, high=9.0, own=3.0).share_of_own() == 0.5
    assert given(low=1.0, high=2.0, own=1.25).share_of_own() == 0.25 and given(low=1.0, high=2.0, own=5.0).share_of_own() == 0.5
    one = ranges.read_word("Materials/Rock/B0=3..15 GPa")
    assert (one.path, one.low_text, one.high_text, one.known) == ("Materials/Rock/B0", "3 GPa", "15 GPa", "given"), one
    file = folder / "a.csv"
    file.write_text(ranges.as_csv([one, Range("A/B", "1", "2", "seen", 'a "page", 2')]))
    assert [(two.path, two.low_text, two.high_text, two.known, two.source) for two in ranges.read_file(file)] == [
        ("Materials/Rock/B0", "3 GPa", "15 GPa", "given", "--vary"), ("A/B", "1", "2", "seen", 'a "page", 2')]
    for text, said in (("", "is not a table of ranges (it has no line of names)"), ("parameter,low\nA,1\n", "has no column high"),
            ("parameter,low,high\n", "has no ranges"), ("parameter,low,high\nA,1\n", "line 2 has 2 columns"),
            ("parameter,low,high\nA/B,x,2\n", '"A/B": low is "x", which is no number'),
            ("parameter,low,high,known\nA/B,1,2,guessed\n", '"guessed" does not say how the range is known')):
        file.write_text(text)
        refused(lambda: ranges.read_file(file), str(file), said)


def check_settled():
    """Both ends are asked of the program; what it refuses names the range. Factors of the jet are plain numbers."""
    deck = '<ParameterList><ParameterList name="A"><Parameter name="B" value="{}"/></ParameterList></ParameterList>'

    def effective(settings):
        number = float(settings[0].partition("=")[2].split()[0])
        if number > 5.0:
            raise Fault("a.xml: A/B = 9 is out of bounds (it must be below 5); choose a value in that range.")
        return deck.format(1e6 * number)

    one = ranges.read_word("A/B=1..3 MPa")
    ranges.settle(one, deck.format(2e6), effective)
    assert (one.low, one.high, one.own) == (1e6, 3e6, 2e6), one
    refused(lambda: ranges.settle(ranges.read_word("A/B=1..9 MPa"), deck.format(2e6), effective),
        '--vary "A/B": the end 9 MPa of the range is refused (a.xml: A/B = 9 is out of bounds', "narrow the range")
    refused(lambda: ranges.settle(Range("A/B", "3", "2", given_by="a.csv, A/B"), deck.format(1.0), effective),
        "a.csv, A/B: the range 3 to 2 is empty")
    refused(lambda: ranges.settle(ranges.read_word("A/B=1..3"), deck.format("fast"), effective), 'is "fast", which is no number')
    for text in ("-1..1", "0..1", "1..2 km/s"):
        refused(lambda text=text: ranges.settle(ranges.read_word(f"Jet/Velocity={text}"), deck, effective), "is no factor of the jet")


JET = """<ParameterList name="Barreno"><ParameterList name="Materials"><ParameterList name="Rock">
<Parameter name="Model" value="Arenisca"/><Parameter name="B0" value="6.74e9"/><Parameter name="G0" value="5.703e9"/>
<Parameter name="G1" value="0.17"/><Parameter name="Weibull modulus" value="8"/><Parameter name="Weibull seed" value="3"/>
<Parameter name="Weibull scatter" value="random"/></ParameterList></ParameterList>
<ParameterList name="Shapes"></ParameterList><ParameterList name="Bodies"></ParameterList>
<ParameterList name="Confinement"><Parameter name="Pressure" value="2e7"/></ParameterList>
<ParameterList name="Jet"><Parameter name="Slugs" value="2x5:{0, 8000, 0.001, 0.002, 17600, 1e-6, 6000, 0.0015, 0.002, 17600}"/>
<Parameter name="Pieces Below" value="5000"/><Parameter name="Cells Per Radius" value="1.8"/></ParameterList></ParameterList>"""


def check_jets():
    """A faster jet of the same origin: slugs are as long, and as far from each other when they cross the plane; cells stay as they are."""
    deck = decks.with_jet(JET, 1.25, 0.9)
    head, numbers = decks.rows_in(value_in(deck, "Jet/Slugs"))
    assert head == "2x5:" and len(numbers) == 10, head
    before = decks.rows_in(value_in(JET, "Jet/Slugs"))[1]
    for i, factor in enumerate((1.0 / 1.25, 1.25, 0.9, 1.0, 1.0)):
        for row in (0, 5):
            near(numbers[row + i], before[row + i] * factor, 1e-12 * before[row + i])
    near(numbers[5] * numbers[6], before[5] * before[6], 1e-12)
    near(float(value_in(deck, "Jet/Pieces Below")), 6250.0, 1e-9)
    assert 0.0 < 0.9 * 1.8 - float(value_in(deck, "Jet/Cells Per Radius")) < 1e-7
    assert value_in(decks.with_jet(JET, 1.0, 1.0), "Materials/Rock/B0") == "6.74e9"
    refused(lambda: decks.check_jet("<a/>", [given("Jet/Radius")]), "the deck has no Jet", "--hold Jet")
    cup = '<ParameterList name="Cup"><Parameter name="File" value="cup.stl"/></ParameterList>'
    surface = JET.replace('name="Shapes">', f'name="Shapes">{cup}')
    refused(lambda: decks.check_jet(surface, [given("Jet/Radius")]), "a surface from a file (Shapes/Cup)")
    decks.check_jet(surface, [given("Confinement/Pressure")])


def check_cells_for_all():
    """Where the deck leaves them open, cells suit the thinnest jet in all runs; cells that the deck gives stay."""
    shapes, size = '<ParameterList name="Shapes">', '<Parameter name="Cell Size" value="SIZE"/>'
    grid = JET.replace(shapes, f'<ParameterList name="Grid">{size}</ParameterList>{shapes}')

    def with_size(size):
        return grid.replace("SIZE", str(size))

    def effective(text):
        """As the program: cells that are open are as large as the radius of the thinnest slug."""
        open_cells = '"Cell Size"' not in text
        radius = decks.rows_in(value_in(text, "Jet/Slugs"))[1][2]
        return with_size(radius) if open_cells else text

    near(decks.cells_for_all(with_size(0.001), 0.9, effective), 0.0009, 1e-15)
    assert decks.cells_for_all(with_size(0.001), 1.0, effective) == 0.001 and decks.cells_for_all(with_size(0.002), 0.9, effective) == 0.002
    deck = decks.with_jet(decks.with_cells(with_size(0.001), 0.0009), 1.0, 1.1, 0.9)
    assert decks.cells_of(deck) == 0.0009
    near(float(value_in(deck, "Jet/Cells Per Radius")), 1.8 * 1.1 / 0.9, 1e-7)
    assert command.least_radius([given("Jet/Radius", low=0.9), given("Jet/Velocity", low=0.5)]) == 0.9
    assert command.least_radius([given("Jet/Velocity", low=0.5)]) == 1.0


def check_settings():
    """The shear modulus of unstressed rock follows; rock of scattered strength gets a seed of its own in each run."""
    (one, tied) = decks.settings_of(JET, {"Materials/Rock/B0": 1e10, "Jet/Velocity": 1.1})
    assert one == "Materials/Rock/B0=1e+10" and tied.startswith("Materials/Rock/G0="), (one, tied)
    near(float(tied.partition("=")[2]), 1.5 * 1e10 * (1.0 - 0.34) / 1.17, 10.0)
    assert decks.settings_of(JET, {"Confinement/Pressure": 2.0}) == ["Confinement/Pressure=2"]
    assert len(decks.settings_of(JET.replace('"0.17"', '"0"'), {"Materials/Rock/B0": 1e10})) == 1
    assert decks.seed_settings(JET, 4) == ["Materials/Rock/Weibull seed=7"]
    assert decks.seed_settings(JET.replace("random", "scale only"), 4) == []


def card_values(file):
    return {entry.get("name"): float(entry.get("value")) for entry in xml.parse(file).getroot().iter("Parameter")
        if entry.get("type") == "double"}


def check_shipped_ranges():
    """Of each card: a known parameter, in whose range the card's value lies, with a mark and a source."""
    files = sorted((places.cards() / known.SHIPPED).glob("*.csv"))
    assert len(files) >= 12, files
    for file in files:
        card, found = card_values(places.cards() / f"{file.stem}.xml"), ranges.read_file(file)
        assert len({one.path for one in found}) == len(found), file
        for one in found:
            low, high = (ranges.si_of(text) for text in (one.low_text, one.high_text))
            assert low < high and low <= card[one.path] <= high, f"{file}: {one.path} = {card[one.path]} is not in {one.text()}"
            assert one.known in ranges.MARKS[:-1] and one.source, f"{file}: {one.path}"


def check_known(folder):
    """Ranges of a card: what fit wrote beside it, else those that are shipped; of jet and pressures an assumption that says so."""
    deck = folder / "deck.xml"
    deck.write_text('<ParameterList><ParameterList name="Materials"><ParameterList name="Rock"><Parameter name="Card" value="my.xml"/>'
        '</ParameterList><ParameterList name="Jet"><Parameter name="Card" value="Tungsten"/></ParameterList></ParameterList>'
        '</ParameterList>')
    options = argparse.Namespace(deck=deck, settings=[])
    assert known.cards_of(options) == {"Rock": "my.xml", "Jet": "Tungsten"}
    assert known.cards_of(argparse.Namespace(deck=deck, settings=["Materials/Rock/Card=brine", "Materials/Jet/Card="])) == {"Rock": "brine"}
    (folder / "my.xml").write_text(fitted_card.text_of({"Model": "Arenisca"}))
    lines = []
    found = known.known_ranges(options, JET, lines.append)
    assert lines == ["Rock is held: no ranges of the card my.xml are known (docs/uncertainty.md says where they are looked for)."], lines
    assert "Materials/Jet/Gruneisen" in [one.path for one in found], found
    by_path = {one.path: one for one in found}
    assert {by_path[path].known for path in ("Jet/Velocity", "Jet/Radius", "Confinement/Pressure")} == {"assumed"}
    assert by_path["Jet/Velocity"].text() == "0.98 to 1.02" and by_path["Confinement/Pressure"].text() == "19 MPa to 21 MPa", by_path
    entry = {"name": "FSLOPE", "low": 0.4, "high": 0.6}
    (folder / "my.json").write_text(json.dumps({"cards_tried": 3, "parameters": [entry, {"name": "CR", "low": None, "high": None}]}))
    (one,) = known.card_ranges("my", "Rock", deck)
    assert (one.path, one.text(), one.known) == ("Materials/Rock/FSLOPE", "0.4 to 0.6", "fitted"), one
    (folder / "my.json").write_text('{"cards_tried": 3, "parameters": [{}]}')
    refused(lambda: known.card_ranges("my", "Rock", deck), "my.json does not hold the ranges that fit writes")
    (folder / "my.json").write_text('{"another": "program"}')
    assert known.card_ranges("my", "Rock", deck) == [] and known.card_ranges("nowhere", "Rock", deck) == []
    lines.clear()
    kept = known.drop_changed([given("A/B", own=0.3), given("A/C", own=2.0), given("A/D"), given("Jet/Velocity", own=1.0)],
        argparse.Namespace(settings=["A/D=0.4"]), lines.append)
    assert [one.path for one in kept] == ["A/B", "Jet/Velocity"] and "lies outside of the known range" in lines[0], lines
    assert lines[1] == "A/D is held: --set fixes it.", lines


def check_designs():
    for name, count, least in ((words.LATIN, 5, 8), (words.ONE_AT_A_TIME, 5, 11)):
        options = argparse.Namespace(design=name, runs=least, seed=1)
        many = [given(f"A/{i}") for i in range(count)]
        assert len(design.shares_of(options, many)) == least
        options.runs -= 1
        refused(lambda options=options, many=many: design.shares_of(options, many), f"--runs {least - 1} is too few for 5 ranges",
            f"give --runs {least}")
    many = [given(f"A/{i}") for i in range(35)]
    assert len(design.shares_of(argparse.Namespace(design=words.LATIN, runs=12, seed=1), many)) == 12
    refused(lambda: design.shares_of(argparse.Namespace(design=words.LATIN, runs=11, seed=1), many), "--runs 11 is too few for 35 ranges",
        "needs 12: fewer show no range among so many")
    for column in hypercube(3, 20, 4).T:
        assert sorted(int(20 * share) for share in column) == list(range(20))
    assert design.middle_of(given(own=0.999)) == 0.5 == design.middle_of(given(own=None))


def check_words():
    here = __file__
    for more, said in ((["--jobs", "0"], "--jobs 0 is not a number of runs at a time"), 
            (["--runs", "2"], "--runs 2 is not a number of runs (3"),
            (["--runs", "20000"], "--runs 20000 is more than 10000"), (["--design", "grid"], "it is one of latin and one-at-a-time"),
            (["--seed", "-1"], "--seed -1 is below 0"), (["--ranks", "0"], "--ranks 0 is not a number of ranks"),
            (["--ranges", "nowhere.csv"], "nowhere.csv does not exist (needed as --ranges)")):  # fmt: skip
        refused(lambda more=more: words.check_words(words.parse([here, *more])), said)
    refused(lambda: words.check_words(words.parse(["a.xml"])), "a.xml does not exist (needed as the deck)")
    assert words.out_folder(words.parse(["x/a.xml"])) == pathlib.Path("runs/a-uncertainty")
    refused(lambda: command.check_held(["Jett"], ["Jet/Velocity"]), "--hold Jett names nothing that is varied (Jet/Velocity)")
    assert command.is_held("Jet/Velocity", ["Jet"]) and not command.is_held("Jet/Velocity", ["Je"])


def check_given(folder):
    """--vary goes before --ranges; a parameter has one range."""
    file = folder / "r.csv"
    file.write_text("parameter,low,high\nA/B,1,2\nA/C,3,4\n")
    found = command.given_ranges(argparse.Namespace(vary=["A/B=5..6"], ranges=str(file)))
    assert [(one.path, one.text()) for one in found] == [("A/B", "5 to 6"), ("A/C", "3 to 4")], found
    refused(lambda: command.given_ranges(argparse.Namespace(vary=["A/B=5..6", "A/B=5..7"], ranges=None)), '"A/B" is given twice')
    file.write_text("parameter,low,high\nA/B,1,2\nA/B,3,4\n")
    refused(lambda: command.given_ranges(argparse.Namespace(vary=[], ranges=str(file))), "stands twice")


def check_report(folder):
    """Tables and picture of answers of both designs."""
    ends = [given("Materials/Rock/$FSLOPE$"), given("Jet/Velocity"), given("Confinement/Pressure")]
    shares = hypercube(3, 24, 1)
    depths = 0.01 * linear(shares, (1.0, 0.5, 0.0)) + 1e-4 * numpy.random.default_rng(3).standard_normal(24)
    more = {"penetration.depth_error.unknown": "it was measured until 90 us only"}
    for way, rows, values in ((words.LATIN, shares, depths), (words.ONE_AT_A_TIME, design.one_at_a_time(ends), None)):
        values = 0.01 * linear(numpy.array(rows), (1.0, 0.5, 0.1)) if values is None else values
        found, _ = answers.answers_of(rows_of(list(map(float, values)), **more), [])
        answers.analyse_all(found, way, rows, rows_of(values, **more))
        lines = report.lines_of(found, ends, way, len(rows))
        assert any(line.split()[:2] == ["Rock/$FSLOPE$", "0"] and "given" in line for line in lines), lines
        assert "unknown" in lines[1] and lines[-1].count("\n") == 0 and "measured until 90 us only" in lines[-1], lines
        assert ("interaction and scatter" in "\n".join(lines)) == (way == words.LATIN)
        assert report.lines_of([], ends, way, 3) == ["No answer can be looked at."]
        numbers = json.loads(json.dumps(report.as_numbers(found, ends)))["penetration.depth"]
        assert numbers["with_cells"] is None and set(numbers["ranges"]["effects"]) == {one.path for one in ends}, numbers
        picture.draw(folder / f"{way}.png", found * 3, ends)
        assert (folder / f"{way}.png").read_bytes()[:4] == b"\x89PNG"
    assert [report.digits_for(*ends) for ends in ((122.0, 140.0), (4.3, 4.5), (0.0, 5000.0), (1.0, 1.0))] == [0, 2, 0, 0]


def check_selected_report(folder):
    """Of more ranges than runs: rows and bars of those that stand out alone, and a sentence that says so."""
    ends = [given(f"Materials/Rock/P{i}") for i in range(30)]
    shares = hypercube(30, 20, 1)
    depths = list(map(float, 0.01 * linear(shares, (1.0, 0.5, *(0.0,) * 28))))
    found, _ = answers.answers_of(rows_of(depths), [])
    answers.analyse_all(found, words.LATIN, shares, rows_of(depths))
    lines = report.lines_of(found, ends, words.LATIN, 20)
    assert [line.split()[0] for line in lines if line.split()[:1] and line.split()[0].startswith("Rock/")] == ["Rock/P0", "Rock/P1"], lines
    assert any(line.strip().startswith("interaction, scatter and other ranges") for line in lines), lines
    assert any("20 runs are too few for a share of each of 30 ranges" in line for line in lines), lines
    assert "80 % from Rock/P0 and 20 % from Rock/P1" in lines[-1], lines
    assert picture.shown(found[0], ends) == [1, 0]
    picture.draw(folder / "selected.png", found, ends)


def main():
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        for check in (check_exact_line, check_coverage, check_selection, check_selected_exactly, check_told, check_ishigami,
                check_parabolas, check_order_statistics, check_cells, check_cells_of_flow, check_left_out, check_settled, check_jets,
                check_cells_for_all, check_settings, check_shipped_ranges,
                check_designs, check_words):
            check()
        for check in (check_ranges, check_known, check_given, check_report, check_selected_report):
            (folder / check.__name__).mkdir()
            check(folder / check.__name__)
    print("intervals, shares, ranges, decks and designs are as docs/uncertainty.md says")


if __name__ == "__main__":
    main()
