"""A detector's model whose answer is known, in ONNX format: the one thing that it knows is everywhere in each picture."""

import math
import struct

SIDE = 64      # of its input
NUMBERS = 85   # of a row: a box, its probability, those of 80 classes
FLOATS, INTEGERS = 1, 7


def varint(value):
    out = bytearray()
    while value >= 0x80:
        out.append(value & 0x7F | 0x80)
        value >>= 7
    return bytes(out) + bytes([value])


def number(field, value):
    return varint(field << 3) + varint(value)


def text(field, value):
    data = value if isinstance(value, bytes) else value.encode()
    return varint(field << 3 | 2) + varint(len(data)) + data


def tensor(name, kind, shape, values):
    data = struct.pack(f"<{len(values)}{'f' if kind == FLOATS else 'q'}", *values)
    return b"".join(number(1, side) for side in shape) + number(2, kind) + text(8, name) + text(9, data)


def attribute(name, value):
    if isinstance(value, int):
        return text(1, name) + number(3, value) + number(20, 2)
    return text(1, name) + b"".join(number(8, part) for part in value) + number(20, 7)


def node(operation, inputs, output, **attributes):
    return (b"".join(text(1, name) for name in inputs) + text(2, output) + text(3, output) + text(4, operation) +
            b"".join(text(5, attribute(name, value)) for name, value in attributes.items()))


def shaped(name, shape):
    dimensions = b"".join(text(1, number(1, side)) for side in shape)
    return text(1, name) + text(2, text(1, number(1, FLOATS) + text(2, dimensions)))


def model(class_id=0, score=0.9, last_node=b""):
    """A model of YOLOX's format. Each box is as large as the picture; `score` is the probability of an object of the
    class."""
    row = [0.5, 0.5, math.log(8), math.log(8), score] + [0.0] * 80
    row[5 + class_id] = 1.0
    graph, grids, cells = text(5, tensor("row", FLOATS, [NUMBERS], row)), [], 0
    for stride in (8, 16, 32):
        columns, name = SIDE // stride, f"grid{stride}"
        cells += columns**2
        grids.append(name)
        graph += text(5, tensor(f"{name}.weights", FLOATS, [NUMBERS, 3, 1, 1], [0.0] * NUMBERS * 3))
        graph += text(5, tensor(f"{name}.shape", INTEGERS, [3], [1, NUMBERS, columns**2]))
        graph += text(1, node("Conv", ["image", f"{name}.weights", "row"], f"{name}.map", kernel_shape=[1, 1], strides=[stride, stride]))
        graph += text(1, node("Reshape", [f"{name}.map", f"{name}.shape"], name))
    graph += text(1, node("Concat", grids, "all", axis=2)) + text(1, node("Transpose", ["all"], "output", perm=[0, 2, 1]))
    graph += text(1, last_node) if last_node else b""
    graph += text(2, "tiny") + text(11, shaped("image", [1, 3, SIDE, SIDE])) + text(12, shaped("output", [1, cells, NUMBERS]))
    return number(1, 6) + text(7, graph) + text(8, text(1, "") + number(2, 11))
