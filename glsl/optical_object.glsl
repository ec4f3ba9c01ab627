uniform sampler2D transfer;  // a texel each quarter of a value: colour, and extinction per unit length times log2(e)

// Colour of the object; extinction from the transfer function of the scalar. Follows a chunk that has scalar_of and look_at.
vec4 optical_at(vec3 at) {
    float extinction = texelFetch(transfer, ivec2(scalar_of(texture(brick, at)) * 1020.0 + 0.5, 0), 0).a;
    if (extinction == 0.0) return vec4(0.0);
    vec4 look = look_at(at);
    return vec4(look.rgb, extinction * look.a);
}
