"""The benchmark's plots."""

import matplotlib

matplotlib.use("Agg")

from matplotlib import pyplot  # noqa: E402

CURVES = {
    "pixels": "million pixels",
    "bricks": "bricks in the window",
    "occupied": "share of the volume that is occupied",
}


def growth(report, path):
    figure, axes = pyplot.subplots(1, len(CURVES), figsize=(11, 3.2), constrained_layout=True)
    for axis, (name, label) in zip(axes, CURVES.items()):
        xs = [point["x"] for point in report[name]]
        times = [sorted(1000 * s for s in point["seconds"]) for point in report[name]]
        middles = [of[len(of) // 2] for of in times]
        axis.fill_between(xs, [of[0] for of in times], [of[-1] for of in times], color="#c6d7ee", linewidth=0)
        axis.plot(xs, middles, marker="o", markersize=4, color="#1f4e9c")
        axis.set_xlabel(label)
        axis.set_ylim(0, 1.15 * max(of[-1] for of in times))
        axis.set_xlim(left=0)
        axis.grid(color="#e4e4e4")
        axis.spines[["top", "right"]].set_visible(False)
    axes[0].set_ylabel("ms a picture")
    figure.savefig(path, metadata={"Date": None})
    pyplot.close(figure)


def side_by_side(pictures, path):
    figure, axes = pyplot.subplots(1, len(pictures), figsize=(12, 3.3), constrained_layout=True)
    for axis, (name, picture) in zip(axes, pictures):
        axis.imshow(pyplot.imread(picture))
        axis.set_title(name, fontsize=10)
        axis.set_axis_off()
    figure.savefig(path, dpi=100)
    pyplot.close(figure)
