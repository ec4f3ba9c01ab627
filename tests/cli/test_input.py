"""Inputs that are missing, damaged or odd."""

import pytest
from harness import check


def test_missing_file(t):
    t.render("none.avi").expect(2, "'none.avi'", "No such file or directory", code="file-not-found")
    t.expect_files()


def test_inputs_without_frames(t):
    t.path("empty").mkdir()
    t.write("empty.avi", "")
    t.write("notes.avi", "this is no video\n" * 100)
    t.copy("notes.avi", "notes.mp4")
    t.ffmpeg("-f", "lavfi", "-i", "sine=duration=1", "sound.m4a")
    files = t.files()
    for name, code, *facts in (("empty", "not-video", "png"), ("notes.avi", "not-video", "text file", "give a video"), ("notes.mp4", "not-video", "text file"),
                               ("empty.avi", "file-empty", "0 bytes"), ("-", "file-empty", "0 bytes"),
                               ("sound.m4a", "no-video-stream", "audio", "aac")):
        t.render(name).expect(3, f"'{name}'", *facts, code=code)
    t.expect_files(*files)


def test_an_mp4_without_its_index_is_incomplete(t):
    """As a recorder leaves it while it writes, or after a power cut."""
    t.clip("whole.mp4", codec=("-c:v", "mpeg4"))
    t.write("part.mp4", t.path("whole.mp4").read_bytes()[:-2000])
    t.render("part.mp4").expect(3, "'part.mp4' is incomplete", "moov atom", "wait until its recorder has finished it, or copy it again", code="not-video")


def test_cut_video(t):
    t.clip("whole.avi", seconds=4)
    data = t.path("whole.avi").read_bytes()
    t.write("cut.avi", data[: len(data) * 3 // 5])
    result = t.render("cut.avi").expect(0, "warning: 'cut.avi': 1 damaged packet; the picture shows the ", " frames that could be decoded")
    frames = int(result.err.split("the picture shows the ")[1].split()[0])
    check(5 < frames < 35, f"{frames} frames of 40 in three fifths of the file")
    t.expect_picture()


def test_one_pixel_video(t):
    t.ffmpeg("-f", "lavfi", "-i", "testsrc2=size=2x2:rate=10:duration=1,scale=1:1", "-c:v", "ffv1", "dot.mkv")
    t.render("dot.mkv").expect(0)
    t.expect_picture()


def test_one_frame(t):
    t.clip("one.avi", seconds=0.1)
    said = t.render("one.avi").expect(0, "has only one frame, so nothing can move", "1 frame in 1 layer and 1 brick")
    check("threshold" not in said.err, str(said))
    t.expect_picture()


def test_pictures_in_a_folder(t):
    t.clip("frames/%03d.png", seconds=1, codec=())
    t.render("frames").expect(0, "10 frames")
    t.render("frames/%03d.png", output="pattern.png").expect(0, "10 frames")
    check(t.path("out.png").stat().st_size == t.path("pattern.png").stat().st_size, "folder and pattern differ")


def test_piped_stream(t):
    t.clip("clip.mkv")
    with open(t.path("clip.mkv"), "rb") as stream:
        t.render("-", stdin=stream).expect(0, "20 frames")
    t.expect_picture()


def test_start_beyond_the_end(t):
    t.clip()
    t.render("clip.avi", "--start", "20f").expect(1, "frame 20", "20 frames", "1.900 s", "--start", code="span-empty")
    t.render("clip.avi", "--start", "5s").expect(1, "'clip.avi'", "5 s", "20 frames", "1.900 s", "--start", code="span-empty")
    t.render("clip.avi", "--start", "9f", "--end", "3f").expect(1, "--end", code="span-empty")
    t.expect_files("clip.avi")


def test_info_says_what_a_render_would_do(t):
    t.clip()
    text = t.vvr("info", "clip.avi").expect(0, out=None, err="")
    for part in ("avi, mpeg4", "64x48", "10 frames per second", "20, from the container", "2.000 s", "20 layers", "MB",
                 "time     about ", " s on this machine, judging by the first 20 frames"):
        check(part in text.out, f"{text}\nexpected: {part}")
    # Colours of objects, the default where the filter marks any, take four bytes a voxel.
    memory = [t.vvr("info", "clip.avi", "--json", *colour).expect(0, out=None).json()["render"]["memory_bytes"]
              for colour in ((), ("--color", "object"), ("--color", "transfer"))]
    check(memory[0] == memory[1] > memory[2], f"{memory}")
    told = t.vvr("info", "clip.avi", "--json", "--end", "11f", "--step", "2").expect(0, out=None).json()
    check((told["width"], told["height"], told["frames"], told["rate"]) == (64, 48, 20, 10), str(told))
    check((told["render"]["frames"], told["render"]["layers"], told["render"]["step"]) == (11, 6, 2), str(told))
    check(told["render"]["seconds"] > 0 and told["render"]["frames_per_second"] > 0, str(told))


@pytest.mark.nightly
def test_info_measures_a_render(t):
    t.clip(seconds=40)
    text = t.vvr("info", "clip.avi").expect(0, out=None).out
    check("judging by the first 50 frames" in text, text)
    check("judging by" not in t.vvr("info", "clip.avi", "--quick").expect(0, out=None).out, "--quick measures")
    large = t.vvr("info", "clip.avi", "--json", "--size", "8000x5000").expect(0, out=None).json()["render"]
    small = t.vvr("info", "clip.avi", "--json", "--size", "160x100").expect(0, out=None).json()["render"]
    check(large["seconds"] > 3 * small["seconds"], f"{large} {small}")
    told = t.vvr("info", "clip.avi", "--json", "--backend", "egl:99").expect(0, out=None).json()
    check(told["render"]["seconds"] is None and "there is no EGL device 99" in told["warnings"][-1], str(told))


@pytest.mark.nightly
def test_playlist_on_disk_is_refused(t):
    """Whatever its name, what it names, itself or files elsewhere, and whether it has an end: what to give instead is said."""
    t.clip("seg.ts", codec=("-c:v", "mpeg2video"))
    head = "#EXTM3U\n#EXT-X-TARGETDURATION:2\n#EXTINF:2,\n"
    texts = [head + part + "\n" for part in ("seg.ts", "../seg.ts", str(t.path("seg.ts")), "http://127.0.0.1:9/a.ts")]
    texts += [texts[0] + "#EXT-X-ENDLIST\n", "#EXTM3U\n#EXT-X-STREAM-INF:BANDWIDTH=1\nlist.m3u8\n",
              '#EXTM3U\n#EXT-X-MEDIA:TYPE=AUDIO,GROUP-ID="a",NAME="a",URI="list.m3u8"\n'
              '#EXT-X-STREAM-INF:BANDWIDTH=1,AUDIO="a"\nlist.m3u8\n']
    names = ("list.m3u8", "list.avi", "list.m3u")
    for number, text in enumerate(texts):
        for name in names if text == texts[0] else (names[number % len(names)],):
            t.write(name, text)
            t.vvr("info", name, timeout=20).expect(3, f"'{name}'", ".txt", code="playlist")
    for command in (("render", "list.m3u8", "-o", "out.png"), ("cut", "list.avi", "--start", "0s", "-o", "out.mkv"),
                    ("watch", "list.m3u", "-o", "out.png")):
        t.vvr(*command, timeout=20).expect(3, f"'{command[1]}'", ".txt", code="playlist")
    for name in (f"/{t.path('list.avi')}", f"file://{t.path('list.avi')}"):
        t.vvr("info", name, timeout=20).expect(3, f"'{name}'", code="playlist")
    t.write("list.txt", "seg.ts\n")
    t.render("list.txt").expect(0, "20 frames")




def test_decode_leaves_frames_out_and_says_so(t):
    # 40 frames of H.264 with 2 B-frames between others, and a key frame each second.
    t.clip("clip.mp4", seconds=4, codec=("-c:v", "libx264", "-g", "10", "-bf", "2", "-x264-params", "b-pyramid=none:scenecut=0:b-adapt=0"))
    for choice, least, most in (("all", 40, 40), ("reference", 12, 20), ("key", 4, 4)):
        said = t.render("clip.mp4", "--decode", choice, "--report", "r.json", output=None).expect(0).err
        frames = t.json("r.json")["frames"]
        check(least <= frames["used"] <= most and frames["decoded"] == choice, f"{choice}: {frames}")
        check((f"(decoded: {choice}, " in said) == (choice != "all"), said)
        check(t.json("r.json")["span"]["last"] > 2.9, f"{choice} ends early: {t.json('r.json')['span']}")
    t.render("clip.mp4", "--decode", "keys").expect(1, "'keys'", "all", "reference", "key", "auto", code="choice-unknown")
    # The share of one file is not that of a recording.
    t.copy("clip.mp4", "day/1.mp4", "day/2.mp4")
    t.render("day", "--decode", "key", "--report", "r.json", output=None).expect(0, "8 frames (decoded: key) in")


def test_hdr_is_said(t):
    """Stills of PQ and HLG are dull, as nothing converts their brightness."""
    for transfer, hdr in (("smpte2084", True), ("arib-std-b67", True), ("bt709", False)):
        t.ffmpeg("-f", "lavfi", "-i", "testsrc2=size=64x48:rate=10:duration=0.5", "-vf", f"setparams=color_trc={transfer}", "-c:v", "ffv1", f"{transfer}.mkv")
        run = t.render(f"{transfer}.mkv").expect(0)
        check(("is HDR" in run.err) == hdr, f"{run}")
