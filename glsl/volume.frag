in vec3 local;
in float t_near;
in float path;

uniform sampler3D brick;
uniform vec2 brick_from_t;   // texture coordinate of the brick from t_C: scale and offset

layout(location = 0) out vec4 colour;

void main() {
    vec3 c = c_from_local(local, t_near);
    vec4 optical = optical_of(texture(brick, vec3(c.xy, c.z * brick_from_t.x + brick_from_t.y)));
    // Straight cells reach a little over the curved volume.
    float inside = step(abs(c.x - 0.5), 0.5);
    float opacity = inside * (1.0 - exp2(-optical.a * path));
    colour = vec4(optical.rgb * opacity, opacity);
}
