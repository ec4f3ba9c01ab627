"""Runs of `vvr` from start to end: time, memory, processor time."""

import json
import os
import pathlib
import shutil

import plots
from measure import in_turn, median, ratios, run, spread, table
from setting import figure, frames_of, section


def seconds_of(results):
    return median([r.seconds for r in results])


def megabytes_of(results):
    return median([r.megabytes for r in results])


def numbers_of(results):
    return [[r.seconds, r.megabytes, r.processor] for r in results]


def stages(setting, clip):
    """The seconds of a run's stages, without what the report's own events take."""
    report = setting.scratch / "report.json"
    run(setting.render(clip, "--report", str(report), "--filter", "bands"))
    return json.loads(report.read_text())["seconds"]


def core_shares(ours, floor, cores):
    """What all cores did during a run of vvr: FFmpeg's work, the rest of vvr's, and neither."""
    available = cores * seconds_of(ours)
    busy = median([r.processor for r in ours]) / available
    decoding = min(busy, median([r.processor for r in floor]) / available)
    return {"decoding": decoding, "vvr": busy - decoding, "neither": max(0, 1 - busy)}


AIMS = (0.5, 0.7)  # of FFmpeg's rate
FIELDS = "384:384:force_original_aspect_ratio=decrease"  # the size of vvr's fields


def pipeline(setting):
    """Whole runs against FFmpeg decoding and scaling the same clip on as many threads."""
    cores = os.cpu_count()
    rows, numbers, bounds, drawn = [], {}, [], []
    for clip in (setting.clip, setting.made("left_bag.mp4"), setting.made("camera.mp4")):
        data = setting.scratch / "data"
        shutil.rmtree(data, ignore_errors=True)
        floor = ["ffmpeg", "-v", "error", "-threads", str(cores), "-i", clip, "-vf", f"scale={FIELDS},format=gray", "-f", "null", "-"]
        results = in_turn({"ffmpeg": floor, "render": setting.render(clip)}, setting.runs)
        # By themselves: the system still writes their gigabytes to the disk while the next program runs.
        writing = in_turn({"ffmpeg": floor, "extract": [setting.vvr, "extract", clip, "-o", str(data), "--quiet"]}, setting.runs)
        floors = {"render": results["ffmpeg"], "extract": writing["ffmpeg"]}
        results["extract"] = writing["extract"]
        frames = frames_of(clip)
        rate = {name: frames / seconds_of(of) for name, of in results.items()}
        shares = {name: ratios([r.seconds for r in of], [r.seconds for r in results[name]]) for name, of in floors.items()}
        share = {name: median(of) for name, of in shares.items()}
        name = pathlib.Path(clip).name
        rows.append([f"`{name}`", frames, *[f"{rate[of]:.0f}" for of in ("ffmpeg", "render", "extract")],
                     spread(shares["render"]), spread(shares["extract"]), spread([r.seconds for r in results["render"]]),
                     f"{megabytes_of(results['render']):.0f}"])
        cores_did = core_shares(results["render"], results["ffmpeg"], cores)
        took = stages(setting, clip)
        bounds.append(f"- `{name}`: of what {cores} cores could do meanwhile, decoding and scaling took "
                      f"{100 * cores_did['decoding']:.0f} %, the rest of vvr {100 * cores_did['vvr']:.0f} %; "
                      f"{100 * cores_did['neither']:.0f} % lay idle or went to others. Stages of one run: "
                      + ", ".join(f"{stage} {seconds:.2f} s" for stage, seconds in took.items()) + ".")
        drawn.append({"clip": name, "share": share, "cores": cores_did})
        numbers[clip] = {"frames": frames, "rates": rate, "shares": shares, "stages": took, "cores": cores_did} | {
            key: numbers_of(of) for key, of in results.items()}
    plots.pipeline(drawn, AIMS, setting.plot("pipeline"))
    measured = ("Frames per second of `vvr render CLIP -o out.png` and `vvr extract CLIP -o DIR`, all defaults, beside `ffmpeg "
                f"-threads {cores} -i CLIP -vf scale={FIELDS},format=gray -f null -`, which decodes and scales and does nothing "
                "else. A share is a rate over FFmpeg's; above 1 are clips whose frames vvr scales on more threads.")
    head = ["clip", "frames", "FFmpeg, frames/s", "render, frames/s", "extract, frames/s", "render's share", "extract's share",
            "render, s", "MB"]
    body = (figure("pipeline", "Left: vvr's rate over that of FFmpeg which only decodes and scales; dashed are the aims "
                               f"of {AIMS[0]} and {AIMS[1]}. Right: what the processor's cores did during `vvr render`.")
            + table(head, rows) + "\nWhat bounds `vvr render`:\n\n" + "\n".join(bounds))
    reached = [f"`{row['clip']}` {row['share']['render']:.2f}" for row in drawn]
    meaning = (f"`vvr render` reaches {', '.join(reached)} of FFmpeg's rate. Where the blue part of the right bars "
               "is the largest, a faster vvr would hardly make the run faster; where the orange one is, it is vvr's own work and "
               "what a run costs once, which weighs most on short clips; where the pale one is, one thread waits for another, or "
               "other programs had the cores.")
    return section("A whole run against decoding alone", measured, body, meaning), numbers


def length(setting):
    """Memory and time a frame over the clip's length."""
    clips = {"1 minute": "minute.mp4", "3 minutes": "three_minutes.mp4", "10 minutes": "minutes.mp4"}
    if setting.long:
        clips["6 hours"] = "hours.mp4"
    rows, numbers, drawn = [], {}, []
    for name, file in clips.items():
        clip = setting.made(file)
        # Of the longest once is enough: it is an average over half a million frames.
        results = in_turn({name: setting.render(clip)}, setting.runs)[name] if name != "6 hours" else [run(setting.render(clip))]
        frames = frames_of(clip)
        each = [1e3 * r.seconds / frames for r in results]
        drawn.append({"name": name, "frames": frames, "milliseconds": each, "megabytes": [r.megabytes for r in results]})
        first = drawn[0]
        held = drawn[-1]["megabytes"]
        rows.append([name, frames, spread(each), f"{median(each) / median(first['milliseconds']):.2f}", spread(held, 0),
                     f"{median(held) / median(first['megabytes']):.3f}"])
        numbers[name] = {"frames": frames, "runs": numbers_of(results)}
    plots.length(drawn, setting.plot("length"))
    measured = ("Time a frame and the most memory that `vvr render` takes, over the length of a clip: the left-bag clip over and "
                "over"
                + ("." if setting.long else "; `scripts/bench --long length` measures 6 hours as well."))
    body = (figure("length", "Time for each frame, and the most memory of the run, over the length of the clip (logarithmic); "
                             "bands are from the least to the greatest of the runs.")
            + table(["clip", "frames", "ms per frame", "of the first", "MB", "of the first"], rows))
    times = drawn[-1]["frames"] / drawn[0]["frames"]
    memory = median(drawn[-1]["megabytes"]) / median(drawn[0]["megabytes"])
    meaning = (f"A clip {times:.0f} times as long takes {memory:.2f} times the memory: it depends on the volume that is drawn "
               "and not on the clip's length. Time a frame falls, as what a run costs once is spread over more frames.")
    return section("Length of the clip", measured, body, meaning), numbers


# What is varied, one at a time, from the defaults: option, axis of the plot, values, and where the default stands among them.
VARIED = (
    ("--field-size", "thousand pixels of a field", ("96x72", "192x144", "768x576"), "384x288"),
    ("--window", "bricks (k)", ("1", "2", "32"), "8"),
    ("--size", "million pixels of the picture", ("640x400", "2560x1600", "5120x3200"), "1280x800"),
)
SCALES = {"--field-size": 1e-3, "--size": 1e-6}


def amount(option, value):
    """A value as a number: of WxH the pixels."""
    product = 1
    for side in value.split("x"):
        product *= int(side)
    return product * SCALES.get(option, 1)


def thread_counts(cores):
    """1, 2, 4, ... and all there are."""
    counts = [1]
    while 2 * counts[-1] < cores:
        counts.append(2 * counts[-1])
    return [str(count) for count in counts + [cores] if count == 1 or count != counts[-1]]


def options(setting):
    """Time and memory of a whole run over threads, resolution, bricks and viewport."""
    cores = os.cpu_count()
    varied = (("--threads", "threads", tuple(thread_counts(cores))[:-1], str(cores)),) + VARIED if cores > 1 else VARIED
    commands = {("", ""): setting.render(setting.clip)} | {
        (option, value): setting.render(setting.clip, option, value) for option, _, values, _ in varied for value in values}
    results = in_turn(commands, setting.runs)
    usual = results["", ""]
    rows, drawn = [["the defaults", spread([r.seconds for r in usual]), "", spread([r.megabytes for r in usual], 0), ""]], []
    for option, label, values, default in varied:
        of_value = {default: usual} | {value: results[option, value] for value in values}
        points = sorted((amount(option, value), value, of) for value, of in of_value.items())
        drawn.append({"label": f"{label}\n({option})", "x": [point[0] for point in points],
                      "seconds": [[r.seconds for r in point[2]] for point in points],
                      "megabytes": [[r.megabytes for r in point[2]] for point in points]})
        rows += [[f"`{option} {value}`" + (" (the default)" if value == default else ""), spread([r.seconds for r in of]),
                  f"{seconds_of(of) / seconds_of(usual):.2f}", spread([r.megabytes for r in of], 0),
                  f"{megabytes_of(of) / megabytes_of(usual):.2f}"] for _, value, of in points]
    plots.options(drawn, setting.plot("options"))
    measured = (f"Seconds and the most memory of `vvr render` of `{pathlib.Path(setting.clip).name}` as one option after another "
                "leaves its default.")
    body = (figure("options", "A whole run over the number of threads, the size of the fields that are computed, the bricks that "
                              "the volume is cut into, and the size of the picture. Above time, below the most memory; bands are "
                              "from the least to the greatest of the runs.")
            + table(["run", "s", "of the defaults", "MB", "of the defaults"], rows))
    parts = []
    for option, _, values, default in varied:
        far = max((*values, default), key=lambda value: amount(option, value))
        near = min((*values, default), key=lambda value: amount(option, value))
        last, first = results.get((option, far), usual), results.get((option, near), usual)
        parts.append(f"`{option}` from {near} to {far} takes {seconds_of(last) / seconds_of(first):.2f} times the time and "
                     f"{megabytes_of(last) / megabytes_of(first):.2f} times the memory")
    numbers = {" ".join(key).strip() or "defaults": numbers_of(of) for key, of in results.items()}
    return section("Threads, resolution, bricks, viewport", measured, body, "; ".join(parts) + "."), numbers


def startup(setting):
    """What a run costs that does nearly nothing."""
    results = in_turn({"`vvr --version`": [setting.vvr, "--version"],
                       "10 frames of 384x288 to a PNG of 640x480": setting.render(setting.made("ten_frames.mkv"), "--size", "640x480")},
                      setting.runs)
    rows = [[name, spread([1000 * r.seconds for r in of], 0)] for name, of in results.items()]
    meaning = ("The first is what a script pays to ask; the second, nearly all of it libraries and shaders that are made ready, "
               "is what each run pays before its first frame counts.")
    return (section("Start-up", "Milliseconds of runs that do nearly nothing.", table(["run", "ms"], rows), meaning),
            {name: [r.seconds for r in of] for name, of in results.items()})


def context(setting):
    """What it costs that a picture explains itself."""
    bare = ["--show", "volume,arrows,outline,frames"]
    results = in_turn({"volume, arrows, outline, frames": setting.render(setting.clip, *bare),
                       "and floor, ruler, legend, title (the default)": setting.render(setting.clip)}, setting.runs)
    seconds = {name: [r.seconds for r in of] for name, of in results.items()}
    first, last = seconds.values()
    rows = [[name, spread(of), spread(ratios(of, first), 3)] for name, of in seconds.items()]
    return section("Text, ruler and shadow", "Seconds of a run without and with what makes a picture explain itself.",
                   table(["a picture with", "s", "ratio"], rows),
                   f"With floor, ruler, legend and title a run takes {median(ratios(last, first)):.3f} of the time without."), seconds


def archive(setting):
    """A folder of clips against FFmpeg decoding one after another."""
    rows, numbers, said = [], {}, []
    for name, rate in (("camera", 25), ("sd", 10)):
        clips, out = setting.made(f"archive/{name}"), setting.scratch / "archive"
        drawn = f"rm -rf {out}; {setting.vvr} archive {clips} -o {out} --backend {setting.backend} --quiet"
        results = in_turn({"ffmpeg": ["bash", "-ec", f'for clip in {clips}/*; do ffmpeg -nostdin -v error -i "$clip" -f null -; done'],
                           "pictures": ["bash", "-ec", f"{drawn} --write pictures,index"], "pages": ["bash", "-ec", drawn]}, setting.runs)
        again = in_turn({"again": ["bash", "-ec", drawn.split("; ")[1]]}, setting.runs)["again"]
        files = sorted(pathlib.Path(clips).iterdir())
        frames = sum(frames_of(str(file)) for file in files)
        seconds = {kind: seconds_of(of) for kind, of in results.items()}
        cpu = {kind: median([r.processor for r in of]) for kind, of in results.items()}
        written = sum(file.stat().st_size for file in out.rglob("*") if file.is_file())
        rows.append([name, len(files), frames, *[f"{frames / seconds[kind]:.0f}" for kind in ("ffmpeg", "pictures", "pages")],
                     f"{seconds['ffmpeg'] / seconds['pictures']:.2f}", f"{seconds['ffmpeg'] / seconds['pages']:.2f}",
                     f"{cpu['ffmpeg'] / cpu['pictures']:.2f}", f"{cpu['ffmpeg'] / cpu['pages']:.2f}",
                     f"{1000 * seconds_of(again):.0f}", f"{written / len(files) / 1e6:.1f}"])
        said.append(f"an hour of {name} video takes {3600 * rate * seconds['pages'] / frames:.0f} s with pages")
        numbers[name] = {"clips": len(files), "frames": frames, "bytes": written, "again": [r.seconds for r in again]} | {
            kind: [[r.seconds, r.processor] for r in of] for kind, of in results.items()}
    measured = ("`vvr archive CLIPS -o OUT`, all defaults, with pages and with `--write pictures,index`, beside `ffmpeg -i CLIP -f null -` "
                "for one clip after another, which decodes and throws away. camera: a generated hall of 1920×1080 "
                "at 25 frames/s, H.264 at 4 Mbit/s, a minute each. sd: parts of vtest.avi, 768×576 at 10 frames/s, MPEG-4, 60 or 80 "
                "seconds each.")
    head = ["clips", "number", "frames", "FFmpeg, frames/s", "pictures, frames/s", "pages, frames/s", "pictures to FFmpeg",
            "pages to FFmpeg", "pictures, by CPU time", "pages, by CPU time", "nothing new, ms", "MB a clip"]
    return section("An archive", measured, table(head, rows), f"On this machine {' and '.join(said)}."), numbers
