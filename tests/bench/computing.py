"""The kernels of the fields: against plain loops and against others' libraries."""

import pathlib

from measure import in_turn, median, output_of, spread, table
from setting import section

POINTS = 384 * 288 * 60 / 1e3  # pixels times steps, per millisecond: thousands a second


def benchmarks(setting, names, *options):
    """Rows of Google Benchmark by name, each a list of repetitions."""
    report = output_of([setting.program("bench_fields"), "--benchmark_format=json", f"--benchmark_filter={names}", *options])
    rows = {}
    for row in report["benchmarks"]:
        if row["run_type"] == "iteration":
            rows.setdefault(row["name"].split("/iterations")[0].split("/real_time")[0], []).append(row)
    return rows


def kernels(setting):
    """The fields' kernels against plain loops, and rates of all fields."""
    compared = benchmarks(setting, "Against")
    single = benchmarks(setting, "flow_of|filter_of|seeds_of", f"--benchmark_repetitions={setting.runs}", "--benchmark_min_time=0.1")
    jacobi = compared["JacobiAgainstPlainLoop"][0]
    rate, best = POINTS / jacobi["jacobi_ms"], POINTS / jacobi["best_jacobi_ms"]
    text = (f"Horn–Schunck, 60 Jacobi steps at 384×288, one core: {jacobi['jacobi_ms']:.2f} ms = {rate:.0f} million pixel-steps "
            f"a second, the best of 30 runs {best:.0f}; a plain loop compiled with -O2 takes {jacobi['plain_ms']:.1f} ms, "
            f"{jacobi['ratio']:.1f} times as long.\n\n")

    def rows_of(prefix, frames):
        return [[name.split("/")[1], spread([row["cpu_time"] / frames for row in rows])]
                for name, rows in single.items() if name.startswith(prefix)]

    text += table(["flow of a frame, 384×288, one core", "ms"], rows_of("flow_of_a_frame", 1)) + "\n"
    text += table(["filter of a frame in colour, 384×288, one core", "ms"], rows_of("filter_of_frames", 20))
    text += f"\nSeeds of a frame in which all moves: {spread([row['cpu_time'] for row in single['seeds_of_a_frame']], 0)} µs.\n"
    rates = output_of([setting.program("fields_rate"), setting.clip])
    text += f"\nFields of `{pathlib.Path(setting.clip).name}` on two threads:\n\n" + table(
        ["", "frames/s"], [[name, spread(values, 0)] for name, values in rates.items()])
    return (section("Kernels", "How fast the computing of the fields is on one core, beside plain loops.",
                    text), {"benchmarks": compared | single, "rates": rates})


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
             "of "
             "the same clip:\n\n" + table(["", "s", "ratio"], [[name, spread([r.seconds for r in of]),
                                                               f"{median([r.seconds for r in of]) / theirs:.2f}"] for name, of in motion.items()]))
    measured = ("The flow of a frame of 384×288 on one core (median time, and the mean angle between (u, v, 1) and the truth: "
                "less is better), on generated scenes with the noise of a camera.")
    return section("Beside OpenCV", measured, text), {
        "flow": report, "motion": {name: [r.seconds for r in of] for name, of in motion.items()}}
