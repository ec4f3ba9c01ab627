layout(location = 0) in vec2 corner;  // x: 0 or 1 along the segment; y: -1 or 1 across it
layout(location = 1) in vec3 from;
layout(location = 2) in vec3 to;
layout(location = 3) in vec4 rgba;

uniform mat4 clip_from_p;
uniform vec2 half_width;  // in clip units of x and y

out vec4 line_colour;

void main() {
    vec4 a = clip_from_p * vec4(from, 1.0);
    vec4 b = clip_from_p * vec4(to, 1.0);
    vec2 along = (b.xy / b.w - a.xy / a.w) / half_width;
    along /= max(length(along), 1e-6);
    vec4 at = mix(a, b, corner.x);
    at.xy += (vec2(-along.y, along.x) * corner.y + along * (corner.x * 2.0 - 1.0) * 0.5) * half_width * at.w;
    gl_Position = at;
    line_colour = rgba;
}
