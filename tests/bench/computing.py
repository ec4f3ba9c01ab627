"""Flow and motion beside other libraries."""

import pathlib

from measure import in_turn, median, output_of, spread, table
from setting import section


def peers(setting):
    """Flow methods beside OpenCV's, and the loop that people script to find motion."""
    report = output_of([setting.program("peers"), "flow"])
    scenes = list(dict.fromkeys(row["scene"] for row in report))
    cell = {(row["method"], row["scene"]): row for row in report}
    rows = [[method, *[f"{1000 * median(cell[method, s]['seconds']):.1f} ms, {cell[method, s]['degrees']:.1f}°" for s in scenes]]
            for method in dict.fromkeys(row["method"] for row in report)]
    text = table(["method", *scenes], rows)
    width, height = 768, 576
    piped = ["bash", "-c", f"ffmpeg -v error -i {setting.clip} -vf scale={width}:{height} -f rawvideo -pix_fmt bgr24 - | "
             f"{setting.program('peers')} motion {width} {height}"]
    motion = in_turn({"FFmpeg, OpenCV's MOG2, opening, blobs": piped, "vvr render, all defaults": setting.render(setting.clip)},
                     setting.runs)
    theirs = median([r.seconds for r in next(iter(motion.values()))])
    text += (f"\nA scan for motion as people script it, over `{pathlib.Path(setting.clip).name}` at its own size, and a picture "
             "of the same clip:\n\n" + table(["", "s", "ratio"], [[name, spread([r.seconds for r in of]),
                                                               f"{median([r.seconds for r in of]) / theirs:.2f}"] for name, of in motion.items()]))
    measured = ("The flow of a frame of 384×288 on one core (median time, and the mean angle between (u, v, 1) and the truth: "
                "less is better), on generated scenes with the noise of a camera.")
    return section("Beside OpenCV", measured, text), {
        "flow": report, "motion": {name: [r.seconds for r in of] for name, of in motion.items()}}
