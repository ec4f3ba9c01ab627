"""Draws frames that Python makes, through the C header: render_frames.py LIBRARY PICTURE"""

import ctypes
import sys

WIDTH, HEIGHT, FRAMES, RATE = 160, 120, 75, 25


class Frame(ctypes.Structure):  # struct vvr_frame
    _fields_ = [("pixels", ctypes.c_char_p), ("stride", ctypes.c_ssize_t), ("seconds", ctypes.c_double)]


READ = ctypes.CFUNCTYPE(ctypes.c_int, ctypes.c_void_p, ctypes.c_int64, ctypes.POINTER(Frame))


class Frames(ctypes.Structure):  # struct vvr_frames
    _fields_ = [("width", ctypes.c_int), ("height", ctypes.c_int), ("format", ctypes.c_int),
                ("frames_per_second", ctypes.c_double), ("frames", ctypes.c_int64), ("read", READ),
                ("user", ctypes.c_void_p)]


def picture(index):
    """A grey room, through which a white box moves to the right. With numpy: array.tobytes()."""
    left = index * (WIDTH - 20) // FRAMES
    plain = bytes([90]) * WIDTH
    box = plain[:left] + bytes([240]) * 20 + plain[left + 20:]
    return plain * 50 + box * 30 + plain * 40


def read(_user, index, frame):
    if index >= FRAMES:
        return 0
    read.kept = picture(index)  # must stay until the next call
    frame.contents.pixels = read.kept
    frame.contents.stride = WIDTH
    frame.contents.seconds = index / RATE
    return 1


vvr = ctypes.CDLL(sys.argv[1])  # such as libvvr.so.0.1
vvr.vvr_render_frames.restype = ctypes.c_void_p
for name in ("vvr_error_text", "vvr_version"):
    getattr(vvr, name).restype = ctypes.c_char_p
vvr.vvr_frame_count.restype = ctypes.c_int64

GRAY = 0
rendering = ctypes.c_void_p(vvr.vvr_render_frames(ctypes.byref(Frames(WIDTH, HEIGHT, GRAY, RATE, FRAMES, READ(read), None)), None))
status = vvr.vvr_status_of(rendering) or vvr.vvr_write_image(rendering, sys.argv[2].encode())
if status:
    print(vvr.vvr_error_text(rendering).decode(), file=sys.stderr)
else:
    print(f"{vvr.vvr_frame_count(rendering)} frames in {sys.argv[2]}")
vvr.vvr_free(rendering)
sys.exit(status)
