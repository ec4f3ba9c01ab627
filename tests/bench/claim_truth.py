"""Whether what `vvr` claims of a thing ("left", "taken") is true."""


def box_of(event):
    return [event["box"][key] for key in ("x", "y", "width", "height")]


def overlap(a, b):
    """The share of the smaller box that is also in the other."""
    width = min(a[0] + a[2], b[0] + b[2]) - max(a[0], b[0])
    height = min(a[1] + a[3], b[1] + b[3]) - max(a[1], b[1])
    return max(width, 0) * max(height, 0) / max(min(a[2] * a[3], b[2] * b[3]), 1)


def same_place(event, box):
    """Whether both share a third of the smaller box."""
    return overlap(box_of(event), box) >= 1 / 3


def is_true(event, box, begin, length):
    """Whether the event has the thing's place, and begins within 4 s or a tenth of the clip of it. In seconds."""
    return same_place(event, box) and abs(event["first"]["seconds"] - begin) <= max(4, length / 10)
