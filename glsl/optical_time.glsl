uniform sampler2D transfer;  // a texel each quarter of a value: colour, and extinction per unit length times log2(e)
uniform sampler2D palette;     // 256 texels: colours from the first moment to the last

float scalar_of(vec4 voxel) { return voxel.r; }

// Colour of the time; extinction from the transfer function.
vec4 optical_at(vec3 at) {
    float extinction = texelFetch(transfer, ivec2(texture(brick, at).r * 1020.0 + 0.5, 0), 0).a;
    float t = clamp((at.z - brick_offset.z) / brick_scale.z, 0.0, 1.0);
    return vec4(texelFetch(palette, ivec2(t * 255.0 + 0.5, 0), 0).rgb, extinction);
}

float number_at(vec3 at) { return 0.0; }
