// Opaque geometry as a state of what is seen: its weight, frame, depth, and the opacity of all that is there.
in float seen_frame;

layout(location = 0) out vec4 seen;

void main() { seen = vec4(1.0, seen_frame, gl_FragCoord.z, 1.0); }
