"""The examples of docs/events.md against a real broker, Debian's mosquitto."""

import json
import re
import shutil
import socket
import subprocess
import time

import pytest
from harness import check
from test_events_to import FAST, clips, walk
from test_watch import free_port

pytestmark = pytest.mark.slow


class Broker:
    """mosquitto on a free port, with one subscriber to all topics."""

    def __init__(self, t, messages):
        for program in ("mosquitto", "mosquitto_pub", "mosquitto_sub"):
            if not shutil.which(program, path="/usr/sbin:/usr/bin:/bin"):
                pytest.skip(f"{program} is not installed; scripts/test --all does it")
        self.port = free_port()
        t.write("mosquitto.conf", f"listener {self.port} 127.0.0.1\nallow_anonymous true\npersistence false\n")
        self.server = subprocess.Popen(["/usr/sbin/mosquitto", "-c", "mosquitto.conf"], cwd=t.folder, stdout=subprocess.DEVNULL,
                                       stderr=subprocess.DEVNULL)
        self.subscriber = None
        self.messages = messages

    def __enter__(self):
        for _ in range(200):
            try:
                socket.create_connection(("127.0.0.1", self.port), timeout=1).close()
                break
            except OSError:
                time.sleep(0.05)
        # Line by line: else nothing is heard of it before it ends.
        self.subscriber = subprocess.Popen(
            ["stdbuf", "-oL", "mosquitto_sub", "-h", "127.0.0.1", "-p", str(self.port), "-t", "vvr/#", "-v", "-C",
             str(self.messages), "-W", "60", "-d"], stdout=subprocess.PIPE, text=True)
        for line in self.subscriber.stdout:  # until the broker has confirmed it
            if "SUBACK" in line:
                break
        return self

    def __exit__(self, *_):
        for child in (self.subscriber, self.server):
            child.kill()
            child.wait()

    def received(self):
        """Topics and messages."""
        text = self.subscriber.communicate(timeout=90)[0]
        return [line.split(" ", 1) for line in text.splitlines() if line.startswith("vvr/")]


def page(t):
    return (t.source / "docs" / "events.md").read_text(encoding="utf-8")


def test_stream_to_home_assistant(t):
    walk(t, "gate.avi", begins=6, seconds=24)
    t.write("gate.url", "gate.avi\n")
    command = re.search(r"^vvr watch .*mosquitto_pub.*$", page(t), flags=re.MULTILINE).group(0)
    with Broker(t, 1) as broker:
        command = command.replace("vvr watch", f"'{t.vvr_path}' watch {' '.join(FAST)} --brick 2s --window 4", 1)
        t.run(["bash", "-o", "pipefail", "-c", command.replace("-h localhost", f"-h 127.0.0.1 -p {broker.port}")]).expect(0)
        (topic, message), = broker.received()
    check(topic == "vvr/gate/event" and f"state_topic: {topic}" in page(t) and f"topic: {topic}" in page(t), topic)
    event = json.loads(message)
    check(event["camera"] == "gate" and event["kind"] == "moved" and event["page"].startswith("gate.html#"), message)
    used = set(re.findall(r"(?:value_json|payload_json)\.(\w+)", page(t)))  # by Home Assistant's templates
    check(len(used) >= 3 and used <= set(event), f"{used} of {message}")


def test_file_of_a_service(t):
    """The example for systemd follows the file to which vvr appends."""
    unit = (t.source / "docs" / "examples" / "vvr-events@.service").read_text(encoding="utf-8")
    line = re.search(r"^ExecStart=/bin/sh -c '(.*)'$", unit, flags=re.MULTILINE).group(1)
    option = re.search(r"--events-to (/var/lib/vvr/gate.jsonl)$", page(t), flags=re.MULTILINE).group(1)
    check(option == "/var/lib/vvr/gate.jsonl" and "/var/lib/vvr/%i.jsonl" in line and option in unit, line)
    clips(t, "in/one.avi")
    with Broker(t, 1) as broker:
        line = line.replace("/var/lib/vvr/%i", str(t.path("gate"))).replace("%i", "gate").replace(
            "-h localhost", f"-h 127.0.0.1 -p {broker.port}")
        service = subprocess.Popen(["/bin/sh", "-c", line], cwd=t.folder, stderr=subprocess.DEVNULL, start_new_session=True)
        try:
            time.sleep(0.5)
            t.vvr("archive", "in", "-o", "out", *FAST, "--events-to", "gate.jsonl").expect(0)
            (topic, message), = broker.received()
        finally:
            subprocess.run(["kill", "--", f"-{service.pid}"], check=False)
            service.wait()
    check(topic == "vvr/gate/event" and message + "\n" == t.path("gate.jsonl").read_text(encoding="utf-8"), message)
