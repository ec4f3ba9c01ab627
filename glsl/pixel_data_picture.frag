// A standing frame as pixel data. The piece before it: pixel_data_over.glsl.
uniform float opacity;
uniform float frame;

void main() {
    take_behind();
    if (!take_over) put_over(opacity, frame, 0.0);
}
