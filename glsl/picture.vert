layout(location = 0) in vec3 p;
layout(location = 1) in vec2 texture_position;

uniform mat4 clip_from_p;

out vec2 at;

void main() {
    gl_Position = clip_from_p * vec4(p, 1.0);
    at = texture_position;
}
