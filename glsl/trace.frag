in float across;
in float stripes;
in float half_girth;
in vec3 side;
in vec3 toward;
in float strength;

uniform sampler1D zebra;
uniform float phase;  // in stripes
uniform vec3 to_light;
uniform vec3 slow_colour;
uniform vec3 fast_colour;
uniform float shade;  // brightness of dark stripes, 0..1

layout(location = 0) out vec4 colour;

void main() {
    // The texture leads at the edges: stripes become chevrons that show the direction of the flow even in a still
    // picture.
    float stripe = texture(zebra, stripes + abs(across) * half_girth - phase).r;
    // Shade the flat strip as a tube.
    vec3 normal = side * across + toward * sqrt(max(1.0 - across * across, 0.0));
    float lit = 0.62 + 0.38 * dot(normalize(normal), to_light);
    colour = vec4(mix(slow_colour, fast_colour, strength) * mix(shade, 1.0, stripe) * lit, 1.0);
}
