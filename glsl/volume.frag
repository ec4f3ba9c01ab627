// A pixel of a slice of the volume. The pieces before it:
//   layout_NAME.glsl    c_from_local: C-space from the interpolated position
//   volume_sample.glsl  brick, texture_position, opacity_of: where the pixel lies in the brick's texture
//   optical_NAME.glsl   optical_at, scalar_of: colour and extinction at a place, and the scalar of a texel
//   shading_NAME.glsl   shaded: the colour in the light
layout(location = 0) out vec4 colour;

void main() {
    float inside;
    vec4 optical = optical_at(texture_position(inside));
    float opacity = opacity_of(optical.a, inside);
    colour = vec4(shaded(optical.rgb) * opacity, opacity);
}
