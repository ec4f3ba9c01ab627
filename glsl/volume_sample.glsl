in vec3 local;
in float t_near;
in vec3 ray;

uniform sampler3D brick;
uniform vec3 brick_scale;   // texture coordinates of the brick from C-space
uniform vec3 brick_offset;
uniform float spacing;      // of the slices
uniform float frame_height;  // P-space units

vec3 texture_from_c(vec3 c) { return c * brick_scale + brick_offset; }

// Where in the texture the fragment lies; outside of the volume, where straight cells reach a little over, `inside` is 0.
vec3 texture_position(out float inside) {
    vec3 c = c_from_local(local, t_near);
    inside = step(abs(c.x - 0.5), 0.5);
    return texture_from_c(c);
}

float opacity_of(float extinction, float inside) { return inside * (1.0 - exp2(-extinction * spacing * length(ray))); }
