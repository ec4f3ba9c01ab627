// A standing frame as pixel data. The piece before it: pixel_data_over.glsl.
uniform float opacity;
uniform float frame;

layout(location = 0) out vec4 data;

void main() {
    data = data_behind();
    if (!take_over) data = data_over(data, opacity, frame);
}
