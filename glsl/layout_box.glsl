// The box: P = (length (t - 1/2), y_s y, Δr x).
uniform float layout_depth;   // Δr
uniform float layout_height;  // y_s
uniform float layout_length;

vec3 local_from_p(vec3 p, float t_reference) { return p; }

vec3 c_from_local(vec3 local, float t_reference) {
    return vec3(local.z / layout_depth, local.y / layout_height, local.x / layout_length + 0.5);
}

vec3 c_from_p(vec3 p) { return c_from_local(p, 0.0); }
