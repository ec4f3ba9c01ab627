"""The page of a clip in Chromium with its software rasteriser: what its parts weigh, when it can be used, and what turning costs."""

import os
import pathlib
import re
import shutil
import sys
import time

from measure import median, run, table
from setting import section

sys.path.append(str(pathlib.Path(__file__).parent.parent / "cli"))

SOFTWARE = ("--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist")
VIEWS = {"desktop": (1440, 900, False, 1, 0), "desktop, 1.5 Mbit/s": (1440, 900, False, 1, 1.5), "phone, 1.5 Mbit/s": (390, 844, True, 4, 1.5)}
# The view of the volume alone, in the size in which frames are timed.
SMALL = """const style = new CSSStyleSheet();
    style.replaceSync('#view { --buttons: 0px !important; --meaning: 0px !important; width: 320px !important; height: 190px !important; border: 0 !important }');
    document.adoptedStyleSheets = [style]; set({tab: 'volume'})"""
# Notes what moves before one's eyes, and makes the volume as soon as it has come, however slow the software rasteriser is.
WATCH = """window.shifts = [];
new PerformanceObserver(list => {
    for (const entry of list.getEntries()) if (!entry.hadRecentInput) shifts.push([entry.value, ...entry.sources.map(({node}) => node?.id || node?.nodeName)]);
}).observe({type: 'layout-shift', buffered: true});
const timer = setInterval(() => {
    if (!window.vvr?.state.parts.volume) return;
    clearInterval(timer);
    vvr.prepareVolume(1e9);
}, 20);"""
# Turns a little at each frame; at rest, waits until each angle is drawn in full. The last frame is read back, and so is done.
TURNS = """const done = arguments[arguments.length - 1];
const [count, rests] = arguments;
const {volume} = document.all;
let left = count;
const next = () => {
    if (left-- === 0) return vvr.pickedAround(5, 5, 0), done([volume.width, volume.height]);
    const drawn = volume.dataset.drawn;
    vvr.set({angle: [left % 20 - 10, 46]});
    const wait = () => rests && volume.dataset.drawn === drawn ? setTimeout(wait, 20) : requestAnimationFrame(next);
    wait();
};
next();"""


def weight(path):
    """Of each part, in kB."""
    text = path.read_text()
    sizes = {"picture": len(re.search(r'<img id="picture" src="([^"]*)"', text)[1]), "style": sum(map(len, re.findall(r"<style>(.*?)</style>", text, re.S))),
             "script": sum(map(len, re.findall(r"<script>(.*?)</script>", text, re.S)))}
    for name in ("data", "pixeldata", "stilldata", "volumedata", "previewdata"):
        sizes[name.removesuffix("data") or "data"] = len(re.search(rf'<script type="application/json" id="{name}">(.*?)</script>', text, re.S)[1])
    return {"all": len(text), **sizes}


def processor_seconds():
    """Of the browser, which is all that this process has started."""
    parents, used = {}, {}
    for stat in pathlib.Path("/proc").glob("[0-9]*/stat"):
        try:
            fields = stat.read_text().rsplit(")", 1)[1].split()
        except OSError:
            continue
        parents[int(stat.parent.name)], used[int(stat.parent.name)] = int(fields[1]), int(fields[11]) + int(fields[12])

    def is_mine(process):
        while process in parents:
            process = parents[process]
            if process == os.getpid():
                return True
        return False
    return sum(ticks for process, ticks in used.items() if is_mine(process)) / os.sysconf("SC_CLK_TCK")


class Folder:
    """What Page needs of a test's folder."""

    def __init__(self, path):
        self.folder = pathlib.Path(path)

    def path(self, name):
        return self.folder / name


def loading(folder, kind, again):
    """Milliseconds until the page is usable and until its volume turns, by how much things leap, and megabytes that it needs."""
    from browser import Page, Served
    width, height, mobile, slower, rate = VIEWS[kind]
    with Served(folder.folder) as served, Page(folder, served.url("page.html"), *SOFTWARE) as page:
        page.driver.get("about:blank")
        page.window(width, height, mobile)
        page.cdp("Emulation.setCPUThrottlingRate", rate=slower)
        page.cdp("Network.enable")
        if rate:
            page.cdp("Network.emulateNetworkConditions", offline=False, latency=40, downloadThroughput=rate * 1e6 / 8, uploadThroughput=rate * 1e6 / 8)
        page.cdp("Page.addScriptToEvaluateOnNewDocument", source=WATCH)
        page.driver.get(served.url(f"page.html?{again}"))
        page.wait("all has come, and it turns", "return allArrived && turnable", 120)
        time.sleep(0.5)
        shifts = page.run("return shifts")
        marks = page.run("return ['usable', 'turnable'].map(name => performance.getEntriesByName(name).at(-1).startTime)")
        page.cdp("HeapProfiler.collectGarbage")
        heap = page.cdp("Runtime.getHeapUsage")
        print(kind, [round(mark) for mark in marks], shifts, file=sys.stderr)
        return [*marks, sum(value for value, *_ in shifts), (heap["usedSize"] + heap.get("backingStorageSize", 0)) / 1e6]


def drawing(folder):
    """Processor time and time of a frame of 320x190, at rest and while it moves: milliseconds."""
    from browser import Page
    with Page(folder, "page.html", *SOFTWARE) as page:
        page.window(390, 844)
        page.run(SMALL)
        page.wait("the volume has come", "return parts.volume !== null")
        page.run("prepareVolume(1e9)")
        page.wait("it turns", "return turnable", 60)
        page.run("set({turns: true})")
        time.sleep(2)
        page.driver.set_script_timeout(120)
        count = 16

        def turned(rests):
            begin, used = time.monotonic(), processor_seconds()
            size = page.driver.execute_async_script(TURNS, count, rests)
            return size, 1000 * (processor_seconds() - used) / count, 1000 * (time.monotonic() - begin) / count
        turned(False)
        _, moving, seconds = turned(False)
        size, both, _ = turned(True)
        print(size, file=sys.stderr)
        return moving, seconds, both - moving


def browser(setting):
    folder = Folder(setting.scratch / "browser")
    folder.folder.mkdir(exist_ok=True)
    shutil.copy(setting.clip, folder.path("clip" + pathlib.Path(setting.clip).suffix))
    run([setting.vvr, "render", str(folder.path("clip" + pathlib.Path(setting.clip).suffix)), "-o", str(folder.path("page.html")), "--backend",
         setting.backend, "--quiet"])
    sizes = weight(folder.path("page.html"))
    rows, numbers = [], {"weight": sizes}
    for kind in VIEWS:
        found = [loading(folder, kind, again) for again in range(setting.runs)]
        usable, turns, shift, heap = (median(values) for values in zip(*found))
        rows.append([kind, f"{usable / 1000:.1f}", f"{turns / 1000:.1f}", f"{shift:.3f}", f"{heap:.0f}"])
        numbers[kind] = found
    moving, seconds, rest = (median(values) for values in zip(*[drawing(folder) for _ in range(setting.runs)]))
    numbers["drawing"] = [moving, seconds, rest]
    body = (table(["kB", *sizes], [["page", *[f"{size / 1000:.0f}" for size in sizes.values()]]]) + "\n" +
            table(["", "usable, s", "turns, s", "layout shift", "heap, MB"], rows) +
            f"\nA view of 320×190 takes {moving:.0f} ms of processor time while it moves ({seconds:.0f} ms by the clock), {rest:.0f} ms at rest.\n")
    return section("A page in a browser", "Chromium with SwiftShader; a phone is 390×844, its processor four times as slow.", body), numbers
