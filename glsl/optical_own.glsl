uniform sampler2D transfer;  // one texel per quarter value: colour, and log2(e) times the extinction per unit length

float scalar_of(vec4 voxel) { return voxel.a; }

// Colour of the voxel; extinction from the transfer function of the scalar.
vec4 optical_at(vec3 at) {
    vec4 voxel = texture(brick, at);
    return vec4(voxel.rgb, texelFetch(transfer, ivec2(voxel.a * 1020.0 + 0.5, 0), 0).a);
}

float number_at(vec3 at) { return 0.0; }
