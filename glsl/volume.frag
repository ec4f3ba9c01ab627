// A fragment of a slice of the volume. Follows these chunks:
//   volume_in.glsl      what the vertices give
//   layout_NAME.glsl    c_from_local: interpolated position to C-space
//   volume_sample.glsl  brick, texture_position, opacity_of: position in the brick's texture
//   optical_NAME.glsl   optical_at, scalar_of: colour and extinction at a position, scalar of a texel
//   shading_NAME.glsl   shaded: the lit colour
layout(location = 0) out vec4 colour;

void main() {
    float inside;
    vec4 optical = optical_at(texture_position(inside));
    float opacity = opacity_of(optical.a, inside);
    colour = vec4(shaded(optical.rgb) * opacity, opacity);
}
