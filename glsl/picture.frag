in vec2 at;

uniform sampler2D picture;
uniform float opacity;

layout(location = 0) out vec4 colour;

void main() { colour = vec4(texture(picture, at).rgb * opacity, opacity); }
