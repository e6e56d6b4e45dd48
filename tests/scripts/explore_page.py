# SPDX-License-Identifier: BSD-3-Clause
"""Chromium without a screen, and the explorable view of a report in it."""
import contextlib
import os
import shutil
import sys

FLAGS = ("headless=new", "no-sandbox", "disable-gpu", "disable-quic", "no-first-run", "disable-background-networking",
    "disable-component-update", "disable-sync", "disable-default-apps", "disable-dev-shm-usage", "window-size=1366,768")
PATIENCE = 60  # s
SKIPPED = 77  # what ctest counts as skipped


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
        self.lying = "explore-lying" in self.part("").get_attribute("class")

    def until(self, found):
        from selenium.webdriver.support.ui import WebDriverWait

        WebDriverWait(self.driver, PATIENCE, poll_frequency=0.02).until(lambda _: found())

    def settle(self):
        """Two frames later all is drawn."""
        self.driver.execute_async_script("const done = arguments[0]; requestAnimationFrame(() => requestAnimationFrame(() => done()));")

    def part(self, name):
        return self.driver.find_element("id", f"explore-{name}" if name else "explore")

    def text(self, name):
        return self.driver.execute_script("return document.getElementById(arguments[0])?.textContent ?? '';", f"explore-{name}")

    def shown(self, name):
        return self.driver.execute_script("return document.getElementById(arguments[0])?.hidden === false;", f"explore-{name}")

    def click(self, name):
        self.part(name).click()
        self.settle()

    def press(self, key):
        from selenium.webdriver.common.action_chains import ActionChains

        ActionChains(self.driver, duration=0).send_keys(key).perform()
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

    def halves(self):
        """The picture's half of the left field, and that of the right one, where the axis is in the middle."""
        return self.driver.execute_script("""
            const canvas = document.getElementById('explore-particles'), {width, height} = canvas;
            const [wide, high] = arguments[0] ? [width, height / 2 - 2] : [width / 2 - 2, height];
            return [[0, 0], [width - wide, height - high]].map(([x, y]) => {
              const part = Object.assign(document.createElement('canvas'), {width: wide, height: high});
              part.getContext('2d').drawImage(canvas, -x, -y);
              return part.toDataURL();
            });""", self.lying)

    def names(self):
        """Of the axes: across y, and along y."""
        return self.part("marks").get_attribute("aria-label").split("; ")

    def hover(self, across, along):
        """{line: value} at a part of the stage, from -0.5 to 0.5 of its size off its middle; along y is to the right in a view that
        lies."""
        from selenium.webdriver.common.action_chains import ActionChains

        stage = self.part("stage")
        right, down = (along, across) if self.lying else (across, along)
        # Places count from the middle of what the window shows of the stage.
        self.driver.execute_script("arguments[0].scrollIntoView({block: 'center'});", stage)
        ActionChains(self.driver, duration=0).move_to_element_with_offset(stage, int(right * stage.size["width"]),
            int(down * stage.size["height"])).perform()
        self.settle()
        lines = self.driver.execute_script(
            "return [...document.querySelectorAll('#explore-values tr')].map(row => [...row.children].map(cell => cell.textContent));")
        return dict(lines)

    def markers(self):
        return self.driver.execute_script("return [...document.querySelectorAll('.explore-now')].map(one => parseFloat(one.style.left));")

    def curves(self):
        """{curve: number beside its name}"""
        words = self.driver.execute_script("return [...document.querySelectorAll('.explore-curve span')].map(one => one.textContent);")
        return dict(one.rsplit(" ", 1) for one in words)
