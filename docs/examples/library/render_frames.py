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


class Rendering(ctypes.Structure):  # the first members of struct vvr_rendering
    _fields_ = [("status", ctypes.c_int), ("code", ctypes.c_char_p), ("text", ctypes.c_char_p), ("width", ctypes.c_int),
                ("height", ctypes.c_int), ("rgba", ctypes.c_void_p), ("settings", ctypes.c_void_p),
                ("setting_count", ctypes.c_size_t), ("frames", ctypes.c_int64)]


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
for function in (vvr.vvr_render_frames, vvr.vvr_write_image):
    function.restype = ctypes.POINTER(Rendering)

GRAY = 0
rendering = vvr.vvr_render_frames(ctypes.byref(Frames(WIDTH, HEIGHT, GRAY, RATE, FRAMES, READ(read), None)), None)
written = rendering if rendering.contents.status else vvr.vvr_write_image(sys.argv[2].encode(), rendering)
status = written.contents.status
if status:
    print(written.contents.text.decode(), file=sys.stderr)
else:
    print(f"{rendering.contents.frames} frames in {sys.argv[2]}")
sys.exit(status)
