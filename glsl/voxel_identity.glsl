// A voxel of a brick that has an identity and a scalar.
uniform sampler2D palette;  // a texel for each: colour, and a factor on the extinction

float scalar_of(vec4 voxel) { return voxel.a; }

// The voxel's identity is not interpolated: it is a palette index and the low and high byte of the event number.
vec3 identity_at(vec3 at) {
    ivec3 size = textureSize(brick, 0);
    return texelFetch(brick, clamp(ivec3(at * vec3(size)), ivec3(0), size - 1), 0).rgb * 255.0;
}

vec4 look_at(vec3 at) { return texelFetch(palette, ivec2(identity_at(at).r + 0.5, 0), 0); }

float number_at(vec3 at) {
    vec3 identity = identity_at(at);
    return floor(identity.g + 0.5) + 256.0 * floor(identity.b + 0.5);
}
