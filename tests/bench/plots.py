"""The benchmark's plots: small SVGs in one look, the same bytes from the same numbers. Colours by Okabe and Ito, which people
who don't see all colours can tell apart; what vvr does is blue, what it is compared with grey."""

import statistics

import matplotlib

matplotlib.use("Agg")

from matplotlib import pyplot, ticker  # noqa: E402

BLUE, ORANGE, GREEN, GREY, PALE = "#0072b2", "#e69f00", "#009e73", "#8c8c8c", "#c4c4c4"

matplotlib.rcParams.update({
    "svg.fonttype": "none",  # text stays text
    "svg.hashsalt": "vvr",
    "font.family": "sans-serif",
    "font.sans-serif": ["DejaVu Sans"],
    "font.size": 9,
    "axes.titlesize": 9,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.grid": True,
    "axes.axisbelow": True,
    "grid.color": "#e4e4e4",
    "grid.linewidth": 0.7,
    "legend.frameon": False,
    "legend.fontsize": 8.5,
    "lines.linewidth": 1.6,
    "figure.constrained_layout.use": True,
})


def save(figure, path):
    figure.savefig(path, metadata={"Date": None})
    pyplot.close(figure)


def bars(axis, names, rows, unit, labels=None):
    """Horizontal bars from the top; rows are (value, colour), and each has its number at its end."""
    places = range(len(names))
    axis.barh(places, [value for value, _ in rows], height=0.62, color=[colour for _, colour in rows])
    axis.set_yticks(places, names)
    axis.invert_yaxis()
    axis.tick_params(axis="y", length=0)
    axis.grid(visible=False, axis="y")
    axis.set_xlabel(unit)
    most = max(value for value, _ in rows)
    axis.set_xlim(0, 1.3 * most)
    for place, (value, _) in zip(places, rows):
        axis.text(value + 0.02 * most, place, labels[place] if labels else f"{value:.3g}", va="center", fontsize=8.5)


def band(axis, xs, runs, colour=BLUE):
    """Medians as a line, and from the least to the greatest of the runs as a band."""
    axis.fill_between(xs, [min(of) for of in runs], [max(of) for of in runs], color=colour, alpha=0.2, linewidth=0)
    axis.plot(xs, [statistics.median(of) for of in runs], marker="o", markersize=4, color=colour)
    axis.set_ylim(0, 1.15 * max(max(of) for of in runs))


def logarithmic(axis, xs, labels=None):
    """An axis that tells its values in plain numbers, or in words."""
    axis.set_xscale("log")
    axis.set_xticks(xs, labels or [f"{x:.3g}" for x in xs])
    axis.xaxis.set_minor_locator(ticker.NullLocator())


def pipeline(rows, aims, path):
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(9.6, 0.62 * len(rows) + 1.5))
    places = list(range(len(rows)))
    for offset, kind, colour in ((-0.19, "render", BLUE), (0.19, "extract", PALE)):
        values = [row["share"][kind] for row in rows]
        left.barh([place + offset for place in places], values, height=0.36, color=colour, label=f"vvr {kind}")
        for place, value in zip(places, values):
            left.text(value + 0.012, place + offset, f"{value:.2f}", va="center", fontsize=8.5,
                      bbox={"facecolor": "white", "edgecolor": "none", "pad": 0.6})  # before the lines of the aims
    for aim in aims:
        left.axvline(aim, color="#444444", linewidth=1, linestyle=(0, (4, 3)), label="aims" if aim == aims[0] else None)
    left.set_xlim(0, max(1, 1.1 * max(row["share"]["render"] for row in rows)))
    left.set_xlabel("rate over that of FFmpeg, which only decodes and scales")
    begin = [0.0] * len(rows)
    for key, label, colour in (("decoding", "decoding and scaling", BLUE), ("vvr", "the rest of vvr", ORANGE),
                               ("neither", "idle, or others", "#e4e4e4")):
        values = [100 * row["cores"][key] for row in rows]
        right.barh(places, values, left=begin, height=0.62, color=colour, label=label)
        for place, value, start in zip(places, values, begin):
            if value >= 7:
                right.text(start + value / 2, place, f"{value:.0f}", va="center", ha="center", fontsize=8.5,
                           color="white" if colour == BLUE else "black")
        begin = [start + value for start, value in zip(begin, values)]
    right.set_xlim(0, 100)
    right.set_xlabel("% of what all cores can do during a run of vvr render")
    for axis in (left, right):
        axis.set_yticks(places, [row["clip"] for row in rows] if axis is left else [])
        axis.tick_params(axis="y", length=0)
        axis.invert_yaxis()
        axis.grid(visible=False, axis="y")
        axis.legend(loc="lower center", bbox_to_anchor=(0.5, 1.0), ncol=3, columnspacing=1.2, handlelength=1.2)
    save(figure, path)


def length(points, path):
    figure, axes = pyplot.subplots(1, 2, figsize=(8, 2.8))
    xs = [point["frames"] for point in points]
    for axis, key, label in zip(axes, ("milliseconds", "megabytes"), ("ms per frame", "MB")):
        band(axis, xs, [point[key] for point in points])
        logarithmic(axis, xs, [f"{point['name']}\n{point['frames']}" for point in points])
        axis.set_xlim(min(xs) / 1.6, max(xs) * 1.6)
        axis.set_xlabel("length of the clip, and its frames")
        axis.set_ylabel(label)
    save(figure, path)


def grid_of_curves(curves, rows, path):
    """Curves side by side, each with a row of axes for each of `rows` (key, label)."""
    figure, axes = pyplot.subplots(len(rows), len(curves), figsize=(2.6 * len(curves) + 0.4, 2.1 * len(rows) + 0.3), sharex="col",
                                   sharey="row", squeeze=False)
    for row, (key, label) in enumerate(rows):
        most = max(max(of) for curve in curves for of in curve[key])
        for column, curve in enumerate(curves):
            axis = axes[row][column]
            band(axis, curve["x"], curve[key])
            axis.set_ylim(0, 1.1 * most)
            if curve.get("log", False):
                logarithmic(axis, curve["x"])
            if row == len(rows) - 1:
                axis.set_xlabel(curve["label"])
        axes[row][0].set_ylabel(label)
    save(figure, path)


def options(curves, path):
    grid_of_curves([curve | {"log": True} for curve in curves], (("seconds", "seconds"), ("megabytes", "MB")), path)


def growth(report, labels, path):
    curves = [{"label": labels[name], "x": [point["x"] for point in points],
               "milliseconds": [[1e3 * s for s in point["seconds"]] for point in points],
               "megabytes": [[point["megabytes"]] for point in points], "log": name == "bricks"} for name, points in report.items()]
    grid_of_curves(curves, (("milliseconds", "ms a picture"), ("megabytes", "MB")), path)


def roofline(peak, bandwidths, points, path):
    """Roofs in GFLOP/s and GB/s; points are (flop a byte, GFLOP/s) by name."""
    figure, axis = pyplot.subplots(figsize=(7.6, 3.6))
    low, high = 1 / 16, 16
    axis.plot([peak / max(bandwidths.values()), high], [peak, peak], color="black", label=f"arithmetic, {peak:.0f} GFLOP/s")
    for (name, rate), style in zip(bandwidths.items(), ("-", "--", ":")):
        axis.plot([low, peak / rate], [low * rate, peak], color=GREY, linestyle=style, label=f"{name}, {rate:.0f} GB/s")
    for (name, (x, y)), (colour, mark) in zip(points.items(), ((BLUE, "o"), (ORANGE, "s"))):
        axis.plot([x], [y], color=colour, marker=mark, markersize=7, linestyle="none", label=f"{name}, {y:.3g} GFLOP/s")
    axis.set_xscale("log", base=2)
    axis.set_yscale("log")
    axis.set_xlim(low, high)
    axis.set_ylim(1, 2 * peak)
    axis.xaxis.set_major_formatter(ticker.FuncFormatter(lambda x, _: f"{x:g}" if x >= 1 else f"1/{1 / x:g}"))
    axis.yaxis.set_major_locator(ticker.LogLocator(subs=(1, 2, 5)))
    axis.yaxis.set_major_formatter(ticker.FuncFormatter(lambda y, _: f"{y:g}"))
    axis.yaxis.set_minor_locator(ticker.NullLocator())
    axis.set_xlabel("flop for each byte read or written")
    axis.set_ylabel("GFLOP/s of one core")
    axis.legend(loc="center left", bbox_to_anchor=(1.0, 0.5))
    save(figure, path)


def upload(bricks, ways, path):
    figure, axes = pyplot.subplots(1, len(bricks), figsize=(9.6, 2.5), sharey=True)
    for axis, brick in zip(axes, bricks):
        rates = {way: brick["bytes"] / statistics.median(brick["seconds"][way]) / 1e9 for way in ways}
        bars(axis, list(ways.values()), [(rate, GREY if way in ("memcpy", "bare") else BLUE) for way, rate in rates.items()], "GB/s")
        axis.set_title(f"{brick['format']}, {brick['bytes'] / 1e6:.0f} MB a brick")
    axes[0].set_ylim(len(ways) - 0.5, -0.5)
    save(figure, path)


def slicing(volumes, titles, ways, path):
    figure, axes = pyplot.subplots(1, len(volumes), figsize=(9.2, 2.3), sharey=True, squeeze=False)
    for axis, (name, volume) in zip(axes[0], volumes.items()):
        rates = {way: volume["by_adding"] / statistics.median(volume["seconds"][way]) / 1e6 for way in ways}
        labels = [f"{rate:.1f}" + (f" ({statistics.median(volume['shares'][way]):.2f})" if way != "blend" else "")
                  for way, rate in rates.items()]
        colours = {"blend": PALE, "fetch": GREY}
        bars(axis, list(ways.values()), [(rate, colours.get(way, BLUE)) for way, rate in rates.items()], "million samples/s", labels)
        axis.set_title(f"{name}: {titles[name]}")
    axes[0][0].set_ylim(len(ways) - 0.5, -0.5)
    save(figure, path)


def table1(rows, dense_rows, path):
    sizes = sorted({(row["width"], row["height"]) for row in rows})
    styles = list(dict.fromkeys(row["style"] for row in rows))
    figure, axes = pyplot.subplots(1, len(sizes), figsize=(9.8, 2.7), sharey=True)
    for axis, (width, height) in zip(axes, sizes):
        def rates(of, width=width):
            by_style = {row["style"]: row for row in of if row["width"] == width}
            return [1 / statistics.median(by_style[style]["seconds"]) for style in styles]

        paper = [next(row["paper_fps"] for row in rows if row["width"] == width and row["style"] == style) for style in styles]
        for offset, values, colour, label in ((-0.28, paper, GREY, "the paper, GeForce 7800 GTX"), (0, rates(rows), BLUE, "vvr"),
                                              (0.28, rates(dense_rows), ORANGE, "vvr, no voxel empty")):
            axis.bar([place + offset for place in range(len(styles))], values, width=0.26, color=colour, label=label)
        axis.set_xticks(range(len(styles)), styles)
        axis.tick_params(axis="x", length=0, labelsize=8)
        axis.grid(visible=False, axis="x")
        axis.set_title(f"{width}×{height} pixels")
    axes[0].set_ylabel("pictures per second")
    axes[-1].legend(loc="upper right")  # the largest pictures have the lowest bars
    save(figure, path)


def side_by_side(pictures, path):
    figure, axes = pyplot.subplots(1, len(pictures), figsize=(12, 3.3))
    for axis, (name, picture) in zip(axes, pictures):
        axis.imshow(pyplot.imread(picture))
        axis.set_title(name, fontsize=10)
        axis.set_axis_off()
    figure.savefig(path, dpi=100)
    pyplot.close(figure)
