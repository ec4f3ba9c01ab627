// The box: P = (length (t - 1/2), y_s y, Δr x).
uniform vec4 layout_shape;  // r_min, Δr, y_s, length

vec3 p_from_c(vec3 c) {
    return vec3(layout_shape.w * (c.z - 0.5), layout_shape.z * c.y, layout_shape.y * c.x);
}

vec3 local_from_p(vec3 p, float t_reference) { return p; }

vec3 c_from_local(vec3 local, float t_reference) {
    return vec3(local.z / layout_shape.y, local.y / layout_shape.z, local.x / layout_shape.w + 0.5);
}
