in vec2 at;

uniform sampler2D darkness;
uniform vec4 shadow;

layout(location = 0) out vec4 colour;

void main() {
    float opacity = shadow.a * texture(darkness, at).r;
    colour = vec4(shadow.rgb * opacity, opacity);
}
