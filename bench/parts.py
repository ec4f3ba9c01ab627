"""The parts of the benchmark: each measures, and gives its section of the report and its numbers."""

import json
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


def render(setting, clip, *options):
    return [VVR, "render", clip, "-o", str(setting.scratch / "out.png"), "--backend", setting.backend, "--quiet", *options]


def frames_of(clip):
    counted = subprocess.run(["ffprobe", "-v", "error", "-count_packets", "-select_streams", "v", "-show_entries",
                              "stream=nb_read_packets", "-of", "csv=p=0", clip], check=True, stdout=subprocess.PIPE)
    return int(counted.stdout.decode().strip().rstrip(","))


def pipeline(setting):
    """Whole runs against FFmpeg decoding and scaling the same clip on as many threads."""
    rows, numbers = [], {}
    for clip in (setting.clip, ".cache/bench/left_bag.mp4", ".cache/bench/hd.mp4"):
        data = setting.scratch / "data"
        shutil.rmtree(data, ignore_errors=True)
        floor = ["ffmpeg", "-v", "error", "-i", clip, "-vf", "scale=384:288,format=gray", "-f", "null", "-"]
        results = in_turn({"ffmpeg": floor, "render": render(setting, clip)}, setting.runs)
        frames = frames_of(clip)
        rate = {name: frames / median([r.seconds for r in of]) for name, of in results.items()}
        share = rate["render"] / rate["ffmpeg"]
        rows.append([f"`{pathlib.Path(clip).name}`", frames, f"{rate['ffmpeg']:.0f}", f"{rate['render']:.0f}", f"{share:.2f}",
                     spread([r.seconds for r in results["render"]]), f"{median([r.megabytes for r in results['render']]):.0f}"])
        numbers[clip] = {"frames": frames, "share": share} | {
            name: [[r.seconds, r.megabytes] for r in of] for name, of in results.items()}
    text = ("## A whole run against decoding alone\n\n`vvr render CLIP -o out.png`, all defaults, beside "
            "`ffmpeg -i CLIP -vf scale=384:288,format=gray -f null -`, which decodes and scales and does nothing else: no "
            "program can be faster.\n\n")
    head = ["clip", "frames", "FFmpeg, frames/s", "vvr, frames/s", "share", "vvr, s", "MB"]
    return text + table(head, rows), numbers


def memory(setting):
    """Memory over the clip's length."""
    results = in_turn({"once": render(setting, setting.clip), "ten times": render(setting, ".cache/bench/ten_times.avi")}, 1)
    once, ten = results["once"][0], results["ten times"][0]
    text = ("## Memory\n\nThe footage once, and ten times over in one clip.\n\n"
            + table(["clip", "MB", "s"], [["once", f"{once.megabytes:.0f}", f"{once.seconds:.2f}"],
                                          ["ten times", f"{ten.megabytes:.0f}", f"{ten.seconds:.2f}"],
                                          ["ratio", f"{ten.megabytes / once.megabytes:.3f}", f"{ten.seconds / once.seconds:.2f}"]]))
    return text, {"once": [once.seconds, once.megabytes], "ten": [ten.seconds, ten.megabytes]}


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


def kernels(setting):
    """The fields' kernels against plain loops, and rates of all fields."""
    report = output_of([f"{BENCH}/bench_fields", "--benchmark_format=json", "--benchmark_min_time=0.2"])
    by_name = {row["name"].split("/iterations")[0].split("/real_time")[0]: row for row in report["benchmarks"]}
    jacobi, grid = by_name["JacobiAgainstPlainLoop"], by_name["MultigridAgainstJacobi"]
    pixel_steps = 384 * 288 * 60 / jacobi["jacobi_ms"] / 1e3
    text = (f"## Kernels\n\nHorn–Schunck, 60 Jacobi steps at 384×288, one core: {jacobi['jacobi_ms']:.2f} ms = {pixel_steps:.0f} "
            f"million pixel-steps a second; a plain loop compiled with -O2 takes {jacobi['plain_ms']:.1f} ms, "
            f"{jacobi['ratio']:.1f} times as long. The multigrid solver takes {grid['multigrid_ms']:.2f} ms and leaves "
            f"{grid['multigrid_residual']:.1e} of the residual, where 60 steps leave {grid['jacobi_residual']:.1e}.\n\n")
    rows = [[name.split("/")[1], f"{row['real_time']:.2f}"] for name, row in by_name.items() if name.startswith("flow_of_a_frame")]
    text += table(["flow of a frame, 384×288", "ms"], rows)
    rates = output_of([f"{BENCH}/fields_rate", setting.clip])
    text += f"\nFields of `{pathlib.Path(setting.clip).name}` on two threads:\n\n" + table(
        ["", "frames/s"], [[name, spread(values, 0)] for name, values in rates.items()])
    return text, {"benchmarks": report["benchmarks"], "rates": rates}


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
        cpu = {kind: median([r.cpu for r in of]) for kind, of in results.items()}
        written = sum(file.stat().st_size for file in out.rglob("*") if file.is_file())
        rows.append([name, len(files), frames, *[f"{frames / seconds[kind]:.0f}" for kind in ("ffmpeg", "pictures", "pages")],
                     f"{seconds['ffmpeg'] / seconds['pictures']:.2f}", f"{seconds['ffmpeg'] / seconds['pages']:.2f}",
                     f"{cpu['ffmpeg'] / cpu['pictures']:.2f}", f"{cpu['ffmpeg'] / cpu['pages']:.2f}",
                     f"{1000 * median([r.seconds for r in again]):.0f}", f"{written / len(files) / 1e6:.1f}"])
        numbers[name] = {"clips": len(files), "frames": frames, "bytes": written, "again": [r.seconds for r in again]} | {
            kind: [[r.seconds, r.cpu] for r in of] for kind, of in results.items()}
    text = ("## An archive\n\n`vvr archive CLIPS -o OUT`, all defaults, with pages and with `--no-pages`, beside `ffmpeg -i CLIP -f null -` "
            "for one clip after another, which decodes and throws away. Clips of a minute or so: hd 1920×1080 at 25 frames/s, H.264; sd 768×576 at "
            "10 frames/s, MPEG-4.\n\n")
    head = ["clips", "number", "frames", "FFmpeg, frames/s", "pictures, frames/s", "pages, frames/s", "pictures to FFmpeg",
            "pages to FFmpeg", "pictures, by CPU time", "pages, by CPU time", "nothing new, ms", "MB a clip"]
    return text + table(head, rows), numbers


PARTS = {
    "pipeline": pipeline,
    "memory": memory,
    "archive": archive,
    "startup": startup,
    "context": context,
    "kernels": kernels,
    "table1": table1,
    "vtk": vtk,
    "growth": growth,
}
