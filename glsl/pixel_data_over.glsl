// Pixel data of a picture that is drawn back to front: weight, frame, depth and event of the strongest contribution so
// far, and the total opacity.
#ifdef GL_EXT_shader_framebuffer_fetch
layout(location = 0) inout vec4 data;  // the data so far
layout(location = 1) inout float object;

const bool copy_only = false;

void load_behind() {}
#else
uniform sampler2D behind;         // the data so far
uniform sampler2D object_behind;
uniform bool copy_only;           // second of two passes: copies the result back to the textures that were read

layout(location = 0) out vec4 data;
layout(location = 1) out float object;

void load_behind() {
    data = texelFetch(behind, ivec2(gl_FragCoord.xy), 0);
    object = texelFetch(object_behind, ivec2(gl_FragCoord.xy), 0).r;
}
#endif

// Whether a layer in front weighs at least as much as what shines through it from behind.
bool outweighs(float opacity) { return opacity > 0.0 && opacity >= data.x * (1.0 - opacity); }

// Composites a layer over the data. What lies behind shines through, and is replaced if it weighs less.
void composite_over(float opacity, float frame, float number) {
    float total = opacity + data.w * (1.0 - opacity);
    if (outweighs(opacity)) {
        data = vec4(opacity, frame, gl_FragCoord.z, total);
        object = number;
    } else {
        data = vec4(data.x * (1.0 - opacity), data.yz, total);
    }
}
