// Opaque geometry as pixel data: weight, frame, depth, and the opacity of all that is there. It is no event's.
in float frame_number;

layout(location = 0) out vec4 data;
layout(location = 1) out float object;

void main() {
    data = vec4(1.0, frame_number, gl_FragCoord.z, 1.0);
    object = 0.0;
}
