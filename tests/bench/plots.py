"""The plots of docs/performance.md: small SVGs in one look, the same bytes from the same numbers. Colours by Okabe and Ito,
which people who don't see all colours can tell apart; what vvr does is blue, what it is compared with grey."""

import statistics

import matplotlib

matplotlib.use("Agg")

from matplotlib import pyplot, ticker  # noqa: E402

BLUE, ORANGE, GREY = "#0072b2", "#e69f00", "#8c8c8c"

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


def growth(report, labels, path):
    """Time and memory, each over what grows."""
    curves = [{"label": labels[name], "x": [point["x"] for point in points],
               "milliseconds": [[1e3 * s for s in point["seconds"]] for point in points],
               "megabytes": [[point["megabytes"]] for point in points], "log": name == "bricks"} for name, points in report.items()]
    rows = (("milliseconds", "ms a picture"), ("megabytes", "MB"))
    figure, axes = pyplot.subplots(len(rows), len(curves), figsize=(2.6 * len(curves) + 0.4, 2.1 * len(rows) + 0.3), sharex="col",
                                   sharey="row", squeeze=False)
    for row, (key, label) in enumerate(rows):
        most = max(max(of) for curve in curves for of in curve[key])
        for column, curve in enumerate(curves):
            axis = axes[row][column]
            band(axis, curve["x"], curve[key])
            axis.set_ylim(0, 1.1 * most)
            if curve["log"]:
                logarithmic(axis, curve["x"])
            if row == len(rows) - 1:
                axis.set_xlabel(curve["label"])
        axes[row][0].set_ylabel(label)
    save(figure, path)


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


def side_by_side(pictures, path):
    figure, axes = pyplot.subplots(1, len(pictures), figsize=(12, 3.3))
    for axis, (name, picture) in zip(axes, pictures):
        axis.imshow(pyplot.imread(picture))
        axis.set_title(name, fontsize=10)
        axis.set_axis_off()
    figure.savefig(path, dpi=100)
    pyplot.close(figure)
