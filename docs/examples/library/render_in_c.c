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
    for (size_t i = 0; i < vvr_warning_count(rendering); ++i) fprintf(stderr, "warning: %s\n", vvr_warning(rendering, i));
    for (size_t i = 0; i < vvr_event_count(rendering); ++i) {
        const struct vvr_event* event = vvr_event_at(rendering, i);
        printf("%d: %s, %.1f s to %.1f s\n", event->number, event->kind, event->first_seconds, event->last_seconds);
    }
    if (vvr_status_of(rendering) == VVR_OK) vvr_write_image(rendering, argv[2]);
    const int status = vvr_status_of(rendering);
    if (status != VVR_OK) {
        fprintf(stderr, "%s [%s]\n", vvr_error_text(rendering), vvr_error_code(rendering));
    } else {
        printf("%lld frames in %s\n", (long long)vvr_frame_count(rendering), argv[2]);
    }
    vvr_free(rendering);
    return status == VVR_OK ? 0 : 2 + status;
}
