layout(location = 0) out vec4 colour;

void main() {
    float inside;
    vec4 optical = optical_of(texture(brick, texture_position(inside)));
    float opacity = opacity_of(optical.a, inside);
    colour = vec4(shaded(optical.rgb) * opacity, opacity);
}
