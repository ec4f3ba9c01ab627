"""A page in a real browser: Chromium without a window, driven by Selenium, with no network. VVR_BROWSER=firefox takes Firefox
instead; tests of what only Chromium's own protocol can do are skipped then."""

import http.server
import json
import os
import pathlib
import re
import threading
import time

import firefox
import pytest
from harness import check

# Contrast as WCAG 2 defines it, of what is on show and not disabled; colours that let others through are laid upon them.
CONTRAST = """
const context = new OffscreenCanvas(1, 1).getContext('2d', {willReadFrequently: true});
const known = new Map();
function read(colour) {
    if (!known.has(colour)) {
        context.clearRect(0, 0, 1, 1);
        context.fillStyle = colour;
        context.fillRect(0, 0, 1, 1);
        known.set(colour, [...context.getImageData(0, 0, 1, 1).data]);
    }
    return known.get(colour);
}
const over = (above, below) => [0, 1, 2].map(k => below[k] + (above[k] - below[k]) * above[3] / 255);
function groundOf(element) {
    if (!element) return read(getComputedStyle(document.documentElement).colorScheme.includes('dark') &&
                              matchMedia('(prefers-color-scheme: dark)').matches ? '#121212' : '#ffffff');
    const own = read(getComputedStyle(element).backgroundColor);
    return own[3] === 255 ? own : over(own, groundOf(element.parentElement));
}
function luminance(colour) {
    const [red, green, blue] = colour.slice(0, 3).map(byte => byte / 255)
        .map(share => share <= 0.04045 ? share / 12.92 : ((share + 0.055) / 1.055) ** 2.4);
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue;
}
const found = [];
let count = 0;
const texts = document.createTreeWalker(document.body, NodeFilter.SHOW_ELEMENT);
while (texts.nextNode()) {
    const element = texts.currentNode;
    const text = element.matches('select') ? element.selectedOptions[0]?.textContent : element.placeholder ||
        [...element.childNodes].filter(node => node.nodeType === 3).map(node => node.data).join('').trim();
    const box = element.getBoundingClientRect();
    if (!text || element.matches('script, style, noscript, option, :disabled, svg *') || box.width < 2 || box.height < 2) continue;
    if (!element.checkVisibility({opacityProperty: true, visibilityProperty: true})) continue;
    const ground = groundOf(element);
    const ink = over(read(getComputedStyle(element, element.placeholder ? '::placeholder' : null).color), ground);
    const [light, dark] = [luminance(ink), luminance(ground)].sort((a, b) => b - a);
    const contrast = (light + 0.05) / (dark + 0.05);
    ++count;
    const name = element.id || element.className || element.tagName;
    if (contrast < 4.5) found.push(`${name} "${text.slice(0, 30)}": ${contrast.toFixed(2)}`);
}
return [found, count];
"""

PACKAGES = "chromium chromium-driver python3-selenium"


def is_firefox():
    return os.environ.get("VVR_BROWSER") == "firefox"


def driver_of(folder, *arguments):
    """A browser with a profile of its own; skips the test where there is none."""
    if is_firefox():
        if arguments:
            pytest.skip(f"Firefox has no {' '.join(arguments)}")
        return firefox.driver(folder)
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
                     # A mouse, which a machine without a screen has not.
                     "--blink-settings=primaryHoverType=2,availableHoverTypes=2,primaryPointerType=4,availablePointerTypes=4",
                     "--host-resolver-rules=MAP * ~NOTFOUND, EXCLUDE 127.0.0.1", f"--user-data-dir={folder}", "--no-first-run",
                     # Without a GPU, the browser complains of WebGL: who tests that says which rasteriser.
                     *(arguments or ("--disable-3d-apis",))):
        options.add_argument(argument)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL", "performance": "ALL"})
    return webdriver.Chrome(service=Service("/usr/bin/chromedriver"), options=options)


class Served:
    """A folder over HTTP on this machine, with or without parts of files (Range); gone at the end of the block."""

    def __init__(self, folder, ranges=True):
        self.asked = []  # [method, path, bytes that were sent] of each request
        served = self

        class Handler(http.server.SimpleHTTPRequestHandler):
            def __init__(self, *arguments):
                super().__init__(*arguments, directory=os.fspath(folder))

            def do_GET(self):
                path = self.translate_path(self.path)
                part = re.fullmatch(r"bytes=(\d+)-(\d*)", self.headers.get("Range", "")) if ranges else None
                if not os.path.isfile(path):
                    return self.send_error(404)
                with open(path, "rb") as file:
                    whole = file.read()
                first = int(part[1]) if part else 0
                last = min(int(part[2]), len(whole) - 1) if part and part[2] else len(whole) - 1
                self.send_response(206 if part else 200)
                if part:
                    self.send_header("Content-Range", f"bytes {first}-{last}/{len(whole)}")
                if ranges:
                    self.send_header("Accept-Ranges", "bytes")
                self.send_header("Content-Type", self.guess_type(path))
                self.send_header("Content-Length", str(last + 1 - first))
                self.send_header("Last-Modified", self.date_time_string(os.path.getmtime(path)))
                self.end_headers()
                served.asked.append((self.command, self.path, last + 1 - first))
                self.wfile.write(whole[first:last + 1])

            def do_HEAD(self):
                served.asked.append((self.command, self.path, 0))
                super().do_HEAD()

            def date_time_string(self, timestamp=None):
                return super().date_time_string(time.time() + served.ahead if timestamp is None else timestamp)

            def handle(self):
                try:
                    super().handle()
                except ConnectionError:
                    pass  # the browser wants no more of it

            def log_message(self, *_):
                pass

        self.ahead = 0  # seconds by which the server's clock is wrong
        self.server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), Handler)
        threading.Thread(target=self.server.serve_forever, daemon=True).start()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.server.shutdown()
        self.server.server_close()

    def url(self, name):
        return f"http://127.0.0.1:{self.server.server_address[1]}/{name}"


class Page:
    """A page that is open, and what a person would do with it."""

    READY = "return document.documentElement.dataset.ready !== undefined && (film !== null || stills)"

    def __init__(self, t, name, *arguments):
        self.driver = driver_of(t.path(".profile"), *arguments)
        self.driver.set_script_timeout(30)
        self.open(name if str(name).startswith("http:") else t.path(name))

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.driver.quit()

    def open(self, path):
        """A file's path, or an address."""
        self.driver.get(str(path) if str(path).startswith("http:") else pathlib.Path(path).as_uri())
        self.wait("the page is ready", self.READY)

    def reload(self):
        self.driver.refresh()
        self.wait("it is there again", self.READY)

    def run(self, script, *arguments):
        """Runs a script, which can use the names that the page's script exports (as `vvr`) and those of its state."""
        return self.driver.execute_script(f"with (window.vvr ?? {{}}) with (window.vvr?.state ?? {{}}) {{ {script}\n}}", *arguments)

    def wait(self, what, script, seconds=20):
        end = time.monotonic() + seconds
        while not self.run(script):
            check(time.monotonic() < end, f"waited in vain: {what}\n{self.complaints()}")
            time.sleep(0.05)

    def text(self, name):
        return self.run("return document.getElementById(arguments[0]).textContent", name)

    def texts(self, selector):
        """Of every element that is like that."""
        return self.run("return [...document.querySelectorAll(arguments[0])].map(e => e.textContent)", selector)

    def count(self, selector):
        return self.run("return document.querySelectorAll(arguments[0]).length", selector)

    def open_menu(self, name):
        """So that what is in it can be pressed."""
        self.run("for (const menu of document.querySelectorAll('details.menu')) menu.open = menu.id === arguments[0]", name)

    def box(self, selector):
        """Where an element is in the window: left, top, right, bottom."""
        return self.run("const b = document.querySelector(arguments[0]).getBoundingClientRect();"
                        "return [b.left, b.top, b.right, b.bottom]", selector)

    def set(self, name, value):
        """Takes another value of a list of choices."""
        self.run("const e = document.getElementById(arguments[0]); e.value = arguments[1]; e.dispatchEvent(new Event('change'))",
                 name, value)

    def text_of(self, selector):
        return self.run("return document.querySelector(arguments[0]).textContent", selector)

    def hidden(self, name):
        return self.run("return document.getElementById(arguments[0]).hidden", name)

    def source(self):
        return self.text("source")

    def key(self, *keys):
        from selenium.webdriver.common.action_chains import ActionChains
        ActionChains(self.driver).send_keys(*keys).perform()

    def hold(self, modifier, key):
        from selenium.webdriver.common.action_chains import ActionChains
        ActionChains(self.driver).key_down(modifier).send_keys(key).key_up(modifier).perform()

    def _to(self, x, y):
        """The pointer on a point of the picture, in its pixels."""
        from selenium.webdriver.common.action_chains import ActionChains
        box = self.run("const b = picture.getBoundingClientRect(); return [b.left, b.top, b.width / pictureSize[0], b.height / pictureSize[1]]")
        actions = ActionChains(self.driver, duration=0)
        actions.w3c_actions.pointer_action.move_to_location(round(box[0] + x * box[2]), round(box[1] + y * box[3]))
        return actions

    def point(self, x, y):
        self._to(x, y).perform()

    def click(self, x, y):
        self._to(x, y).click().perform()

    def move(self, x, y):
        """The pointer on a point of the window."""
        from selenium.webdriver.common.action_chains import ActionChains
        actions = ActionChains(self.driver, duration=0)
        actions.w3c_actions.pointer_action.move_to_location(round(x), round(y))
        actions.perform()

    def touch(self, kind, *points):
        """What fingers do: "touchStart", "touchMove", "touchEnd"; each is at a point of the window."""
        self.cdp("Input.dispatchTouchEvent", type=kind, touchPoints=[{"x": x, "y": y, "id": k} for k, (x, y) in enumerate(points)])

    def press(self, selector):
        """A real click by mouse on the middle of an element."""
        from selenium.webdriver.common.by import By
        self.driver.find_element(By.CSS_SELECTOR, selector).click()

    def drag(self, selector, *places, kind="mouse"):
        """Presses on an element, moves on and lets go; each place is given by shares of the element's width and height."""
        from selenium.webdriver.common.actions.action_builder import ActionBuilder
        from selenium.webdriver.common.actions.pointer_input import PointerInput
        left, top, right, bottom = self.box(selector)
        actions = ActionBuilder(self.driver, mouse=PointerInput(kind, kind), duration=0)
        for k, (x, y) in enumerate(places):
            actions.pointer_action.move_to_location(round(left + x * (right - left)), round(top + y * (bottom - top)))
            if k == 0:
                actions.pointer_action.pointer_down()
        actions.pointer_action.pointer_up()
        actions.perform()

    def cdp(self, command, **values):
        """A command of the browser's own protocol, for what a window of another kind does."""
        if is_firefox():
            pytest.skip(f"Firefox has no {command}")
        return self.driver.execute_cdp_cmd(command, values)

    def allow_clipboard(self):
        self.cdp("Browser.grantPermissions", permissions=["clipboardReadWrite", "clipboardSanitizedWrite"])

    def clipboard(self):
        """What was copied."""
        self.run("window.copied = null; navigator.clipboard.readText().then(text => { window.copied = text; });")
        self.wait("what was copied", "return window.copied !== null")
        return self.run("return window.copied")

    def saved(self, t, selector, pattern):
        """The file that a button saves."""
        t.path("saved").mkdir(exist_ok=True)
        self.cdp("Browser.setDownloadBehavior", behavior="allow", downloadPath=str(t.path("saved")))
        self.press(selector)
        end = time.monotonic() + 10
        while not (found := list(t.path("saved").glob(pattern))):
            check(time.monotonic() < end, f"nothing is saved as {pattern}")
            time.sleep(0.05)
        return found[0]

    def window(self, width, height, mobile=False):
        if is_firefox() and not mobile:
            chrome = self.run("return outerHeight - innerHeight")
            self.driver.set_window_rect(0, 0, width, height + chrome)
            if self.run("return innerWidth") > width:
                pytest.skip(f"no window of Firefox is {width} pixels wide")
            return
        self.cdp("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=mobile)
        if mobile:  # taking fingers away again would not bring the mouse back
            self.cdp("Emulation.setTouchEmulationEnabled", enabled=True, maxTouchPoints=2)

    def media(self, kind="", scheme="light"):
        """Of what kind: "print", or "" for a screen."""
        self.cdp("Emulation.setEmulatedMedia", media=kind, features=[{"name": "prefers-color-scheme", "value": scheme}])

    def faint(self):
        """Every text on show whose contrast is below 4.5, by the formula of WCAG 2; and how many texts there are."""
        return self.run(CONTRAST)

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
        """What the console says; Firefox tells nobody."""
        if is_firefox():
            return []
        return [entry["message"] for entry in self.driver.get_log("browser")]

    def requests(self):
        """Every address that was asked for, but for the browser's own pages; Firefox tells nobody."""
        if is_firefox():
            return []
        messages = [json.loads(entry["message"])["message"] for entry in self.driver.get_log("performance")]
        urls = [message["params"]["request"]["url"] for message in messages if message["method"] == "Network.requestWillBeSent"]
        return [url for url in urls if not url.startswith("chrome:")]
