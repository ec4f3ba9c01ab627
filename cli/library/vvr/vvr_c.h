#ifndef VVR_VVR_C_H
#define VVR_VVR_C_H

/* The library for C, and for languages that call C. vvr.h describes what the functions do; this header says what
   differs. Text is UTF-8. Pointers that a rendering returns are valid until vvr_free. No function throws. */

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* 0, or the category of an error, as FailureKind. These are not the exit statuses of the program. */
enum vvr_status {
    VVR_OK = 0,
    VVR_USAGE = 1,
    VVR_IO = 2,
    VVR_NOT_VIDEO = 3,
    VVR_BACKEND = 4,
    VVR_LIMIT = 5,
    VVR_BUG = 6,
    VVR_CANCELLED = 7
};

enum vvr_pixel_format { VVR_GRAY = 0, VVR_RGB = 1, VVR_BGR = 2, VVR_RGBA = 3, VVR_BGRA = 4 };

enum vvr_stage { VVR_READING = 0, VVR_DRAWING = 1 };

struct vvr_setting {
    const char* name;
    const char* value;
};

/* As FrameView. */
struct vvr_frame {
    const uint8_t* pixels;
    ptrdiff_t stride;
    double seconds;
};

/* As FrameSequence. */
struct vvr_frames {
    int width;
    int height;
    int format; /* enum vvr_pixel_format */
    double frames_per_second;
    int64_t frames;
    int (*read)(void* user, int64_t index, struct vvr_frame* frame); /* returns 0 after the last frame */
    void* user;                                                      /* passed to read */
};

/* As Settings and RenderOptions. All members may be 0. */
struct vvr_options {
    const struct vvr_setting* settings;
    size_t setting_count;
    int events;                                                          /* 1 = return the events */
    int pixel_data;                                                      /* 1 = return what each pixel shows */
    int (*progress)(void* user, int stage, int64_t done, int64_t total); /* stage: enum vvr_stage; 0 = cancel */
    void* user;                                                          /* passed to progress */
};

/* As Event. Its path is left out. */
struct vvr_event {
    int number;
    const char* kind;
    const char* object_class;
    double score;
    int64_t first_frame;
    int64_t last_frame;
    double first_seconds;
    double last_seconds;
    double still_seconds;
    const char* direction;
    int x; /* of the box of all its places, pixels */
    int y;
    int width;
    int height;
    int from;
    int into;
    int by;
    int open_ended; /* 0 or 1 */
};

/* The result of a render, or its error. */
struct vvr_rendering;

/* As render_image. The options may be NULL.
   Return a rendering in any case, to be freed with vvr_free; NULL only if there is no memory for it. */
__attribute__((visibility("default"))) struct vvr_rendering* vvr_render_clip(const char* clip,
                                                                             const struct vvr_options* options);
__attribute__((visibility("default"))) struct vvr_rendering* vvr_render_frames(const struct vvr_frames* frames,
                                                                               const struct vvr_options* options);

/* The argument may be NULL. */
__attribute__((visibility("default"))) void vvr_free(struct vvr_rendering* rendering);

/* The error of the last function that got this rendering: enum vvr_status, its code, and a text. "" without an error.
   NULL counts as a rendering for which there was no memory; the functions below need another one. */
__attribute__((visibility("default"))) int vvr_status_of(const struct vvr_rendering* rendering);
__attribute__((visibility("default"))) const char* vvr_error_code(const struct vvr_rendering* rendering);
__attribute__((visibility("default"))) const char* vvr_error_text(const struct vvr_rendering* rendering);

/* As Image::rgba; NULL after an error. */
__attribute__((visibility("default"))) const float* vvr_image(const struct vvr_rendering* rendering, int* width,
                                                              int* height);

/* As the member of PixelData with this name: "depth", "time", "frame" or "object". NULL if there is none. */
__attribute__((visibility("default"))) const float* vvr_pixel_data(const struct vvr_rendering* rendering,
                                                                   const char* name);

__attribute__((visibility("default"))) int64_t vvr_frame_count(const struct vvr_rendering* rendering);

/* An index that is too large gives NULL. */
__attribute__((visibility("default"))) size_t vvr_warning_count(const struct vvr_rendering* rendering);
__attribute__((visibility("default"))) const char* vvr_warning(const struct vvr_rendering* rendering, size_t index);
__attribute__((visibility("default"))) size_t vvr_event_count(const struct vvr_rendering* rendering);
__attribute__((visibility("default"))) const struct vvr_event* vvr_event_at(const struct vvr_rendering* rendering,
                                                                            size_t index);

/* As write_image. Returns enum vvr_status; the rendering then has the error. */
__attribute__((visibility("default"))) int vvr_write_image(struct vvr_rendering* rendering, const char* file);

/* As library_version. */
__attribute__((visibility("default"))) const char* vvr_version(void);

#ifdef __cplusplus
}
#endif

#endif
