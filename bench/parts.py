"""The parts of the benchmark: each measures, and gives its section of the report and its numbers."""

import json
import os
import pathlib
import shutil
import subprocess
from dataclasses import dataclass

import plots
from measure import in_turn, median, output_of, run, spread, table

VVR = "build/release/cli/vvr"
BENCH = "build/release/bench"


@dataclass
class Setting:
    clip: str
    runs: int
    backend: str
    scratch: pathlib.Path
    reports: pathlib.Path  # where the plots go
    long: bool = False  # whether what takes an hour is measured too


def render(setting, clip, *options):
    return [VVR, "render", clip, "-o", str(setting.scratch / "out.png"), "--backend", setting.backend, "--quiet", *options]


def frames_of(clip):
    counted = subprocess.run(["ffprobe", "-v", "error", "-count_packets", "-select_streams", "v", "-show_entries",
                              "stream=nb_read_packets", "-of", "csv=p=0", clip], check=True, stdout=subprocess.PIPE)
    return int(counted.stdout.decode().strip().rstrip(","))


def stages(setting, clip):
    """The seconds of a run's stages, without what the report's own events take."""
    report = setting.scratch / "report.json"
    run(render(setting, clip, "--report", str(report), "--filter", "bands"))
    return json.loads(report.read_text())["seconds"]


def bound(ours, floor, cores):
    """What keeps a run from being faster, in words."""
    busy = median([r.processor / r.seconds for r in ours]) / cores
    decoding = median([r.processor for r in floor]) / median([r.processor for r in ours])
    return (f"FFmpeg's decoding and scaling takes {decoding:.2f} of the processor time, which no other load changes; the run had "
            f"{100 * busy:.0f} % of the cores")


def pipeline(setting):
    """Whole runs against FFmpeg decoding and scaling the same clip on as many threads."""
    cores = os.cpu_count()
    rows, numbers, bounds = [], {}, []
    for clip in (setting.clip, ".cache/bench/left_bag.mp4", ".cache/bench/hd.mp4"):
        data = setting.scratch / "data"
        shutil.rmtree(data, ignore_errors=True)
        floor = ["ffmpeg", "-v", "error", "-threads", str(cores), "-i", clip, "-vf", "scale=384:288,format=gray", "-f", "null", "-"]
        results = in_turn({"ffmpeg": floor, "render": render(setting, clip), "extract": [VVR, "extract", clip, "-o", str(data), "--quiet"]},
                          setting.runs)
        frames = frames_of(clip)
        rate = {name: frames / median([r.seconds for r in of]) for name, of in results.items()}
        name = pathlib.Path(clip).name
        rows.append([f"`{name}`", frames, f"{rate['ffmpeg']:.0f}", f"{rate['render']:.0f}", f"{rate['extract']:.0f}",
                     f"{rate['render'] / rate['ffmpeg']:.2f}", f"{rate['extract'] / rate['ffmpeg']:.2f}",
                     spread([r.seconds for r in results["render"]]), f"{median([r.megabytes for r in results['render']]):.0f}"])
        took = stages(setting, clip)
        bounds.append(f"- `{name}`: {bound(results['render'], results['ffmpeg'], cores)}. Stages of one run: "
                      + ", ".join(f"{stage} {seconds:.2f} s" for stage, seconds in took.items()) + ".")
        numbers[clip] = {"frames": frames, "rates": rate, "stages": took} | {
            key: [[r.seconds, r.megabytes, r.processor] for r in of] for key, of in results.items()}
    text = ("## A whole run against decoding alone\n\n`vvr render CLIP -o out.png` and `vvr extract CLIP -o DIR`, all defaults, beside "
            f"`ffmpeg -threads {cores} -i CLIP -vf scale=384:288,format=gray -f null -`, which decodes and scales and does nothing "
            "else: no program can be faster. A share is a rate over FFmpeg's.\n\n")
    head = ["clip", "frames", "FFmpeg, frames/s", "render, frames/s", "extract, frames/s", "render's share", "extract's share",
            "render, s", "MB"]
    return text + table(head, rows) + "\nWhat bounds `vvr render`:\n\n" + "\n".join(bounds) + "\n", numbers


def length(setting):
    """Memory and time a frame over the clip's length."""
    clips = {"1 minute": "minute.mp4", "10 minutes": "minutes.mp4"} | ({"6 hours": "hours.mp4"} if setting.long else {})
    rows, numbers, first = [], {}, None
    for name, file in clips.items():
        clip = f".cache/bench/{file}"
        # The longest takes an hour: once is enough for what is an average over half a million frames.
        results = in_turn({name: render(setting, clip)}, setting.runs)[name] if name != "6 hours" else [run(render(setting, clip))]
        frames = frames_of(clip)
        each = 1e3 * median([r.seconds for r in results]) / frames
        held = median([r.megabytes for r in results])
        first = first or (each, held)
        rows.append([name, frames, f"{each:.2f}", f"{each / first[0]:.2f}", f"{held:.0f}", f"{held / first[1]:.3f}"])
        numbers[name] = {"frames": frames, "runs": [[r.seconds, r.megabytes] for r in results]}
    text = ("## Length of the clip\n\nThe left-bag clip over and over"
            + ("" if setting.long else "; `scripts/bench --long length` measures 6 hours as well, which takes most of an hour") + ".\n\n"
            + table(["clip", "frames", "ms a frame", "of the first", "MB", "of the first"], rows))
    return text, numbers


def threads(setting):
    """Time over the number of threads and the size of the fields."""
    results = in_turn({f"{count} thread{'s' if count > 1 else ''}": render(setting, setting.clip, "--threads", str(count))
                       for count in range(1, os.cpu_count() + 1)}
                      | {f"fields of {size}": render(setting, setting.clip, "--field-size", size) for size in ("192x144", "768x576")},
                      setting.runs)
    rows = [[name, spread([r.seconds for r in of]), f"{median([r.megabytes for r in of]):.0f}"] for name, of in results.items()]
    return ("## Threads, resolution\n\nThe footage with other options than the defaults.\n\n" + table(["run", "s", "MB"], rows),
            {name: [[r.seconds, r.megabytes] for r in of] for name, of in results.items()})


def startup(setting):
    """What a run costs that does nearly nothing."""
    results = in_turn({"`vvr --version`": [VVR, "--version"],
                       "10 frames of 384x288 to a PNG of 640x480": render(setting, ".cache/bench/ten_frames.mkv", "--size", "640x480")},
                      setting.runs)
    rows = [[name, spread([1000 * r.seconds for r in of], 0)] for name, of in results.items()]
    return "## Start-up\n\n" + table(["run", "ms"], rows), {name: [r.seconds for r in of] for name, of in results.items()}


def context(setting):
    """What it costs that a picture explains itself."""
    bare = ["--show", "volume,arrows,outline,frames"]
    results = in_turn({"volume, arrows, outline, frames": render(setting, setting.clip, *bare),
                       "and floor, ruler, legend, title (the default)": render(setting, setting.clip)}, setting.runs)
    seconds = {name: [r.seconds for r in of] for name, of in results.items()}
    first = median(next(iter(seconds.values())))
    rows = [[name, spread(of), f"{median(of) / first:.3f}"] for name, of in seconds.items()]
    return "## Text, ruler and shadow\n\n" + table(["a picture with", "s", "ratio"], rows), seconds


# Of a point in a step, core/fields/flows/linear_kernels.cpp: multiplications and additions, bytes of its nine planes.
STEP_FLOPS, STEP_BYTES = 24, 36


def roofline(rows):
    """What this machine lets the Jacobi steps reach, and what they do reach."""
    jacobi, roof = rows["JacobiAgainstPlainLoop"], rows["Roofline"]
    points = 384 * 288 * 60 / 1e3
    rate, best = points / jacobi["jacobi_ms"], points / jacobi["best_jacobi_ms"]
    by_arithmetic = 1e3 * roof["peak_gflops"] / STEP_FLOPS
    by_cache = 1e3 * roof["gbytes_400k"] / STEP_BYTES
    by_memory = 1e3 * roof["gbytes_64m"] / STEP_BYTES
    limit = min(by_arithmetic, by_cache)
    text = (f"Horn–Schunck, 60 Jacobi steps at 384×288, one core: {jacobi['jacobi_ms']:.2f} ms = {rate:.0f} million pixel-steps a "
            f"second, the best of 30 runs {best:.0f}; a plain loop compiled with -O2 takes {jacobi['plain_ms']:.1f} ms, "
            f"{jacobi['ratio']:.1f} times as long.\n\nA step takes {STEP_FLOPS} multiplications and additions a point and reads or writes "
            f"{STEP_BYTES} bytes. What bounds it, measured in the same run:\n\n")
    text += table(["", "of this core", "million pixel-steps/s"], [
        ["arithmetic", f"{roof['peak_gflops']:.0f} GFLOP/s", f"{by_arithmetic:.0f}"],
        ["second-level cache (what 20 steps together touch)", f"{roof['gbytes_400k']:.0f} GB/s", f"{by_cache:.0f}"],
        ["memory, were each step to go through it all", f"{roof['gbytes_64m']:.0f} GB/s", f"{by_memory:.0f}"]])
    return text + f"\nThe lowest roof over running steps together is {limit:.0f}; the best run reaches {best / limit:.2f} of it.\n\n"


def kernels(setting):
    """The fields' kernels against plain loops and the machine, and rates of all fields."""
    report = output_of([f"{BENCH}/bench_fields", "--benchmark_format=json", "--benchmark_min_time=0.2"])
    by_name = {row["name"].split("/iterations")[0].split("/real_time")[0]: row for row in report["benchmarks"]}
    grid = by_name["MultigridAgainstJacobi"]
    text = "## Kernels\n\n" + roofline(by_name)
    text += (f"The multigrid solver takes {grid['multigrid_ms']:.2f} ms and leaves {grid['multigrid_residual']:.1e} of the residual, "
             f"where 60 steps leave {grid['jacobi_residual']:.1e}.\n\n")
    rows = [[name.split("/")[1], f"{row['cpu_time']:.2f}"] for name, row in by_name.items() if name.startswith("flow_of_a_frame")]
    text += table(["flow of a frame, 384×288", "ms"], rows) + "\n"
    rows = [[name.split("/")[1], f"{row['cpu_time'] / 20:.2f}"] for name, row in by_name.items() if name.startswith("filter_of_frames")]
    text += table(["filter of a frame in colour, 384×288, one core", "ms"], rows)
    text += f"\nSeeds of a frame in which all moves: {by_name['seeds_of_a_frame']['cpu_time']:.0f} µs.\n"
    rates = output_of([f"{BENCH}/fields_rate", setting.clip])
    text += f"\nFields of `{pathlib.Path(setting.clip).name}` on two threads:\n\n" + table(
        ["", "frames/s"], [[name, spread(values, 0)] for name, values in rates.items()])
    return text, {"benchmarks": report["benchmarks"], "rates": rates}


def peers(setting):
    """Flow methods beside OpenCV's, and the loop that people script to find motion."""
    report = output_of([f"{BENCH}/peers", "flow"])
    scenes = list(dict.fromkeys(row["scene"] for row in report))
    cell = {(row["method"], row["scene"]): row for row in report}
    rows = [[method, *[f"{1000 * median(cell[method, s]['seconds']):.1f} ms, {cell[method, s]['degrees']:.1f}°" for s in scenes]]
            for method in dict.fromkeys(row["method"] for row in report)]
    text = ("## Beside OpenCV\n\nThe flow of a frame of 384×288 on one core, and the mean angle between (u, v, 1) and the truth, on generated "
            "scenes with the noise of a camera.\n\n" + table(["method", *scenes], rows))
    width, height = 768, 576
    piped = ["bash", "-c", f"ffmpeg -v error -i {setting.clip} -vf scale={width}:{height} -f rawvideo -pix_fmt bgr24 - | "
             f"{BENCH}/peers motion {width} {height}"]
    motion = in_turn({"FFmpeg, OpenCV's MOG2, opening, blobs": piped, "vvr render, all defaults": render(setting, setting.clip)},
                     setting.runs)
    first = median([r.seconds for r in next(iter(motion.values()))])
    text += (f"\nA scan for motion as people script it, over `{pathlib.Path(setting.clip).name}` at its own size, and a picture of "
             "the same clip:\n\n" + table(["", "s", "ratio"], [[name, spread([r.seconds for r in of]),
                                                               f"{median([r.seconds for r in of]) / first:.2f}"] for name, of in motion.items()]))
    return text, {"flow": report, "motion": {name: [r.seconds for r in of] for name, of in motion.items()}}


def fps(seconds):
    return 1 / median(seconds)


def table1_of(report):
    sizes = sorted({(row["width"], row["height"]) for row in report["rows"]})
    styles = list(dict.fromkeys(row["style"] for row in report["rows"]))
    cell = {(row["style"], row["width"]): row for row in report["rows"]}
    head = ["style", *[f"{width}×{height}" for width, height in sizes]]
    rows = [[style, *[f"{fps(cell[style, w]['seconds']):.1f} ({cell[style, w]['paper_fps']:.2f})" for w, _ in sizes]] for style in styles]

    def ratio(a, b):
        return " / ".join(f"{fps(cell[a, w]['seconds']) / fps(cell[b, w]['seconds']):.2f}" for w, _ in sizes)

    text = table(head, rows) + (f"\nV+S to V-S {ratio('V+S', 'V-S')} (the paper 0.87 / 0.77 / 0.63), V+S+G to V+S "
                                f"{ratio('V+S+G', 'V+S')}, V+DS to V-S {ratio('V+DS', 'V-S')} (the paper 0.67 / 0.67 / 0.59).\n")
    return text, min(fps(row["seconds"]) / row["paper_fps"] for row in report["rows"])


def table1(setting):
    """Table 1 of the paper, and the same where nothing can be left out."""
    report = output_of([f"{BENCH}/table1", "difference", setting.backend, str(setting.runs)])
    dense = output_of([f"{BENCH}/table1", "luminance", setting.backend, "1"])
    cells, least = table1_of(report)
    text = (f"## Table 1\n\nFrames a second of a left-bag volume of 384×288×1600 voxels, {100 * report['occupied']:.2f} % of them "
            f"not empty, {report['seeds']} seeds, drawn by {report['renderer']}; in brackets the paper's on a GeForce 7800 GTX. V: "
            "volume, S: in bricks (8), -S: in one, G: with arrows, DS: a new brick for each picture. One sample a pixel.\n\n"
            + cells + f"\nThe least of all cells is {least:.2f} times the paper's.\n\nThe dense case, the `luminance` filter, in which "
            f"{100 * dense['occupied']:.0f} % of the voxels are not empty:\n\n" + table1_of(dense)[0])
    return text, {"difference": report, "luminance": dense}


def vtk(setting):
    """The same volume drawn by VTK's two volume mappers."""
    subprocess.run([f"{BENCH}/box_volume", setting.scratch, setting.backend, str(max(setting.runs, 9))], check=True)
    scene = json.loads((setting.scratch / "scene.json").read_text())
    theirs = output_of(["xvfb-run", "-a", "/usr/bin/python3", "bench/vtk_volume.py", str(setting.scratch), str(setting.runs)])
    ours = scene["seconds"]
    names = {"vtk_gpu": "VTK, GPU mapper (on Mesa)", "vtk_cpu": "VTK, fixed-point CPU mapper"}
    rows = [["vvr", spread([1000 * s for s in ours], 0), "", ""]]
    for key, name in names.items():
        compared = subprocess.run([VVR, "compare", setting.scratch / "vvr.png", setting.scratch / f"{key}.png", "--json"],
                                  check=False, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
        rows.append([name, spread([1000 * s for s in theirs[key]], 0), f"{median(theirs[key]) / median(ours):.1f}",
                     f"{json.loads(compared.stdout)['psnr_db']:.1f}"])
    plots.side_by_side([("vvr", setting.scratch / "vvr.png")] + [(name, setting.scratch / f"{key}.png") for key, name in names.items()],
                       setting.reports / "report-vtk.png")
    text = (f"## Beside VTK {theirs['version']}\n\nThe same volume of 384×288×1600 voxels as a straight box, 800×600, one sample a voxel "
            f"along each ray ({scene['slices']} slices), the same camera and colours.\n\n"
            + table(["", "ms", "times as long as vvr", "PSNR to vvr's picture, dB"], rows)
            + "\n![vvr and VTK](report-vtk.png)\n")
    return text, {"vvr": ours} | theirs


def growth(setting):
    """How the time of a picture grows."""
    report = output_of([f"{BENCH}/growth", setting.backend, str(setting.runs)])
    plots.growth(report, setting.reports / "report-growth.svg")
    text = ("## Growth\n\nThe time of one picture over its pixels, the number of bricks, and the share of the volume that is "
            "occupied (the left part of each frame is lit; 192×144×800 voxels).\n\n![growth](report-growth.svg)\n")
    return text, report


def archive(setting):
    """A folder of clips against FFmpeg decoding one after another."""
    rows, numbers = [], {}
    for name in ("hd", "sd"):
        clips, out = f".cache/bench/archive/{name}", setting.scratch / "archive"
        drawn = f"rm -rf {out}; {VVR} archive {clips} -o {out} --backend {setting.backend} --settle 0s --quiet"
        results = in_turn({"ffmpeg": ["bash", "-ec", f'for clip in {clips}/*; do ffmpeg -nostdin -v error -i "$clip" -f null -; done'],
                           "pictures": ["bash", "-ec", f"{drawn} --no-pages"], "pages": ["bash", "-ec", drawn]}, min(setting.runs, 3))
        again = in_turn({"again": ["bash", "-ec", drawn.split("; ")[1]]}, min(setting.runs, 3))["again"]
        files = sorted(pathlib.Path(clips).iterdir())
        frames = sum(frames_of(str(file)) for file in files)
        seconds = {kind: median([r.seconds for r in of]) for kind, of in results.items()}
        cpu = {kind: median([r.processor for r in of]) for kind, of in results.items()}
        written = sum(file.stat().st_size for file in out.rglob("*") if file.is_file())
        rows.append([name, len(files), frames, *[f"{frames / seconds[kind]:.0f}" for kind in ("ffmpeg", "pictures", "pages")],
                     f"{seconds['ffmpeg'] / seconds['pictures']:.2f}", f"{seconds['ffmpeg'] / seconds['pages']:.2f}",
                     f"{cpu['ffmpeg'] / cpu['pictures']:.2f}", f"{cpu['ffmpeg'] / cpu['pages']:.2f}",
                     f"{1000 * median([r.seconds for r in again]):.0f}", f"{written / len(files) / 1e6:.1f}"])
        numbers[name] = {"clips": len(files), "frames": frames, "bytes": written, "again": [r.seconds for r in again]} | {
            kind: [[r.seconds, r.processor] for r in of] for kind, of in results.items()}
    text = ("## An archive\n\n`vvr archive CLIPS -o OUT`, all defaults, with pages and with `--no-pages`, beside `ffmpeg -i CLIP -f null -` "
            "for one clip after another, which decodes and throws away. Clips of a minute or so: hd 1920×1080 at 25 frames/s, H.264; sd 768×576 at "
            "10 frames/s, MPEG-4.\n\n")
    head = ["clips", "number", "frames", "FFmpeg, frames/s", "pictures, frames/s", "pages, frames/s", "pictures to FFmpeg",
            "pages to FFmpeg", "pictures, by CPU time", "pages, by CPU time", "nothing new, ms", "MB a clip"]
    return text + table(head, rows), numbers


PARTS = {
    "pipeline": pipeline,
    "archive": archive,
    "length": length,
    "threads": threads,
    "startup": startup,
    "context": context,
    "kernels": kernels,
    "peers": peers,
    "table1": table1,
    "vtk": vtk,
    "growth": growth,
}
