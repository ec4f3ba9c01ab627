// The horseshoe, Eq. (1): P = (-r cos πt, y_s y, r sin πt), r = r_min + Δr x.
uniform float layout_r_min;
uniform float layout_depth;   // Δr
uniform float layout_height;  // y_s

const float pi = 3.14159265358979;

// Rotates P about the y axis so that t_reference lies on the first axis: affine, so it interpolates exactly.
vec3 local_from_p(vec3 p, float t_reference) {
    float cosine = cos(pi * t_reference);
    float sine = sin(pi * t_reference);
    return vec3(-p.x * cosine + p.z * sine, p.y, p.x * sine + p.z * cosine);
}

// Within a cell the angle from t_reference is below 0.04 rad, so short series for atan and sqrt are exact in float.
vec3 c_from_local(vec3 local, float t_reference) {
    float slope = local.z / local.x;
    float square = slope * slope;
    float r = local.x * (1.0 + square * (0.5 - 0.125 * square));
    float angle = slope * (1.0 - square * (1.0 / 3.0 - 0.2 * square));
    return vec3((r - layout_r_min) / layout_depth, local.y / layout_height, t_reference + angle / pi);
}

// The map for a position anywhere; t from -1/2 to 3/2.
vec3 c_from_p(vec3 p) {
    float t = atan(p.z, -p.x) / pi;
    return vec3((length(p.xz) - layout_r_min) / layout_depth, p.y / layout_height, t < -0.5 ? t + 2.0 : t);
}
