"""scripts/faults: see there."""

import argparse
import pathlib
import random
import sys
import tempfile
import time
from collections import Counter

from faults import SCENES, Walk, faults_of


def tell(walk, begin):
    """What has come of it so far, as a table."""
    calls = Counter()
    for (scene, call, status), count in walk.statuses.items():
        calls[call, scene, status] += count
    print(f"{walk.runs} runs in {time.monotonic() - begin:.0f} s")
    for (call, scene, status), count in sorted(calls.items(), key=str):
        print(f"  {call:<15} {scene:<8} {'hangs' if status is None else status}: {count}")
    for finding in walk.findings:
        if not finding.is_others:
            print(finding)
    whose = Counter(finding.whose for finding in walk.findings if finding.is_others)
    ours = [finding for finding in walk.findings if not finding.is_others]
    print(f"{len(ours)} findings, and besides in libraries: {dict(whose)}")
    return 1 if ours else 0


def main():
    parser = argparse.ArgumentParser(prog="scripts/faults", description="Makes calls of vvr fail, or kills it, at many places")
    parser.add_argument("most", nargs="?", type=int, default=20, help="faults per scene and call (%(default)s)")
    parser.add_argument("--kills", type=int, default=0, metavar="N", help="so many kills, and no faults")
    parser.add_argument("--seed", type=int, default=1, help="of all choices (%(default)s)")
    parser.add_argument("--scene", action="append", choices=[scene.name for scene in SCENES], help="only these")
    parser.add_argument("--only", metavar="FAULT", help="one fault, as malloc:17 or read:3+")
    parser.add_argument("--call", action="append", help="faults of these calls alone, as open")
    parser.add_argument("--minutes", type=float, default=1e9, help="stop after these")
    parser.add_argument("--each", type=int, default=4, help="the next run is looked at after each so many faults that do no harm (%(default)s)")
    parser.add_argument("--vvr", required=True)
    parser.add_argument("--library", required=True)
    asked = parser.parse_args()
    scenes = [scene for scene in SCENES if not asked.scene or scene.name in asked.scene]
    begin = time.monotonic()
    with tempfile.TemporaryDirectory(prefix="vvr-faults-") as folder:
        walk = Walk(asked.vvr, asked.library, pathlib.Path(folder))

        def goes_on():
            if walk.findings[goes_on.told:]:
                print(*walk.findings[goes_on.told:], sep="\n", file=sys.stderr, flush=True)
                goes_on.told = len(walk.findings)
            if walk.runs >= goes_on.next:
                print(f"{walk.runs} runs, {time.monotonic() - begin:.0f} s", file=sys.stderr, flush=True)
                goes_on.next += 100
            return time.monotonic() - begin < 60 * asked.minutes

        goes_on.told = 0
        goes_on.next = 100
        if asked.kills:
            chance = random.Random(asked.seed)
            for number in range(asked.kills):
                scene = scenes[number // 3 % len(scenes)]
                walk.learn(scene)
                if not goes_on():
                    break
                # Three in the same folder, and then the run that completes it.
                walk.kill(scene, chance.uniform(0, 1.1 * walk.lasted[scene.name]), number, first=number % 3 == 0, last=number % 3 == 2)
        elif asked.only:
            for scene in scenes:
                walk.inject(scene, asked.only)
        else:
            # In turn, so that an early end has seen something of each.
            for scene in scenes:
                for number, fault in enumerate(faults_of(walk, scene, asked.most, asked.seed)):
                    if asked.call and fault.split(":")[0] not in asked.call:
                        continue
                    if not goes_on():
                        break
                    walk.inject(scene, fault, always=number % asked.each == 0)
        sys.exit(tell(walk, begin))


main()
