// Pixel data of a slice of the volume. Follows the chunks of volume.frag except shading_NAME.glsl, then
// pixel_data_over.glsl.
uniform float texel_layers;      // of the texture: the brick's, plus one at each end
uniform float first_layer;       // of the brick, in the window
uniform float last_layer;        // of the window
uniform float frames_per_layer;

// A sample between two layers belongs to the one that contributes more extinction: interpolation extends an object into
// the next layer, in whose frames it is absent.
float frame_of(vec3 at) {
    float between = at.z * texel_layers - 0.5;
    float low = floor(between);
    float share = between - low;
    float of_low = optical_at(vec3(at.xy, (low + 0.5) / texel_layers)).a * (1.0 - share);
    float of_high = optical_at(vec3(at.xy, (low + 1.5) / texel_layers)).a * share;
    float texel = of_high > of_low || (of_high == of_low && share > 0.5) ? low + 1.0 : low;
    return clamp(first_layer + texel - 1.0, 0.0, last_layer) * frames_per_layer;
}

// Most fragments show nothing. They are discarded before anything is loaded, in both passes alike.
void main() {
    float inside;
    vec3 at = texture_position(inside);
    float opacity = opacity_of(optical_at(at).a, inside);
    if (opacity <= 0.0) discard;
    load_behind();
    if (!copy_only) composite_over(opacity, frame_of(at), number_at(at));
}
