#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The explorable view of a report in Chromium without a screen: its controls do what they say, values under the mouse are those of
particles.e, and the page asks the network for nothing.

    test_explore.py BARRENO [--pictures FOLDER]

Skipped without Chromium, its driver or Selenium (apt-get install chromium chromium-driver python3-selenium), which .ci/run has installed:
with BARRENO_ALL_TESTS set one of them missing is a failure. --pictures keeps what the browser showed.
"""
import contextlib
import json
import os
import pathlib
import re
import shutil
import sys
import tempfile

import numpy as np
import synthetic_run

from barreno.report.particles import ParticleFile
from python_commands import said_by
from tools.runs import run_deck

SHORT = {"Grid/Upper": "{80 mm, 130 mm}", "Bodies/Rock/Upper": "{50.8 mm, 112.7 mm}", "Time/End Time": "12 us",
    "Output/Field Interval": "4 us", "Output/Checkpoint Wall Interval": "0 s", "Jet/Cells Per Radius": "1"}
FLAGS = ("headless=new", "no-sandbox", "disable-gpu", "disable-quic", "no-first-run", "disable-background-networking",
    "disable-component-update", "disable-sync", "disable-default-apps", "disable-dev-shm-usage", "window-size=1366,768")
BAD = "<script>document.title='bad'</script>"
PATIENCE = 60  # s
SKIPPED = 77  # what ctest counts as skipped
NUMBER = re.compile(r"(-?[\d.]+(?:e[+-]?\d+)?) ± ([\d.]+(?:e[+-]?\d+)?)")


def missing(what):
    required = bool(os.environ.get("BARRENO_ALL_TESTS"))
    print("missing, but BARRENO_ALL_TESTS is set:" if required else "skipped:", what,
        "is not installed (apt-get install chromium chromium-driver python3-selenium)")
    sys.exit(1 if required else SKIPPED)


@contextlib.contextmanager
def browser(profile, *more):
    program, driver = shutil.which("chromium"), shutil.which("chromedriver")
    if not program or not driver:
        missing("Chromium or its driver")
    try:
        from selenium import webdriver
        from selenium.webdriver.chrome.service import Service
    except ImportError:
        missing("Selenium")
    options = webdriver.ChromeOptions()
    options.binary_location = program
    for flag in (*FLAGS, f"user-data-dir={profile}", *more):
        options.add_argument(f"--{flag}")
    options.set_capability("goog:loggingPrefs", {"browser": "ALL", "performance": "ALL"})
    found = webdriver.Chrome(options=options, service=Service(driver))
    try:
        yield found
    finally:
        found.quit()


class View:
    """The page, by what a user sees and does."""

    def __init__(self, driver, page):
        self.driver = driver
        driver.get(page.resolve().as_uri())
        self.until(lambda: self.text("when") or self.shown("why"))
        assert not self.shown("why"), self.text("why")
        self.settle()

    def until(self, found):
        from selenium.webdriver.support.ui import WebDriverWait

        WebDriverWait(self.driver, PATIENCE).until(lambda _: found())

    def settle(self):
        """Two frames later all is drawn."""
        self.driver.execute_async_script("const done = arguments[0]; requestAnimationFrame(() => requestAnimationFrame(() => done()));")

    def part(self, name):
        return self.driver.find_element("id", f"explore-{name}")

    def text(self, name):
        return self.driver.execute_script("return document.getElementById(arguments[0])?.textContent ?? '';", f"explore-{name}")

    def shown(self, name):
        return self.driver.execute_script("return document.getElementById(arguments[0])?.hidden === false;", f"explore-{name}")

    def click(self, name):
        self.part(name).click()
        self.settle()

    def press(self, key):
        from selenium.webdriver.common.action_chains import ActionChains

        ActionChains(self.driver).send_keys(key).perform()
        self.settle()

    def choose(self, side, name):
        from selenium.webdriver.support.ui import Select

        Select(self.part(side)).select_by_value(name)
        self.until(lambda: self.part(side).get_attribute("value") == name)
        self.settle()

    def switch(self, label):
        for one in self.driver.find_elements("css selector", "#explore-switches label"):
            if one.text.strip() == label:
                one.click()
                self.settle()
                return
        raise AssertionError(f"no switch '{label}' among {[one.text for one in self.driver.find_elements('css selector', 'label')]}")

    def pixels(self):
        return self.driver.execute_script("return document.getElementById('explore-particles').toDataURL();")

    def hover(self, across, down):
        """{line: value} at a part of the stage, from -0.5 to 0.5 of its size off its middle."""
        from selenium.webdriver.common.action_chains import ActionChains

        stage = self.part("stage")
        ActionChains(self.driver).move_to_element_with_offset(stage, int(across * stage.size["width"]),
            int(down * stage.size["height"])).perform()
        self.settle()
        lines = self.driver.execute_script(
            "return [...document.querySelectorAll('#explore-values tr')].map(row => [...row.children].map(cell => cell.textContent));")
        return dict(lines)

    def markers(self):
        return self.driver.execute_script("return [...document.querySelectorAll('.explore-now')].map(one => parseFloat(one.style.left));")


def number_in(text):
    """(value, greatest difference)"""
    found = NUMBER.match(text)
    assert found, f"'{text}' has no number with its precision"
    return float(found.group(1)), float(found.group(2))


def agrees(text, true, size):
    value, slack = number_in(text)
    assert abs(value - true / size) <= slack * (1.0 + 1e-6) + 1e-6 * abs(value), (text, true / size)
    return slack


def check_values(view, run, step, fields):
    """What stands under the mouse is what particles.e has of that particle, within the precision that stands beside it.

    @param fields  {line: (name in the file, its unit in SI)}"""
    file = ParticleFile(run / "particles.e")
    frame = file.frame(step)
    columns, seen = {int(n): i for i, n in enumerate(file.numbers[frame.alive])}, set()
    values = {name: frame.of_alive([name]) for name, _ in fields.values()}
    for across, down in ((-0.3, 0.1), (0.2, 0.2), (0.01, -0.2), (-0.05, -0.05), (0.05, 0.3), (0.33, -0.3), (-0.15, 0.02)):
        lines = view.hover(across, down)
        if not lines["particle"].isdigit():
            continue
        row = columns[int(lines["particle"])]
        seen.add(row)
        assert lines["material"] == file.block_names[frame.block[row]], lines
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
    view.switch("plain jet")
    assert view.pixels() != before
    view.switch("plain jet")
    marks = "return document.getElementById('explore-marks').toDataURL();"
    without = view.driver.execute_script(marks)
    view.switch("cells")
    assert view.driver.execute_script(marks) != without
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


def main():
    keep = pathlib.Path(sys.argv[3]) if sys.argv[2:3] == ["--pictures"] else None
    barreno = str(pathlib.Path(sys.argv[1]).resolve())
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        with browser(folder / "profile") as driver:
            run = pathlib.Path(run_deck(barreno, "perforation_quick.xml", SHORT, folder=folder / "quick").folder)
            said_by("barreno.report", "report", run)
            page = run / "report" / "index.html"
            file = ParticleFile(run / "particles.e")
            times = file.times
            file.close()
            view = View(driver, page)
            picture = lambda name: keep and driver.save_screenshot(str(keep / f"{name}.png"))  # noqa: E731
            picture("whole")
            check_time(view, times)
            check_fields(view)
            check_camera(view)
            check_switches(view, "Tungsten")
            view.click("tip")
            picture("tip")
            check_values(view, run, -1, {"pressure": ("pressure", 1e6)})
            view.choose("right", "density")
            view.click("back")
            check_values(view, run, -2, {"pressure": ("pressure", 1e6), "density": ("density", 1.0)})
            picture("earlier")
            check_quiet(driver, page)
            check_text(driver, folder)
        check_without_scripts(folder, page)
    print("the view to explore does what its controls say")


if __name__ == "__main__":
    main()
