// A pixel of a slice of the volume as pixel data. The pieces before it: those of volume.frag without shading_NAME.glsl,
// and pixel_data_over.glsl.
uniform float texel_layers;      // of the texture: one more than the brick at each end
uniform float first_layer;       // of the brick, in the window
uniform float last_layer;        // of the window
uniform float frames_per_layer;

// Between two layers the sample is of the one that gives it more of its extinction: where a thing begins or ends, it
// reaches into the layer beside it, but has not been there.
float frame_of(vec3 at) {
    float between = at.z * texel_layers - 0.5;
    float low = floor(between);
    float share = between - low;
    float of_low = optical_at(vec3(at.xy, (low + 0.5) / texel_layers)).a * (1.0 - share);
    float of_high = optical_at(vec3(at.xy, (low + 1.5) / texel_layers)).a * share;
    float texel = of_high > of_low || (of_high == of_low && share > 0.5) ? low + 1.0 : low;
    return clamp(first_layer + texel - 1.0, 0.0, last_layer) * frames_per_layer;
}

void main() {
    take_behind();
    if (take_over) return;
    float inside;
    vec3 at = texture_position(inside);
    float opacity = opacity_of(optical_at(at).a, inside);
    if (opacity > 0.0) put_over(opacity, frame_of(at), number_at(at));
}
