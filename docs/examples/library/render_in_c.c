/* Draws a clip from C, and lists its events: render_in_c CLIP PICTURE [SIZE] */
#include <stdio.h>

#include <vvr/vvr_c.h>

int main(int argc, char** argv) {
    if (argc < 3) {
        fprintf(stderr, "usage: render_in_c CLIP PICTURE [SIZE]\n");
        return 1;
    }
    const struct vvr_setting settings[] = {{"size", argc > 3 ? argv[3] : "1280x800"}};
    struct vvr_options options = {0};
    options.settings = settings;
    options.setting_count = 1;
    options.events = 1;
    struct vvr_rendering* rendering = vvr_render_clip(argv[1], &options);
    if (!rendering) return 2;
    for (size_t i = 0; i < rendering->warning_count; ++i) fprintf(stderr, "warning: %s\n", rendering->warnings[i]);
    for (size_t i = 0; i < rendering->event_count; ++i) {
        const struct vvr_event* event = &rendering->events[i];
        printf("%d: %s, %.1f s to %.1f s\n", event->number, event->kind, event->first_seconds, event->last_seconds);
    }
    const long long frames = rendering->frames;
    if (rendering->status == VVR_OK) {
        struct vvr_rendering* written = vvr_write_image(argv[2], rendering);
        vvr_free(rendering);
        if (!written) return 2;
        rendering = written;
    }
    const int status = rendering->status;
    if (status != VVR_OK) {
        fprintf(stderr, "%s [%s]\n", rendering->text, rendering->code);
    } else {
        printf("%lld frames in %s\n", frames, argv[2]);
    }
    vvr_free(rendering);
    return status == VVR_OK ? 0 : 2 + status;
}
