// Pixel data while a picture is drawn back to front: the weight of what contributes most so far, its frame and depth,
// and the opacity of all; and beside it the event that it belongs to.
uniform sampler2D behind;         // the data of all that lies behind
uniform sampler2D object_behind;
uniform bool take_over;           // copies that data: the second of two passes, back to the textures that were read

layout(location = 0) out vec4 data;
layout(location = 1) out float object;

void take_behind() {
    data = texelFetch(behind, ivec2(gl_FragCoord.xy), 0);
    object = texelFetch(object_behind, ivec2(gl_FragCoord.xy), 0).r;
}

// Whether something in front weighs at least as much as what lies behind and shines through.
bool outweighs(float opacity) { return opacity > 0.0 && opacity >= data.x * (1.0 - opacity); }

// Puts something in front of the data. What lies behind shines through, and loses its place when it weighs less.
void put_over(float opacity, float frame, float number) {
    float all = opacity + data.w * (1.0 - opacity);
    if (outweighs(opacity)) {
        data = vec4(opacity, frame, gl_FragCoord.z, all);
        object = number;
    } else {
        data = vec4(data.x * (1.0 - opacity), data.yz, all);
    }
}
