#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The explorable view of a report in Chromium without a screen: its controls do what they say, values under the mouse are those of
particles.e, and the page asks the network for nothing.

    test_explore.py BARRENO [--pictures FOLDER]

Skipped without Chromium, its driver or Selenium (apt-get install chromium chromium-driver python3-selenium), which .ci/run has installed:
with BARRENO_ALL_TESTS set one of them missing is a failure. --pictures keeps what the browser showed.
"""
import json
import pathlib
import re
import sys
import tempfile
import time

import numpy as np
import pandas
import synthetic_run
from explore_page import View, browser
from matplotlib.colors import to_rgb

from barreno.report.hole import hole_at
from barreno.report.particles import ParticleFile
from barreno.report.pieces import pieces_of
from barreno.report.run import opened
from barreno.report.tones import RUBBLE
from python_commands import said_by
from tools.runs import run_deck

SHORT = {"Grid/Upper": "{80 mm, 130 mm}", "Bodies/Rock/Upper": "{50.8 mm, 112.7 mm}", "Time/End Time": "6 us",
    "Output/Field Interval": "2 us", "Output/Checkpoint Wall Interval": "0 s", "Jet/Cells Per Radius": "1"}
LONG = {**SHORT, "Bodies/Rock/Upper": "{22 mm, 112.7 mm}", "Bodies/Casing/Upper": "{22 mm, 12.7 mm}",
    "Time/End Time": "12 us", "Output/Field Interval": "4 us"}
BAD = "<script>document.title='bad'</script>"
CELL = 2.0  # mm, of the runs here: no particle is larger
NUMBER = re.compile(r"(-?[\d.]+(?:e[+-]?\d+)?) ± ([\d.]+(?:e[+-]?\d+)?)")


def number_in(text):
    """(value, greatest difference)"""
    found = NUMBER.match(text)
    assert found, f"'{text}' has no number with its precision"
    return float(found.group(1)), float(found.group(2))


def agrees(text, true, size):
    value, slack = number_in(text)
    assert abs(value - true / size) <= slack * (1.0 + 1e-6) + 1e-6 * abs(value), (text, true / size)
    return slack


def loose_of(run, step):
    """Whether a particle is rubble in the pictures of the report."""
    with opened(run) as known:
        frame = known.file.frame(step)
        shapes, of = frame.shapes
        found = np.zeros(len(frame.block), bool)
        found[of] = pieces_of(frame, known.deck, hole_at(known, known.depth_table(), frame)).rubble
        return found


def check_rubble(view, run):
    """Pieces of rock that the report calls loose are drawn in the colour of rubble, are found as such, and can be left out."""
    expected = int(loose_of(run, -1).sum())
    assert expected > 5, f"the run has {expected} loose pieces"
    colour = ("return [...document.querySelectorAll('#explore-switches label')].find(one => one.textContent === 'rubble')"
        "?.children[1].style.background;")
    assert view.driver.execute_script(colour) == "rgb({}, {}, {})".format(*(round(255 * part) for part in to_rgb(RUBBLE)))
    count = """
        const canvas = document.getElementById('explore-particles'), copy = document.createElement('canvas');
        [copy.width, copy.height] = [canvas.width, canvas.height];
        const pen = copy.getContext('2d', {willReadFrequently: true});
        pen.drawImage(canvas, 0, 0);
        const {data} = pen.getImageData(0, 0, copy.width, copy.height);
        let found = 0;
        for (let k = 0; k < data.length; k += 4)
          found += arguments[0].every((part, i) => data[k + i] === part);
        return found;"""
    tan = [round(255 * part) for part in to_rgb(RUBBLE)]
    before = view.pixels()
    assert view.driver.execute_script(count, tan) > 20
    view.switch("rubble")
    assert view.driver.execute_script(count, tan) == 0
    view.switch("rubble")
    assert view.pixels() == before


def check_values(view, run, step, fields):
    """What stands under the mouse is what particles.e has of that particle, within the precision that stands beside it.

    @param fields  {line: (name in the file, its unit in SI)}"""
    file = ParticleFile(run / "particles.e")
    frame = file.frame(step)
    loose = loose_of(run, step)
    columns, seen = {int(n): i for i, n in enumerate(file.numbers[frame.alive])}, set()
    values = {name: frame.of_alive([name]) for name, _ in fields.values()}
    for across, down in ((-0.3, 0.1), (0.2, 0.2), (0.01, -0.2), (-0.05, -0.05), (0.05, 0.3), (0.33, -0.3), (-0.15, 0.02)):
        lines = view.hover(across, down)
        if not lines["particle"].isdigit():
            continue
        row = columns[int(lines["particle"])]
        seen.add(row)
        assert lines["material"] == file.block_names[frame.block[row]] + (", rubble" if loose[row] else ""), lines
        for line, (name, size) in fields.items():
            if np.isfinite(values[name][row]):
                slack = agrees(lines[line], values[name][row], size)
                assert slack <= 0.01 * max(abs(values[name][row]) / size, 100.0), (lines, "is too coarse")
            else:
                assert lines[line] == "not of this material", lines
        for line, axis in (("r", 0), ("y", 1)):
            assert agrees(lines[line], frame.centres[row, axis], 1e-3) < 0.01, lines
    file.close()
    assert len(seen) >= 4, f"only {len(seen)} particles were found under the mouse"


def check_time(view, times):
    """Slider, buttons and keys change the time, and the curves' markers follow."""
    from selenium.webdriver.common.keys import Keys

    def at(step):
        return f"t = {times[step] / 1e-6:.4g} µs ({step + 1} of {len(times)})"

    last, before, where = len(times) - 1, view.pixels(), view.markers()
    assert view.text("when") == at(last) and len(where) >= 2, (view.text("when"), where)
    view.press(Keys.ARROW_LEFT)
    assert view.text("when") == at(last - 1) and view.pixels() != before
    assert all(now < then for now, then in zip(view.markers(), where)), (view.markers(), where)
    view.part("time").send_keys(Keys.HOME)
    view.settle()
    assert view.text("when") == at(0), view.text("when")
    view.click("on")
    assert view.text("when") == at(1), view.text("when")
    view.press(Keys.ARROW_RIGHT)  # the button keeps the focus
    assert view.text("when") == at(2), view.text("when")
    view.click("play")
    view.until(lambda: view.text("when") == at(last))
    view.click("play")
    view.part("time").send_keys(Keys.END)
    view.settle()
    assert view.text("when") == at(last) and view.pixels() == before and view.markers() == where


def check_instant(view, run, times):
    """At every output the curves' numbers are those of depth.csv then, and their lines move in proportion to the time."""
    from selenium.webdriver.common.keys import Keys

    table = pandas.read_csv(run / "depth.csv", comment="#")
    view.part("time").send_keys(Keys.HOME)
    where = []
    for step, time in enumerate(times):
        view.settle()
        assert view.text("when").startswith(f"t = {time / 1e-6:.4g} µs"), (view.text("when"), time)
        depth = float(np.interp(time, table["time"], table["depth"])) / 1e-3
        assert abs(float(view.curves()["depth"]) - depth) <= 1e-3 * depth + 1e-6, (view.curves(), depth)
        where.append(view.markers())
        if step + 1 < len(times):
            view.part("time").send_keys(Keys.ARROW_RIGHT)
    part = (times - times[0]) / (times[-1] - times[0])
    for one in np.transpose(where):
        assert np.abs(one - (one[0] + part * (one[-1] - one[0]))).max() < 1.0, (one, part)


def check_places(view):
    """The mouse finds particles where the axes say: y and r of what is under it follow its place, r so many times larger than y as the
    name of its axis has it."""
    size, found = view.part("stage").size, []
    ends = ("width", "height") if view.lying else ("height", "width")
    for across in (-0.4, -0.2, -0.15, 0.1, 0.15, 0.3):
        for along in (-0.2, 0.0, 0.2, 0.35):
            lines = view.hover(across, along)
            if lines["particle"].isdigit():
                found.append((along * size[ends[0]], abs(across) * size[ends[1]], number_in(lines["y"])[0], number_in(lines["r"])[0]))
    along, across, y, r = np.transpose(found)
    slopes = []
    for pixels, mm in ((along, y), (across, r)):
        line = np.polyfit(pixels, mm, 1)
        assert len(found) > 8 and line[0] > 0.0 and np.abs(np.polyval(line, pixels) - mm).max() < CELL, (found, line)
        slopes.append(float(line[0]))
    words = re.search(r", ([\d.]+) times larger than y", view.names()[0])
    stretch = float(words.group(1)) if words else 1.0
    assert abs(slopes[0] / slopes[1] - stretch) < 0.1 * stretch, (slopes, view.names())
    return stretch


def check_sides(view):
    """A field chosen for one side changes that side alone."""
    left, right = view.halves()
    view.choose("left", "density")
    assert view.halves()[0] != left and view.halves()[1] == right
    view.choose("left", "pressure")
    view.choose("right", "density")
    assert view.halves()[0] == left and view.halves()[1] != right
    view.choose("right", "equivalent_plastic_strain")
    assert view.halves() == [left, right]


def check_lying(view, run, times):
    """A long target lies, its hole over the whole width; closer at the tip proportions are true."""
    assert view.lying and "above" in view.text("side-left") and "below" in view.text("side-right")
    stage = view.part("stage")
    assert stage.size["width"] > 0.9 * view.driver.execute_script("return document.documentElement.clientWidth"), stage.size
    hole = view.pixels()
    view.click("whole")
    assert view.pixels() != hole
    check_places(view)
    check_sides(view)
    view.click("hole")
    assert view.pixels() == hole
    check_time(view, times)
    check_instant(view, run, times)
    check_fields(view)
    check_switches(view, "Tungsten")
    check_rubble(view, run)
    view.click("whole")
    check_camera(view)
    view.click("tip")
    assert check_places(view) == 1.0
    check_values(view, run, -1, {"pressure": ("pressure", 1e6)})


def check_narrow(view, keep):
    """In a window of 400 pixels the lying view is in it as a whole, with r drawn larger than y."""
    view.driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", {"width": 400, "height": 800, "deviceScaleFactor": 1,
        "mobile": False})
    view.settle()
    view.click("hole")
    keep("narrow")
    left, right = view.driver.execute_script("const box = document.getElementById('explore').getBoundingClientRect(); "
        "return [box.left, box.right];")
    assert left >= 0 and right <= 400, (left, right)
    assert check_places(view) > 1.0
    view.driver.execute_cdp_cmd("Emulation.clearDeviceMetricsOverride", {})
    view.settle()


def check_fields(view):
    """Another field has other colours, another bar and another line under the mouse."""
    before = view.pixels()
    assert "pressure [MPa]" in view.text("bar-left") and "at the start" in view.text("bar-left"), view.text("bar-left")
    view.choose("left", "speed")
    assert view.pixels() != before and "speed [m/s]" in view.text("bar-left") and "speed" in view.hover(-0.2, 0.1)
    view.choose("left", "state")
    assert "crushed" in view.text("bar-left"), view.text("bar-left")
    view.choose("left", "pressure")
    view.hover(-0.2, 0.1)
    assert view.pixels() == before


def check_switches(view, jet):
    """The jet is not drawn and not found once it is switched off; outlines are drawn."""
    spots = [(across, down) for across in (0.002, 0.01) for down in np.linspace(-0.45, 0.1, 12)]
    on = next((spot for spot in spots if view.hover(*spot)["material"] == jet), None)
    assert on, "no particle of the jet is under the mouse near the axis"
    before = view.pixels()
    view.switch(f"jet ({jet})")
    assert view.pixels() != before and all(view.hover(*spot)["material"] != jet for spot in spots)
    view.switch(f"jet ({jet})")
    assert view.pixels() == before
    view.switch("plain jet and rubble")
    assert view.pixels() != before
    view.switch("plain jet and rubble")
    marks = "return document.getElementById('explore-marks').toDataURL();"
    without = view.driver.execute_script(marks)
    view.switch("cells")
    # On a busy machine a frame may be late.
    assert any(view.driver.execute_script(marks) != without or time.sleep(0.1) for _ in range(50)), "no outlines of cells"
    view.switch("particles")
    assert view.pixels() != before
    view.switch("particles")
    view.switch("cells")


def check_camera(view):
    """Tip, wheel and drag change what is seen, and the button takes all back."""
    from selenium.webdriver.common.action_chains import ActionChains

    whole = view.pixels()
    view.click("tip")
    tip = view.pixels()
    assert tip != whole and view.part("tip").get_attribute("aria-pressed") == "true"
    near = view.hover(-0.1, 0.2)
    assert near["particle"].isdigit() and 10.0 < number_in(near["y"])[0] < 90.0, near
    assert "times larger" not in view.names()[0], view.names()
    ActionChains(view.driver).click_and_hold(view.part("stage")).move_by_offset(40, 25).release().perform()
    view.settle()
    assert view.pixels() != tip and view.part("tip").get_attribute("aria-pressed") == "false"
    view.driver.execute_script("document.getElementById('explore-stage').dispatchEvent(new WheelEvent('wheel', {deltaY: -300, bubbles: "
        "true, cancelable: true, clientX: 500, clientY: 400}));")
    view.settle()
    view.click("whole")
    assert view.pixels() == whole


def check_quiet(driver, page):
    """Nothing was asked of the network but the page itself, and the console is empty."""
    asked, address = [], page.resolve().as_uri()
    for entry in driver.get_log("performance"):
        message = json.loads(entry["message"])["message"]
        if message["method"] == "Network.requestWillBeSent" and message["params"]["documentURL"] == address:
            asked.append(message["params"]["request"]["url"])
    others = [url[:100] for url in asked if url != address and not url.startswith("data:image/png")]
    assert asked.count(address) >= 1 and not others, others
    said = driver.get_log("browser")
    assert not said, said


def check_without_scripts(folder, page):
    """The pictures stand there without scripts, and nothing of the view."""
    with browser(folder / "plain", "blink-settings=scriptEnabled=false") as driver:
        driver.get(page.resolve().as_uri())
        assert not driver.find_element("id", "explore").is_displayed()
        assert len([one for one in driver.find_elements("tag name", "img") if one.is_displayed()]) >= 3
        assert "where scripts may run" in driver.find_element("tag name", "body").text


def check_text(driver, folder):
    """A material whose name is markup is a switch with that name."""
    rock = synthetic_run.rock(synthetic_run.lattice(0.003, 0.01, 0.0, 0.02))
    rock.name = BAD
    run = synthetic_run.write_run(folder / "named", [rock, synthetic_run.jet(synthetic_run.lattice(0.0, 0.001, 0.015, 0.019), 3000.0)])
    said_by("barreno.report", "report", run)
    view = View(driver, run / "report" / "index.html")
    assert driver.title == "By <hand>" and BAD in view.text("switches"), (driver.title, view.text("switches"))
    check_quiet(driver, run / "report" / "index.html")
    wide = ("document.querySelector('h1').textContent = 'x'.repeat(300);"
        "return document.documentElement.scrollWidth - document.documentElement.clientWidth;")
    assert driver.execute_script(wide) <= 0, "a long word in a title makes the page wider than the window"


def times_of(run):
    file = ParticleFile(run / "particles.e")
    times = file.times
    file.close()
    return times


def reported(barreno, deck, folder):
    """The run's folder, with its report."""
    run = pathlib.Path(run_deck(barreno, "perforation_quick.xml", deck, folder=folder).folder)
    said_by("barreno.report", "report", run)
    return run, run / "report" / "index.html"


def check_long(driver, barreno, folder, keep):
    run, page = reported(barreno, LONG, folder / "long")
    view = View(driver, page)
    keep("long")
    check_lying(view, run, times_of(run))
    keep("long_tip")
    check_narrow(view, keep)
    check_quiet(driver, page)


def check_wide(driver, barreno, folder, keep):
    """A target as wide as deep stands while its hole is short."""
    run, page = reported(barreno, SHORT, folder / "quick")
    times, view = times_of(run), View(driver, page)
    keep("whole")
    assert not view.lying and view.text("side-left") == "left"
    check_time(view, times)
    check_instant(view, run, times)
    check_fields(view)
    check_sides(view)
    assert check_places(view) == 1.0
    check_camera(view)
    check_switches(view, "Tungsten")
    view.click("tip")
    keep("tip")
    check_values(view, run, -1, {"pressure": ("pressure", 1e6)})
    view.choose("right", "density")
    view.click("back")
    check_values(view, run, -2, {"pressure": ("pressure", 1e6), "density": ("density", 1.0)})
    keep("earlier")
    check_quiet(driver, page)
    return page


def main():
    pictures = pathlib.Path(sys.argv[3]) if sys.argv[2:3] == ["--pictures"] else None
    barreno = str(pathlib.Path(sys.argv[1]).resolve())
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        with browser(folder / "profile") as driver:
            keep = lambda name: pictures and driver.save_screenshot(str(pictures / f"{name}.png"))  # noqa: E731
            page = check_wide(driver, barreno, folder, keep)
            check_long(driver, barreno, folder, keep)
            check_text(driver, folder)
        check_without_scripts(folder, page)
    print("the view to explore does what its controls say")


if __name__ == "__main__":
    main()
