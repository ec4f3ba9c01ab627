uniform sampler2D transfer;  // a texel each quarter of a value: colour, and extinction per unit length times log2(e)

float scalar_of(vec4 voxel) { return voxel.a; }

// The colour is the voxel's own, the extinction of the scalar beside it the transfer function's.
vec4 optical_at(vec3 at) {
    vec4 voxel = texture(brick, at);
    return vec4(voxel.rgb, texelFetch(transfer, ivec2(voxel.a * 1020.0 + 0.5, 0), 0).a);
}

float number_at(vec3 at) { return 0.0; }
