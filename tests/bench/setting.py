"""What all parts of the benchmark share: how they are run, and how a section of the report is put together."""

import pathlib
import subprocess
from dataclasses import dataclass


@dataclass
class Setting:
    clip: str
    runs: int
    backend: str
    scratch: pathlib.Path
    build: pathlib.Path
    clips: pathlib.Path  # those that scripts/bench makes
    long: bool = False  # whether a clip of 6 hours is measured too
    scale: float = 1  # of the volumes and pictures that are drawn; less only tries whether all works

    @property
    def vvr(self):
        return str(self.build / "cli/vvr")

    def program(self, name):
        return str(self.build / "tests" / "bench" / name)

    def made(self, name):
        return str(self.clips / name)

    def render(self, clip, *options):
        return [self.vvr, "render", clip, "-o", str(self.scratch / "out.png"), "--backend", self.backend, "--quiet", *options]


def frames_of(clip):
    counted = subprocess.run(["ffprobe", "-v", "error", "-count_packets", "-select_streams", "v", "-show_entries",
                              "stream=nb_read_packets", "-of", "csv=p=0", clip], check=True, stdout=subprocess.PIPE)
    return int(counted.stdout.decode().strip().rstrip(","))


def section(title, measured, body):
    """What is measured in a sentence, and the numbers."""
    return f"## {title}\n\n{measured}\n\n{body.strip()}\n"
