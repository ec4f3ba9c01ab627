layout(location = 0) in vec3 p;
layout(location = 1) in float t_reference;

uniform mat4 clip_from_p;
uniform vec3 eye;
uniform vec3 forward;
uniform float spacing;
uniform bool perspective;

out vec3 local;
out float t_near;
out float path;  // from this slice to the next along the ray

void main() {
    gl_Position = clip_from_p * vec4(p, 1.0);
    local = local_from_p(p, t_reference);
    t_near = t_reference;
    vec3 ray = p - eye;
    path = perspective ? spacing * length(ray) / dot(ray, forward) : spacing;
}
