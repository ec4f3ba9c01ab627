in vec3 world_normal;
in float strength;

uniform vec3 to_light;
uniform vec3 slow_colour;
uniform vec3 fast_colour;

layout(location = 0) out vec4 colour;

void main() {
    float lit = 0.62 + 0.38 * dot(normalize(world_normal), to_light);
    colour = vec4(mix(slow_colour, fast_colour, strength) * lit, 1.0);
}
