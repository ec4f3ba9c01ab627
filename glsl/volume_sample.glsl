uniform sampler3D brick;
uniform vec3 brick_scale;   // C-space to texture coordinates
uniform vec3 brick_offset;
uniform float spacing;      // of the slices, P-space units
uniform float frame_height;  // P-space units

vec3 texture_from_c(vec3 c) { return c * brick_scale + brick_offset; }

// Texture coordinates of the fragment. Straight cells extend slightly beyond the volume; there `inside` is 0. It rises
// to 1 within a thousandth of the depth: with a step, rounding would decide about a whole slice at the edge.
vec3 texture_position(out float inside) {
    vec3 c = c_from_local(local, t_near);
    inside = clamp((0.5 - abs(c.x - 0.5)) * 1000.0, 0.0, 1.0);
    return texture_from_c(c);
}

float opacity_of(float extinction, float inside) { return inside * (1.0 - exp2(-extinction * spacing * length(ray))); }
