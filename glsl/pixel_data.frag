// Pixel data of opaque geometry: weight, frame, depth, total opacity. It belongs to no event.
in float frame_number;

layout(location = 0) out vec4 data;
layout(location = 1) out float object;

void main() {
    data = vec4(1.0, frame_number, gl_FragCoord.z, 1.0);
    object = 0.0;
}
