layout(location = 0) in vec2 corner;   // x: 0 or 1 along the segment; y: -1 or 1 across it
layout(location = 1) in vec4 before;   // four consecutive points of the vertex buffer: position, and 0..1 along the line
layout(location = 2) in vec4 from;
layout(location = 3) in vec4 to;
layout(location = 4) in vec4 after;
layout(location = 5) in vec3 from_line;  // length of the line, speed, frame
layout(location = 6) in vec3 to_line;

uniform mat4 clip_from_p;
uniform vec3 eye;
uniform vec3 forward;
uniform bool perspective;
uniform float half_width;     // P-space units
uniform float min_width;      // half the minimum width, P-space units; at distance 1 for perspective views
uniform float stripe_length;  // P-space units
uniform vec2 speed_range;     // pixels per frame at the ends of the colour scale

out float across;
out float stripes;     // along the line, counted from its first vertex
out float half_girth;  // half the line's width, in stripes
out vec3 side;
out vec3 toward;
out float strength;
out float frame_number;

// From the end of one line to the start of the next, w does not grow.
vec3 direction(vec4 a, vec4 b) { return b.w > a.w ? normalize(b.xyz - a.xyz) : vec3(0.0); }

void main() {
    bool begins = corner.x < 0.5;
    vec4 at = begins ? from : to;
    vec3 line = begins ? from_line : to_line;
    vec3 segment = direction(from, to);
    vec3 along = segment + (begins ? direction(before, from) : direction(to, after));
    // If the line doubles back, the bisector of the two segments is undefined.
    along = dot(along, along) > 0.2 ? normalize(along) : segment;

    vec3 ray = perspective ? at.xyz - eye : forward;
    side = cross(ray, along);
    if (dot(side, side) < 1e-8 * dot(ray, ray)) side = cross(vec3(0.31, 0.9, 0.3), along);  // the line runs along the ray
    side = normalize(side);
    toward = cross(side, along);
    toward *= -sign(dot(toward, ray));

    float wide = max(half_width, min_width * (perspective ? dot(ray, forward) : 1.0));
    // Mitre joint, limited at sharp bends.
    float mitre = 1.0 / max(dot(along, segment), 0.6);
    // Between two lines: collapse the quad to a point.
    bool visible = segment != vec3(0.0);
    vec3 p = visible ? at.xyz + side * (corner.y * wide * mitre) : from.xyz;
    gl_Position = clip_from_p * vec4(p, 1.0);

    across = corner.y;
    stripes = at.w * line.x / stripe_length;
    frame_number = line.z;
    half_girth = wide / stripe_length;
    strength = clamp((line.y - speed_range.x) / (speed_range.y - speed_range.x), 0.0, 1.0);
}
