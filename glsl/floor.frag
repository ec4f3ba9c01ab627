in vec2 at;

uniform sampler2D darkness;
uniform sampler2D tint;
uniform bool tinted;  // use the colours of the objects that cast the shadow
uniform vec4 shadow;

layout(location = 0) out vec4 colour;

void main() {
    float opacity = shadow.a * texture(darkness, at).r;
    vec3 rgb = tinted ? texture(tint, at).rgb : shadow.rgb;
    colour = vec4(rgb * opacity, opacity);
}
