// A ray through the volume, from the eye on. Follows the chunks of volume.frag that are not of slices, and page_voxel.glsl.
// VIEW draws colours, PICK says what a pixel shows, REACH how much hides a point.
uniform mat4 p_from_clip;
uniform vec3 eye;
uniform vec3 forward;
uniform vec3 to_light;
uniform vec3 low;            // of the box around the volume, P-space
uniform vec3 high;
uniform vec2 piece;          // the first and the last t that is shown
uniform float voxel;         // its shortest side, P-space units
uniform sampler3D far;       // of blocks of 4 voxels: how many it is to the nearest that has something
uniform vec2 pixels;         // of what is drawn

// Frames that stand in the volume: upper left corner, its sides, and opacity; 0 = there is none.
uniform vec3 frame_corner[3];
uniform vec3 frame_across[3];
uniform vec3 frame_down[3];
uniform float frame_opacity[3];

#ifdef VIEW
uniform sampler2D frame_0;
uniform sampler2D frame_1;
uniform sampler2D frame_2;
uniform sampler2D lines;       // colour of lines and arrows, premultiplied, and their depth
uniform sampler2D lines_depth;
layout(location = 0) out vec4 colour;
#else
layout(location = 0) out uvec4 found;
#endif
#ifdef REACH
uniform highp sampler2D points;  // P-space
#endif

const float nowhere = 1e9;
const int most_steps = 1500;

float along_ray(vec3 p) { return dot(p - eye, forward); }

// Where the ray meets a frame, and the place there in shares of the frame.
float frame_hit(int k, out vec2 share) {
    share = vec2(0.0);
    if (frame_opacity[k] <= 0.0) return nowhere;
    vec3 across = frame_across[k];
    vec3 down = frame_down[k];
    vec3 normal = cross(across, down);
    float steep = dot(ray, normal);
    if (abs(steep) < 1e-6) return nowhere;
    float z = dot(frame_corner[k] - eye, normal) / steep;
    vec3 from = eye + ray * z - frame_corner[k];
    share = vec2(dot(from, across) / dot(across, across), dot(from, down) / dot(down, down));
    return z > 0.0 && share == clamp(share, 0.0, 1.0) ? z : nowhere;
}

void main() {
#ifdef REACH
    vec3 target = texelFetch(points, ivec2(gl_FragCoord.xy), 0).xyz;
    float end = along_ray(target) - 2.0 * voxel;
    ray = (target - eye) / along_ray(target);
#else
    vec4 target = p_from_clip * vec4(gl_FragCoord.xy / pixels * 2.0 - 1.0, 1.0, 1.0);
    float end = nowhere;
    ray = (target.xyz / target.w - eye) / along_ray(target.xyz / target.w);
#endif
    // Between these the ray is in the box.
    vec3 slope = mix(ray, vec3(1e-9), lessThan(abs(ray), vec3(1e-9)));
    vec3 a = (low - eye) / slope;
    vec3 b = (high - eye) / slope;
    float first = max(max(min(a.x, b.x), min(a.y, b.y)), max(min(a.z, b.z), 0.0));
    float last = min(min(max(a.x, b.x), max(a.y, b.y)), min(max(a.z, b.z), end));

    float stands[4];
    vec2 shares[4];
    for (int k = 0; k < 3; ++k) stands[k] = frame_hit(k, shares[k]);
    stands[3] = nowhere;
#ifdef VIEW
    vec4 line = texelFetch(lines, ivec2(gl_FragCoord.xy), 0);
    vec4 line_p = p_from_clip * vec4(gl_FragCoord.xy / pixels * 2.0 - 1.0, texelFetch(lines_depth, ivec2(gl_FragCoord.xy), 0).r * 2.0 - 1.0, 1.0);
    if (line.a > 0.0) stands[3] = along_ray(line_p.xyz / line_p.w);
#endif

    vec4 sum = vec4(0.0);
#ifndef VIEW
    float heaviest = 0.0;
    found = uvec4(0u);
#endif
    float z = ceil(max(first, 0.0) / spacing) * spacing;
    bool ended = false;
    for (int i = 0; i < most_steps && sum.a < 0.995 && !ended; ++i) {
        ended = z > last;
        float until = ended ? end : z;
        // What stands before the next sample; at most four things do.
        float nearest = min(min(stands[0], stands[1]), min(stands[2], stands[3]));
        for (int n = 0; n < 4 && nearest <= until && nearest < nowhere; ++n) {
            int k = nearest == stands[0] ? 0 : nearest == stands[1] ? 1 : nearest == stands[2] ? 2 : 3;
            float opacity = k < 3 ? frame_opacity[min(k, 2)] : 0.0;
#ifdef VIEW
            vec4 stand = k == 3 ? line : k == 0 ? texture(frame_0, shares[0]) : k == 1 ? texture(frame_1, shares[1]) : texture(frame_2, shares[2]);
            sum += (k == 3 ? stand : vec4(stand.rgb * opacity, opacity)) * (1.0 - sum.a);
#else
            if (opacity * (1.0 - sum.a) > heaviest) {
                heaviest = opacity * (1.0 - sum.a);
                found = uvec4(0u, uint(clamp(c_from_p(eye + ray * nearest).z, 0.0, 1.0) * 16777215.0), k == 2 ? 2u : 3u, 0u);
            }
            sum.a += opacity * (1.0 - sum.a);
#endif
            stands[k] = nowhere;
            nearest = min(min(stands[0], stands[1]), min(stands[2], stands[3]));
        }
        if (ended) break;
        vec3 p = eye + ray * z;
        vec3 c = c_from_p(p);
        float beside = (abs(c.x - 0.5) - 0.5) * layout_depth;
        float jump = 0.0;
        if (beside > 0.0) {
            jump = beside / length(ray);
        } else if (c.z >= piece.x && c.z <= piece.y) {
            vec3 at = texture_from_c(c);
            ivec3 cell = clamp(ivec3(at * vec3(textureSize(brick, 0)) / 4.0), ivec3(0), textureSize(far, 0) - 1);
            float blocks = floor(texelFetch(far, cell, 0).r * 255.0 + 0.5);
            jump = (blocks - 1.0) * 4.0 * voxel / length(ray);
            if (blocks < 0.5) {
                t_near = c.z;
                local = local_from_p(p, t_near);
                float inside;
                at = texture_position(inside);
                vec4 optical = optical_at(at);
                if (optical.a > 0.0) {
                    float opacity = opacity_of(optical.a, inside) * (1.0 - sum.a);
#ifdef VIEW
                    light = local_from_p(to_light, t_near);
                    view = local_from_p(p - eye, t_near);
                    sum += vec4(shaded(optical.rgb) * opacity, opacity);
#else
                    if (opacity > heaviest) {
                        heaviest = opacity;
                        found = uvec4(uint(number_at(at)), uint(clamp(c.z, 0.0, 1.0) * 16777215.0), 1u, 0u);
                    }
                    sum.a += opacity;
#endif
                }
            }
        }
        z += max(spacing, floor(jump / spacing) * spacing);
    }
#ifdef VIEW
    colour = sum;
#else
    found.w = uint(sum.a * 255.0 + 0.5);
#endif
}
