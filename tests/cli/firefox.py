"""Firefox without a window, driven by Selenium through Marionette, the protocol that Firefox speaks itself: Debian has no
geckodriver, which would stand between the two."""

import json
import os
import pathlib
import socket
import subprocess
import time

import pytest

PACKAGES = "firefox-esr python3-selenium"
FIREFOX = "/usr/bin/firefox-esr"
NAMES = {  # Selenium's names of what Marionette calls otherwise
    "newSession": "WebDriver:NewSession", "get": "WebDriver:Navigate", "refresh": "WebDriver:Refresh", "goBack": "WebDriver:Back",
    "goForward": "WebDriver:Forward", "getCurrentUrl": "WebDriver:GetCurrentURL", "getTitle": "WebDriver:GetTitle",
    "executeScript": "WebDriver:ExecuteScript", "w3cExecuteScript": "WebDriver:ExecuteScript",
    "w3cExecuteScriptAsync": "WebDriver:ExecuteAsyncScript", "actions": "WebDriver:PerformActions", "findElement": "WebDriver:FindElement",
    "clickElement": "WebDriver:ElementClick", "sendKeysToElement": "WebDriver:ElementSendKeys", "setTimeouts": "WebDriver:SetTimeouts",
    "setWindowRect": "WebDriver:SetWindowRect",
}
PREFERENCES = {
    "marionette.port": 0,  # any that is free
    "datareporting.policy.dataSubmissionEnabled": False,
    "browser.shell.checkDefaultBrowser": False,
    "media.autoplay.default": 0,
    "network.dns.disabled": True,  # no name is to be looked up
    "ui.primaryPointerCapabilities": 6,  # a mouse, which a machine without a screen has not
    "ui.allPointerCapabilities": 6,
}


class Marionette:
    """What Selenium asks for its commands: a browser of its own, with a profile in a folder."""

    def __init__(self, folder):
        pathlib.Path(folder).mkdir(parents=True, exist_ok=True)
        rows = [f"user_pref({json.dumps(name)}, {json.dumps(value)});\n" for name, value in PREFERENCES.items()]
        pathlib.Path(folder, "user.js").write_text("".join(rows))
        pathlib.Path(folder, "MarionetteActivePort").unlink(missing_ok=True)  # of an earlier browser with this profile
        with open(os.path.join(folder, "log"), "wb") as log:
            self.child = subprocess.Popen([FIREFOX, "--headless", "--marionette", "--no-remote", "--profile", os.fspath(folder), "--width",
                                           "1440", "--height", "986"], stdout=log, stderr=subprocess.STDOUT)
        self.socket = socket.create_connection(("127.0.0.1", self._port(folder)), timeout=120)
        self.answers = self.socket.makefile("rb")
        self._read()  # its greeting
        self.count = 0

    def _port(self, folder):
        """Firefox writes into its profile on which port it listens."""
        path = pathlib.Path(folder, "MarionetteActivePort")
        end = time.monotonic() + 60
        while not path.exists() or not path.read_text().strip():
            if self.child.poll() is not None or time.monotonic() > end:
                self.child.kill()
                raise RuntimeError(f"Firefox does not start: {pathlib.Path(folder, 'log').read_text(errors='replace')}")
            time.sleep(0.05)
        return int(path.read_text())

    def _read(self):
        size = b""
        while (byte := self.answers.read(1)) != b":":
            size += byte
        return json.loads(self.answers.read(int(size)))

    def execute(self, command, params):
        """A command of Selenium; what Selenium expects of a driver's answer."""
        if command == "quit":
            return self.close()
        is_first = command == "newSession"
        params = {} if is_first else {key: value for key, value in (params or {}).items() if key != "sessionId"}
        self.count += 1
        text = json.dumps([0, self.count, NAMES[command], params]).encode()
        self.socket.sendall(b"%d:%s" % (len(text), text))
        _, _, error, value = self._read()
        if error:
            return {"status": 500, "value": json.dumps({"value": error})}
        if is_first:
            return {"value": value}
        return {"value": value["value"] if isinstance(value, dict) and set(value) == {"value"} else value}

    def close(self):
        self.socket.close()
        self.child.terminate()
        try:
            self.child.wait(20)
        except subprocess.TimeoutExpired:
            self.child.kill()
            self.child.wait()
        return {"value": None}


def driver(folder):
    """Skips the test where there is no Firefox."""
    try:
        from selenium import webdriver
        from selenium.webdriver.firefox.options import Options
    except ImportError as error:
        pytest.skip(f"{error}; install with: apt-get install {PACKAGES}")
    if not os.path.exists(FIREFOX):
        pytest.skip(f"there is no {FIREFOX}; install with: apt-get install {PACKAGES}")
    return webdriver.Remote(command_executor=Marionette(folder), options=Options())
