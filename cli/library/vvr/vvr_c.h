#ifndef VVR_VVR_C_H
#define VVR_VVR_C_H

/* The library: its functions for C, and for languages that call C. vvr.h is made of them, and describes what they do;
   this header says what differs. Text is UTF-8. No function throws, and no callback may. */

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

/* As ClipInfo. */
struct vvr_clip_info {
    const char* container;
    const char* codec;
    int width;
    int height;
    double frames_per_second;
    double seconds;
    int64_t frames;
};

/* As PathPoint. */
struct vvr_path_point {
    int64_t frame;
    double seconds;
    double x;
    double y;
};

/* As Event. */
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
    const struct vvr_path_point* path;
    size_t path_length;
};

/* What a function has made, or its error. Zero where nothing was asked for or made. Names are as in Rendering. */
struct vvr_rendering {
    int status;       /* enum vvr_status */
    const char* code; /* of the error; "" = none */
    const char* text; /* of the error */
    int width;
    int height;
    const float* rgba;
    const struct vvr_setting* settings;
    size_t setting_count;
    int64_t frames;
    int64_t damaged;
    const char* const* warnings;
    size_t warning_count;
    const struct vvr_event* events;
    size_t event_count;
    const float* depth; /* as the members of PixelData */
    const float* time;
    const float* frame;
    const float* object;
    struct vvr_clip_info clip; /* of vvr_read_clip_info */
};

/* Each returns a rendering, which has the error and is to be freed with vvr_free; NULL only if there is no memory for
   it. The options may be NULL. */
__attribute__((visibility("default"))) struct vvr_rendering* vvr_render_clip(const char* clip,
                                                                             const struct vvr_options* options);
__attribute__((visibility("default"))) struct vvr_rendering* vvr_render_frames(const struct vvr_frames* frames,
                                                                               const struct vvr_options* options);
__attribute__((visibility("default"))) struct vvr_rendering* vvr_read_clip_info(const char* clip);

/* Writes the image of a rendering with its settings. The caller may have filled it. */
__attribute__((visibility("default"))) struct vvr_rendering* vvr_write_image(const char* file,
                                                                             const struct vvr_rendering* image);

/* The argument may be NULL. */
__attribute__((visibility("default"))) void vvr_free(struct vvr_rendering* rendering);

/* As library_version. */
__attribute__((visibility("default"))) const char* vvr_version(void);

#ifdef __cplusplus
}
#endif

#endif
