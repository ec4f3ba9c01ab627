"""A page in a real browser: Chromium without a window, driven by Selenium, with no network."""

import json
import os
import pathlib
import time

import pytest
from harness import check

PACKAGES = "chromium chromium-driver python3-selenium"


def driver_of(folder, *arguments):
    """A browser with a profile of its own; skips the test where there is none."""
    try:
        from selenium import webdriver
        from selenium.webdriver.chrome.options import Options
        from selenium.webdriver.chrome.service import Service
    except ImportError as error:
        pytest.skip(f"{error}; install with: apt-get install {PACKAGES}")
    for path in ("/usr/bin/chromium", "/usr/bin/chromedriver"):
        if not os.path.exists(path):
            pytest.skip(f"there is no {path}; install with: apt-get install {PACKAGES}")
    options = Options()
    options.binary_location = "/usr/bin/chromium"
    # Root may not use the sandbox, containers have little shared memory, and no name is to be looked up.
    for argument in ("--headless=new", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", "--window-size=1440,900",
                     "--host-resolver-rules=MAP * ~NOTFOUND", f"--user-data-dir={folder}", "--no-first-run", *arguments):
        options.add_argument(argument)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL", "performance": "ALL"})
    return webdriver.Chrome(service=Service("/usr/bin/chromedriver"), options=options)


class Page:
    """A page that is open, and what a person would do with it."""

    def __init__(self, t, name, *arguments):
        self.driver = driver_of(t.path(".profile"), *arguments)
        self.driver.set_script_timeout(30)
        self.open(t.path(name))

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.driver.quit()

    def open(self, path):
        self.driver.get(pathlib.Path(path).as_uri())
        self.wait("the page is ready", "return document.documentElement.dataset.ready !== undefined"
                                       " && document.getElementById('source').textContent !== ''")

    def run(self, script, *arguments):
        return self.driver.execute_script(script, *arguments)

    def wait(self, what, script, seconds=20):
        end = time.monotonic() + seconds
        while not self.run(script):
            check(time.monotonic() < end, f"waited in vain: {what}\n{self.complaints()}")
            time.sleep(0.05)

    def text(self, name):
        return self.run("return document.getElementById(arguments[0]).textContent", name)

    def text_of(self, selector):
        return self.run("return document.querySelector(arguments[0]).textContent", selector)

    def hidden(self, name):
        return self.run("return document.getElementById(arguments[0]).hidden", name)

    def source(self):
        return self.text("source")

    def key(self, *keys):
        from selenium.webdriver.common.action_chains import ActionChains
        ActionChains(self.driver).send_keys(*keys).perform()

    def _to(self, x, y):
        """The pointer on a point of the picture, in its pixels."""
        from selenium.webdriver.common.action_chains import ActionChains
        box = self.run("const b = picture.getBoundingClientRect(); return [b.left, b.top, b.width / width, b.height / height]")
        actions = ActionChains(self.driver, duration=0)
        actions.w3c_actions.pointer_action.move_to_location(round(box[0] + x * box[2]), round(box[1] + y * box[3]))
        return actions

    def point(self, x, y):
        self._to(x, y).perform()

    def click(self, x, y):
        self._to(x, y).click().perform()

    def hold_still(self):
        """From here on a click goes to its moment and stays there, so that it can be looked at."""
        self.run("video.pause(); video.play = () => Promise.resolve();")

    def click_and_look(self, x, y):
        """Where the player's clock stands after a click, and the time of the frame that it shows."""
        self.run("window.shown = null; video.requestVideoFrameCallback((_, frame) => { window.shown = frame.mediaTime; });")
        before = self.run("return video.currentTime")
        self.click(x, y)
        end = time.monotonic() + 5
        while time.monotonic() < end:
            seeking, clock, shown = self.run("return [video.seeking, video.currentTime, window.shown]")
            if not seeking and (shown is not None or clock == before):
                break
            time.sleep(0.02)
        return clock, shown

    def complaints(self):
        """What the console says."""
        return [entry["message"] for entry in self.driver.get_log("browser")]

    def requests(self):
        """Every address that was asked for, but for the browser's own pages."""
        messages = [json.loads(entry["message"])["message"] for entry in self.driver.get_log("performance")]
        urls = [message["params"]["request"]["url"] for message in messages if message["method"] == "Network.requestWillBeSent"]
        return [url for url in urls if not url.startswith("chrome:")]
