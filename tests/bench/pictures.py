"""What it takes to draw a volume, from its bricks to the picture."""

from measure import median, output_of, table
from setting import section


def fps(seconds):
    return 1 / median(seconds)


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
