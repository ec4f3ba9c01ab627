"""Runs of `vvr` from start to end: time, memory, processor time."""

import json
import os
import pathlib
import shutil

from measure import in_turn, median, ratios, run, spread, table
from setting import frames_of, section


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


FIELDS = "384:384:force_original_aspect_ratio=decrease"  # the size of vvr's fields


def floor_of(clip):
    """FFmpeg decoding and scaling a clip on as many threads as vvr uses."""
    return ["ffmpeg", "-v", "error", "-threads", str(os.cpu_count()), "-i", clip, "-vf", f"scale={FIELDS},format=gray", "-f", "null", "-"]


FLOOR = f"`ffmpeg -threads {os.cpu_count()} -i CLIP -vf scale={FIELDS},format=gray -f null -`"


def seconds_over(results, others):
    return ratios([r.seconds for r in results], [r.seconds for r in others])


def processor_over(results, others):
    return ratios([r.processor for r in results], [r.processor for r in others])


def beside_ffmpeg(setting, clips, what):
    """Renders each clip with several choices of frames, in turn with FFmpeg. `clips`: names, and the choices of `--decode` for each."""
    rows, numbers = [], {}
    for name, choices in clips.items():
        clip = setting.made(name)
        results = in_turn({"ffmpeg": floor_of(clip)} | {choice: setting.render(clip, "--decode", choice) for choice in choices}, setting.runs)
        frames, floor = frames_of(clip), results["ffmpeg"]
        for choice in choices:
            of = results[choice]
            rows.append([f"`{name}`", frames, f"{frames / seconds_of(floor):.0f}", choice, spread(seconds_over(floor, of)),
                         spread(processor_over(of, floor)), spread(seconds_over(results["all"], of)), f"{megabytes_of(of):.0f}"])
        numbers[name] = {"frames": frames} | {key: numbers_of(of) for key, of in results.items()}
    measured = (f"`vvr render CLIP -o out.png --decode CHOICE` beside {FLOOR}. {what} A camera's have no B-frames. Rate: frames per second "
                "over FFmpeg's; time: processor time over FFmpeg's; speed: rate over that of `all`.")
    head = ["clip", "frames", "FFmpeg, frames/s", "decode", "rate", "time", "speed", "MB"]
    return measured, table(head, rows), numbers


def cameras(setting):
    """Large pictures as cameras and recorders write them, with all frames decoded and with fewer."""
    every = ("all", "auto", "key")
    names = ("camera.mp4", "camera_h265.mp4", "recorder.mp4", "camera_4k.mp4", "camera_4k_h265.mp4")
    measured, body, numbers = beside_ffmpeg(setting, dict.fromkeys(names, every),
                                            "A generated hall at 25 frames/s: 1920×1080 for 60 s, 3840×2160 for 20 s.")
    return section("Large pictures", measured, body), numbers


def files(setting):
    """The same in files as long as recorders write them, in which fixed costs count less."""
    choices = {"camera_file.mp4": ("all", "key"), "camera_h265_file.mp4": ("all", "key"), "recorder_file.mp4": ("all", "auto", "key"),
               "camera_4k_file.mp4": ("all", "key")}
    measured, body, numbers = beside_ffmpeg(setting, choices, "The clips of large pictures over and over: ten minutes of 1920×1080, two of "
                                            "3840×2160. Without B-frames, `auto` decodes all frames.")
    return section("Files of recorders", measured, body), numbers


def page(setting):
    """A page over a picture."""
    rows, numbers = [], {}
    for clip in (setting.clip, setting.made("vtest_h264.mp4"), setting.made("camera.mp4")):
        page_of = setting.render(clip)
        page_of[page_of.index("-o") + 1] = str(setting.scratch / "out.html")
        results = in_turn({"picture": setting.render(clip), "page": page_of}, setting.runs)
        rows.append([f"`{pathlib.Path(clip).name}`", *[f"{median([r.processor for r in of]):.2f}" for of in results.values()],
                     spread(processor_over(results["page"], results["picture"])), f"{megabytes_of(results['page']):.0f}"])
        numbers[clip] = {key: numbers_of(of) for key, of in results.items()}
    measured = "Processor time of `vvr render CLIP -o out.html` over that of `-o out.png`, all defaults."
    return section("A page", measured, table(["clip", "picture, s", "page, s", "ratio", "MB"], rows)), numbers


def pipeline(setting):
    """Whole runs against FFmpeg decoding and scaling the same clip on as many threads."""
    rows, numbers = [], {}
    for clip in (setting.clip, setting.made("vtest_h264.mp4"), setting.made("left_bag.mp4")):
        data = setting.scratch / "data"
        shutil.rmtree(data, ignore_errors=True)
        floor = floor_of(clip)
        results = in_turn({"ffmpeg": floor, "render": setting.render(clip)}, setting.runs)
        # By themselves: the system still writes their gigabytes to the disk while the next program runs.
        writing = in_turn({"ffmpeg": floor, "extract": [setting.vvr, "extract", clip, "-o", str(data), "--quiet"]}, setting.runs)
        floors = {"render": results["ffmpeg"], "extract": writing["ffmpeg"]}
        results["extract"] = writing["extract"]
        frames = frames_of(clip)
        rate = {name: frames / seconds_of(of) for name, of in results.items()}
        shares = {name: seconds_over(of, results[name]) for name, of in floors.items()}
        processor = processor_over(results["render"], results["ffmpeg"])
        took = stages(setting, clip)
        rows.append([f"`{pathlib.Path(clip).name}`", frames, *[f"{rate[of]:.0f}" for of in ("ffmpeg", "render", "extract")],
                     spread(shares["render"]), spread(shares["extract"]), spread([r.seconds for r in results["render"]]),
                     f"{megabytes_of(results['render']):.0f}", f"{median([r.processor for r in results['ffmpeg']]):.2f}", spread(processor),
                     ", ".join(f"{stage} {seconds:.2f}" for stage, seconds in took.items())])
        numbers[clip] = {"frames": frames, "rates": rate, "shares": shares, "stages": took, "processor": processor} | {
            key: numbers_of(of) for key, of in results.items()}
    measured = (f"`vvr render CLIP -o out.png` and `vvr extract CLIP -o DIR`, all defaults, beside {FLOOR}. A relative rate is a rate "
                "over FFmpeg's.")
    head = ["clip", "frames", "FFmpeg, frames/s", "render, frames/s", "extract, frames/s", "render, relative", "extract, relative",
            "render, s", "MB", "FFmpeg, processor s", "render, processor time over FFmpeg's", "stages of one run, s"]
    return section("A whole run against decoding alone", measured, table(head, rows)), numbers


def length(setting):
    """Memory and time a frame over the clip's length."""
    clips = {"1 minute": "minute.mp4", "3 minutes": "three_minutes.mp4", "10 minutes": "minutes.mp4"}
    if setting.long:
        clips |= {"1 hour": "hour.mp4", "6 hours": "hours.mp4"}
    rows, numbers, first = [], {}, None
    for name, file in clips.items():
        clip = setting.made(file)
        # Of the longest once is enough: it is an average over half a million frames.
        results = in_turn({name: setting.render(clip)}, setting.runs)[name] if name != "6 hours" else [run(setting.render(clip))]
        frames = frames_of(clip)
        each, held = [1e3 * r.seconds / frames for r in results], [r.megabytes for r in results]
        first = first or (median(each), median(held))
        rows.append([name, frames, spread(each), f"{median(each) / first[0]:.2f}", spread(held, 0), f"{median(held) / first[1]:.3f}"])
        numbers[name] = {"frames": frames, "runs": numbers_of(results)}
    measured = "`vvr render` of the left-bag clip over and over; `scripts/bench --long length` measures 1 and 6 hours as well."
    return section("Length of the clip", measured, table(["clip", "frames", "ms per frame", "of the first", "MB", "of the first"], rows)), numbers


# What is varied, one at a time, from the defaults.
VARIED = {
    "--field-size": ("96x72", "192x144", "768x576"),
    "--window": ("1", "2", "32"),
    "--size": ("640x400", "2560x1600", "5120x3200"),
}


def thread_counts(cores):
    """1, 2, 4, ... and all there are."""
    counts = [1]
    while 2 * counts[-1] < cores:
        counts.append(2 * counts[-1])
    return [str(count) for count in counts + [cores] if count == 1 or count != counts[-1]]


def options(setting):
    """Time and memory of a whole run over threads, resolution, bricks and viewport."""
    varied = {"--threads": thread_counts(os.cpu_count())[:-1]} | VARIED
    commands = {"the defaults": setting.render(setting.clip)} | {
        f"`{option} {value}`": setting.render(setting.clip, option, value) for option, values in varied.items() for value in values}
    results = in_turn(commands, setting.runs)
    usual = results["the defaults"]
    rows = [[name, spread([r.seconds for r in of]), f"{seconds_of(of) / seconds_of(usual):.2f}", spread([r.megabytes for r in of], 0),
             f"{megabytes_of(of) / megabytes_of(usual):.2f}"] for name, of in results.items()]
    measured = f"`vvr render` of `{pathlib.Path(setting.clip).name}` as one option after another leaves its default."
    return section("Threads, resolution, bricks, viewport", measured, table(["run", "s", "relative", "MB", "relative"], rows)), {
        name: numbers_of(of) for name, of in results.items()}


def startup(setting):
    """What a run costs that does nearly nothing."""
    results = in_turn({"`vvr --version`": [setting.vvr, "--version"],
                       "10 frames of 384x288 to a PNG of 640x480": setting.render(setting.made("ten_frames.mkv"), "--size", "640x480")},
                      setting.runs)
    rows = [[name, spread([1000 * r.seconds for r in of], 0)] for name, of in results.items()]
    return (section("Start-up", "Milliseconds of runs that do nearly nothing.", table(["run", "ms"], rows)),
            {name: [r.seconds for r in of] for name, of in results.items()})


def context(setting):
    """What it costs that a picture explains itself."""
    bare = ["--show", "volume,arrows,outline,frames"]
    results = in_turn({"volume, arrows, outline, frames": setting.render(setting.clip, *bare),
                       "and floor, ruler, legend, title (the default)": setting.render(setting.clip)}, setting.runs)
    seconds = {name: [r.seconds for r in of] for name, of in results.items()}
    first, _ = seconds.values()
    rows = [[name, spread(of), spread(ratios(of, first), 3)] for name, of in seconds.items()]
    return section("Text, ruler and shadow", "Seconds of a run without and with what makes a picture explain itself.",
                   table(["a picture with", "s", "ratio"], rows)), seconds


def decode_each(clips):
    """FFmpeg decoding the clips of a folder one after another."""
    return ["bash", "-ec", f'for clip in {clips}/*; do ffmpeg -nostdin -v error -i "$clip" -f null -; done']


def archive_of(setting, clips, out):
    return [setting.vvr, "archive", str(clips), "-o", str(out), "--backend", setting.backend, "--quiet"]


def archive(setting):
    """A folder of clips against FFmpeg decoding one after another."""
    rows, numbers = [], {}
    for name, rate in (("camera", 25), ("sd", 10)):
        clips, out = setting.made(f"archive/{name}"), setting.scratch / "archive"
        drawn = f"rm -rf {out}; {setting.vvr} archive {clips} -o {out} --backend {setting.backend} --quiet"
        results = in_turn({"ffmpeg": decode_each(clips),
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
                     f"{3600 * rate * seconds['pages'] / frames:.0f}", f"{1000 * seconds_of(again):.0f}", f"{written / len(files) / 1e6:.1f}"])
        numbers[name] = {"clips": len(files), "frames": frames, "bytes": written, "again": [r.seconds for r in again]} | {
            kind: [[r.seconds, r.processor] for r in of] for kind, of in results.items()}
    measured = ("`vvr archive CLIPS -o OUT`, all defaults, with pages and with `--write pictures,index`, beside `ffmpeg -i CLIP -f null -` "
                "for one clip after another, which decodes and throws away. camera: a generated hall of 1920×1080 "
                "at 25 frames/s, H.264 at 4 Mbit/s, a minute each. sd: parts of vtest.avi, 768×576 at 10 frames/s, MPEG-4, 60 or 80 "
                "seconds each.")
    head = ["clips", "number", "frames", "FFmpeg, frames/s", "pictures, frames/s", "pages, frames/s", "pictures to FFmpeg",
            "pages to FFmpeg", "pictures, by CPU time", "pages, by CPU time", "an hour of video with pages, s", "nothing new, ms", "MB a clip"]
    return section("An archive", measured, table(head, rows)), numbers


def grow(clips, out, first, end):
    """Copies a drawn archive into its subfolders `first` to `end`, with links to all files except the sidecars, which name their clip."""
    copied = [path for path in clips.iterdir() if path.is_file()]
    for number in range(first, end):
        name = f"copy{number}"
        for folder in (clips, out):
            (folder / name).mkdir()
        for clip in copied:
            os.link(clip, clips / name / clip.name)
            for file in out.glob(f"{clip.name}.*"):
                if file.name == f"{clip.name}.json":
                    text = file.read_text().replace(f'"path": "{clip.name}"', f'"path": "{name}/{clip.name}"')
                    (out / name / file.name).write_text(text)
                else:
                    os.link(file, out / name / file.name)


def again_as_it_grows(setting, source, out):
    """Runs that find nothing new, of a drawn archive and of copies of it."""
    clips = setting.scratch / "grown"
    shutil.copytree(source, clips, copy_function=shutil.copy2)
    command = archive_of(setting, clips, out)
    rows, numbers, copies = [], {}, 1
    for size in (1, 2, 20, 200) if setting.long else (1, 2, 20):
        grow(clips, out, copies, size)
        copies = size
        run(command)  # writes the index
        runs = [run(command) for _ in range(setting.runs)]
        count = size * len(list(source.iterdir()))
        numbers[count] = numbers_of(runs)
        index = sum(file.stat().st_size for file in out.glob("index*")) / 1e6
        rows.append([count, spread([r.seconds for r in runs]), f"{1000 * median([r.seconds for r in runs]) / count:.2f}",
                     f"{megabytes_of(runs):.0f}", f"{index:.1f}"])
    return table(["clips", "seconds", "seconds per 1,000 clips", "MB", "index, MB"], rows), numbers


def many(setting):
    """Many small clips: each costs a start of the program. Run once, as that is an average over all of them."""
    clips, out = pathlib.Path(setting.made("many")), setting.scratch / "many"
    files = sorted(str(path) for path in clips.iterdir())
    frames = sum(frames_of(file) for file in files[:10]) * len(files) // 10
    floor = run(decode_each(clips))
    first = run(archive_of(setting, clips, out))
    drawn = len(list(out.glob("*.html"))) - 1  # without the index
    if drawn != len(files):
        raise RuntimeError(f"{drawn} of {len(files)} clips were drawn; are they younger than a minute?")
    measured = ("`vvr archive CLIPS -o OUT`, all defaults, with pages, beside `ffmpeg -i CLIP -f null -` for one clip after another. Parts of "
                "vtest.avi of 6 s, 320×240, 10 frames/s, H.264.")
    rows = [[len(files), frames, f"{frames / floor.seconds:.0f}", f"{frames / first.seconds:.0f}", f"{floor.seconds / first.seconds:.2f}",
             f"{first.processor / floor.processor:.2f}", f"{first.processor / len(files):.2f}", f"{first.megabytes:.0f}"]]
    head = ["clips", "frames", "FFmpeg, frames/s", "pages, frames/s", "pages to FFmpeg", "processor time over FFmpeg's",
            "processor time per clip, s", "MB"]
    again, numbers = again_as_it_grows(setting, clips, out)
    body = (table(head, rows) + "\nA run that finds nothing new, as the archive grows by copies of itself in subfolders:\n\n" + again)
    return section("Many small clips", measured, body), {
        "clips": len(files), "frames": frames, "ffmpeg": numbers_of([floor]), "first": numbers_of([first]), "again": numbers}
