// A voxel of the page: a scalar in one texture, its owner in another.
uniform sampler3D owners;   // low and high byte: 4 times the place of the event plus 1, plus its state
uniform sampler2D palette;  // a texel for each owner, in rows of 256: colour, and a factor on the extinction

float scalar_of(vec4 voxel) { return voxel.r; }

int owner_at(vec3 at) {
    ivec3 size = textureSize(owners, 0);
    vec2 bytes = texelFetch(owners, clamp(ivec3(at * vec3(size)), ivec3(0), size - 1), 0).rg * 255.0 + 0.5;
    return int(bytes.r) + 256 * int(bytes.g);
}

vec4 look_at(vec3 at) {
    int owner = owner_at(at);
    return texelFetch(palette, ivec2(owner & 255, owner >> 8), 0);
}

float number_at(vec3 at) { return float(owner_at(at) >> 2); }
