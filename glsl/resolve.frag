// Averages the samples of a pixel.
uniform sampler2DMS drawn;
uniform int samples;

layout(location = 0) out vec4 colour;

void main() {
    colour = vec4(0.0);
    for (int i = 0; i < samples; ++i) colour += texelFetch(drawn, ivec2(gl_FragCoord.xy), i);
    colour /= float(samples);
}
