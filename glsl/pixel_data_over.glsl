// Pixel data while a picture is drawn back to front: the weight of what contributes most so far, its frame and depth,
// and the opacity of all.
uniform sampler2D behind;  // the data of all that lies behind
uniform bool take_over;    // copies that data: the second of two passes, back to the texture that was read

vec4 data_behind() { return texelFetch(behind, ivec2(gl_FragCoord.xy), 0); }

// The data with something of `frame` in front. What lies behind shines through, and loses its place when it weighs less
// than what is in front.
vec4 data_over(vec4 data, float opacity, float frame) {
    float shines_through = data.x * (1.0 - opacity);
    float all = opacity + data.w * (1.0 - opacity);
    if (opacity > 0.0 && opacity >= shines_through) return vec4(opacity, frame, gl_FragCoord.z, all);
    return vec4(shines_through, data.yz, all);
}
