// Pixel data of a standing frame. Follows pixel_data_over.glsl.
uniform float opacity;
uniform float frame;

void main() {
    load_behind();
    if (!copy_only) composite_over(opacity, frame, 0.0);
}
