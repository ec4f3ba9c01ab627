// The state of what is seen in a pixel: weight of what contributes most so far, its frame and depth, opacity of all.
uniform sampler2D behind;  // the state of what lies behind
uniform bool take_over;    // the state is drawn beside the one that is read, and copied in a second pass

vec4 seen_behind() { return texelFetch(behind, ivec2(gl_FragCoord.xy), 0); }

// What is seen when something of `frame` stands before it. What lies behind shines through, and loses its place when
// it comes to weigh less than what is before it.
vec4 seen_over(vec4 seen, float opacity, float frame) {
    float shines_through = seen.x * (1.0 - opacity);
    float all = opacity + seen.w * (1.0 - opacity);
    if (opacity > 0.0 && opacity >= shines_through) return vec4(opacity, frame, gl_FragCoord.z, all);
    return vec4(shines_through, seen.yz, all);
}
