layout(location = 0) in vec3 p;
layout(location = 1) in float t_reference;

uniform mat4 clip_from_p;
uniform vec3 eye;
uniform vec3 forward;
uniform bool perspective;
uniform vec3 to_light;

out vec3 local;
out float t_near;
out vec3 ray;  // from one slice to the next at spacing 1: linear over a slice, unlike its length
out vec3 light;
out vec3 view;

void main() {
    gl_Position = clip_from_p * vec4(p, 1.0);
    local = local_from_p(p, t_reference);
    t_near = t_reference;
    light = local_from_p(to_light, t_reference);
    view = local_from_p(perspective ? p - eye : forward, t_reference);
    ray = perspective ? (p - eye) / dot(p - eye, forward) : forward;
}
