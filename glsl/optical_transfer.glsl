uniform sampler2D transfer;  // a texel each quarter of a value: colour, and extinction per unit length times log2(e)

float scalar_of(vec4 voxel) { return voxel.r; }

// Colour and extinction by the transfer function.
vec4 optical_at(vec3 at) { return texelFetch(transfer, ivec2(texture(brick, at).r * 1020.0 + 0.5, 0), 0); }

float number_at(vec3 at) { return 0.0; }
