"""What it takes to draw a volume, from its bricks to the picture."""

import json
import subprocess

import plots
from measure import median, output_of, ratios, spread, table
from setting import figure, section


def fps(seconds):
    return 1 / median(seconds)


WAYS_TO_UPLOAD = {
    "memcpy": "memcpy of the same bytes",
    "bare": "bare glTexSubImage3D",
    "textures": "vvr's upload: texels laid out, slab by slab",
    "renderer": "vvr's renderer: that, and finding empty cells",
    "layout": "all texels laid out at once, not uploaded",
}


def upload(setting):
    """A brick's way into its 3D texture."""
    report = output_of([setting.program("upload"), setting.backend, str(max(setting.runs, 9)), str(setting.scale)])
    text = ""
    head = ["", "ms", "MB/s", "million texels/s", "of memcpy's rate"]
    for brick in report["bricks"]:
        took = {way: median(seconds) for way, seconds in brick["seconds"].items()}
        rows = [[name, spread([1e3 * s for s in brick["seconds"][way]]), f"{brick['bytes'] / took[way] / 1e6:.0f}",
                 f"{brick['texels'] / took[way] / 1e6:.0f}", spread(ratios(brick["seconds"]["memcpy"], brick["seconds"][way]))]
                for way, name in WAYS_TO_UPLOAD.items()]
        text += (f"A brick of {'×'.join(map(str, brick['size']))} texels, {brick['format']}, {brick['bytes'] / 1e6:.0f} MB:\n\n"
                 + table(head, rows) + "\n")
    measured = (f"A brick of the volume gets into its 3D texture on {report['renderer']}, beside a memcpy of the same bytes and a bare "
                "OpenGL call, in turn; each waits until OpenGL is done.")
    return section("Brick upload", measured, text), report


WAYS_TO_SLICE = {
    "blend": "bare: blend, no fetch",
    "fetch": "bare: fetch and blend",
    "shader": "vvr's shader, polygons ready",
    "slicer": "vvr's slicer, polygons cut anew",
}
VOLUMES = {"difference": "as one sees it", "luminance": "nothing empty"}


def agreement(volume):
    """Whether all ways drew as many samples, in words."""
    counts = set(volume["samples"].values()) | {volume["by_adding"]}
    million = volume["by_adding"] / 1e6
    if len(counts) == 1:
        return f"{million:.2f} million samples, the same for all, by an occlusion query and by adding up ones"
    return f"between {min(counts) / 1e6:.3f} and {max(counts) / 1e6:.3f} million samples: **the counts differ**"


def slicing(setting):
    """The volume slicer against a bare shader on the same polygons."""
    report = output_of([setting.program("slicing"), setting.backend, str(setting.runs), str(setting.scale)])
    volumes = {volume["filter"]: volume for volume in report["volumes"]}
    for volume in volumes.values():
        volume["shares"] = {way: ratios(volume["seconds"]["fetch"], volume["seconds"][way]) for way in WAYS_TO_SLICE}
    text = ""
    for name, volume in volumes.items():
        samples = volume["by_adding"]
        took = {way: median(seconds) for way, seconds in volume["seconds"].items()}
        text += (f"The left-bag volume through the `{name}` filter, {100 * volume['occupied']:.1f} % of the voxels not empty: "
                 f"{agreement(volume)}, in {volume['triangles']} triangles, {samples / volume['triangles']:.0f} samples each. To "
                 f"cut them takes one core {1e3 * took['cutting']:.1f} ms.\n\n")
        text += table(["", "ms", "million samples/s", "of the bare rate"],
                      [[label, spread([1e3 * s for s in volume["seconds"][way]], 1), f"{samples / took[way] / 1e6:.1f}",
                        spread(volume["shares"][way])] for way, label in WAYS_TO_SLICE.items()]) + "\n"
    measured = (f"Samples a second that vvr's volume slicer draws, into {report['width']}×{report['height']} pixels on "
                f"{report['renderer']}, against a bare shader that fetches a voxel and blends it and does nothing else: no "
                "inverse of the map, no transfer function, no length of the ray. Same polygons, same textures, same framebuffer, "
                "in turn.")
    return section("Slicing", measured, text), report


def table1_of(report):
    sizes = sorted({(row["width"], row["height"]) for row in report["rows"]})
    styles = list(dict.fromkeys(row["style"] for row in report["rows"]))
    cell = {(row["style"], row["width"]): row for row in report["rows"]}
    head = ["style", *[f"{width}×{height}" for width, height in sizes]]
    def cell_text(row):
        rates = sorted(1 / seconds for seconds in row["seconds"])
        low, high = rates[len(rates) // 4], rates[-1 - len(rates) // 4]
        return f"{fps(row['seconds']):.1f}, {low:.1f} to {high:.1f} ({row['paper_fps']:.2f})"

    rows = [[style, *[cell_text(cell[style, w]) for w, _ in sizes]] for style in styles]

    def ratio(a, b):
        """Of the rates that the table prints."""
        return [f"{round(fps(cell[a, w]['seconds']), 1) / round(fps(cell[b, w]['seconds']), 1):.2f}" for w, _ in sizes]

    ratio_rows = [["V+S over V-S", *ratio("V+S", "V-S"), "0.87, 0.77, 0.63"], ["V+DS over V-S", *ratio("V+DS", "V-S"), "0.67, 0.67, 0.59"],
                  ["V+S+G over V+S", *ratio("V+S+G", "V+S"), "1.00, 1.00, 1.00"]]
    text = (table(head, rows) + "\nThe median of the runs, the range in which the middle half of them lies, and in brackets the "
            "paper's. As ratios of the table's rates:\n\n" + table(["rate", *head[1:], "the paper"], ratio_rows))
    return text


def table1(setting):
    """Table 1 of the paper, and the same where nothing can be left out."""
    program = setting.program("table1")
    report = output_of([program, "difference", setting.backend, str(setting.runs), str(setting.scale)])
    dense = output_of([program, "luminance", setting.backend, str(setting.runs), str(setting.scale)])
    measured = (f"Pictures a second of a left-bag volume of 384×288×1600 voxels, {100 * report['occupied']:.2f} % of them not "
                f"empty, {report['seeds']} seeds, drawn by {report['renderer']}; in brackets the paper's on a GeForce 7800 GTX. "
                "V: volume, S: in bricks (8), -S: in one, G: with arrows, DS: a new brick for each picture. One sample a pixel.")
    body = (table1_of(report) + f"\nThe same through the `luminance` filter, {100 * dense['occupied']:.0f} % not empty:\n\n" + table1_of(dense))
    return section("Table 1 of the paper", measured, body), {"difference": report, "luminance": dense}


def vtk(setting):
    """The same volume drawn by VTK's two volume mappers."""
    subprocess.run([setting.program("box_volume"), setting.scratch, setting.backend, str(max(setting.runs, 9))], check=True)
    scene = json.loads((setting.scratch / "scene.json").read_text())
    theirs = output_of(["xvfb-run", "-a", "/usr/bin/python3", "tests/bench/vtk_volume.py", str(setting.scratch), str(setting.runs)])
    ours = scene["seconds"]
    names = {"vtk_gpu": "VTK, GPU mapper (on Mesa)", "vtk_cpu": "VTK, fixed-point CPU mapper"}
    rows = [["vvr", spread([1000 * s for s in ours], 0), "", ""]]
    for key, name in names.items():
        compared = subprocess.run([setting.vvr, "compare", setting.scratch / "vvr.png", setting.scratch / f"{key}.png", "--json"],
                                  check=False, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
        rows.append([name, spread([1000 * s for s in theirs[key]], 0), f"{median(theirs[key]) / median(ours):.1f}",
                     f"{json.loads(compared.stdout)['psnr_db']:.1f}"])
    plots.side_by_side([("vvr", setting.scratch / "vvr.png")] + [(name, setting.scratch / f"{key}.png") for key, name in names.items()],
                       setting.reports / "report-vtk.png")
    measured = ("Milliseconds of a picture of the same volume of 384×288×1600 voxels as a straight box, 800×600, one sample a "
                f"voxel along each ray ({scene['slices']} slices), the same camera and colours, by vvr and by VTK "
                f"{theirs['version']}.")
    body = (table(["", "ms", "times as long as vvr", "PSNR to vvr's picture, dB"], rows)
            + "\n![The same volume by vvr and VTK](report-vtk.png)\n")
    return section("Beside VTK", measured, body), {"vvr": ours} | theirs


CURVES = {
    "pixels": "million pixels\nof the picture",
    "bricks": "bricks in the window (k)",
    "voxels": "thousand pixels of a field",
    "occupied": "share of the volume\nthat is occupied",
}


def growth(setting):
    """How the time and the memory of a picture grow."""
    report = output_of([setting.program("growth"), setting.backend, str(setting.runs), str(setting.scale)])
    curves = {name: report[name] for name in CURVES}
    plots.growth(curves, CURVES, setting.plot("growth"))
    rows = []
    for name, label in CURVES.items():
        rows += [[label.replace("\n", " ") if point is curves[name][0] else "", f"{point['x']:.4g}", spread([1e3 * s for s in point["seconds"]], 1),
                  f"{point['megabytes']:.0f}"] for point in curves[name]]
    measured = ("Time to draw one picture, and the most memory that the renderer holds for it beside the volume, as one thing "
                "grows and all others stay: the left-bag volume of 384×288×1600 voxels, and for the last two curves volumes of "
                "which the left part of each frame is lit (400 frames of which 10 % are lit; 192×144×800 voxels).")
    body = (figure("growth", "One picture over its size, the bricks that the volume is cut into, the size of a frame of the "
                             "volume, and the share of it that isn't empty. Above time, with a band from the least to the "
                             "greatest; below memory.")
            + table(["over", "", "ms", "MB"], rows))
    return section("Growth", measured, body), report
