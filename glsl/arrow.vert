layout(location = 0) in vec3 position;  // the reference glyph, along +z from the origin
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 from;      // per glyph, P-space
layout(location = 3) in vec3 vector;
layout(location = 4) in float speed;
layout(location = 5) in float frame;

uniform mat4 clip_from_p;
uniform float thickness;     // P-space units per unit of the reference glyph
uniform vec2 speed_range;    // pixels per frame at the ends of the colour scale

out vec3 world_normal;
out float strength;
out float frame_number;

void main() {
    float len = length(vector);
    vec3 along = vector / len;
    vec3 helper = abs(along.y) < 0.9 ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0);
    vec3 side = normalize(cross(helper, along));
    vec3 up = cross(along, side);
    // Thin short arrows, so that they keep the shape of an arrow.
    float width = min(thickness, len);
    gl_Position = clip_from_p * vec4(from + (side * position.x + up * position.y) * width + vector * position.z, 1.0);
    world_normal = side * normal.x + up * normal.y + along * normal.z;
    frame_number = frame;
    strength = clamp((speed - speed_range.x) / (speed_range.y - speed_range.x), 0.0, 1.0);
}
