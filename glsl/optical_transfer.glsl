uniform sampler2D transfer;  // one texel per quarter value: colour, and log2(e) times the extinction per unit length

float scalar_of(vec4 voxel) { return voxel.r; }

vec4 optical_at(vec3 at) { return texelFetch(transfer, ivec2(texture(brick, at).r * 1020.0 + 0.5, 0), 0); }

float number_at(vec3 at) { return 0.0; }
