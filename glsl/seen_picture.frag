uniform float opacity;
uniform float frame;

layout(location = 0) out vec4 seen;

void main() {
    seen = seen_behind();
    if (!take_over) seen = seen_over(seen, opacity, frame);
}
