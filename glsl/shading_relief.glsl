float scalar_at(vec3 at) { return scalar_of(texture(brick, texture_from_c(c_from_local(at, t_near)))); }

// Treats the scalar's gradient as a surface normal: lit by the light, and dark where the ray grazes the surface, so
// that the nearer of two crossing trails stands out.
vec3 shaded(vec3 colour) {
    // Differences over three voxels: shorter ones would show the video's noise.
    float reach = 3.0 * frame_height / (float(textureSize(brick, 0).y) * brick_scale.y);
    vec3 gradient = vec3(scalar_at(local + vec3(reach, 0.0, 0.0)) - scalar_at(local - vec3(reach, 0.0, 0.0)),
                         scalar_at(local + vec3(0.0, reach, 0.0)) - scalar_at(local - vec3(0.0, reach, 0.0)),
                         scalar_at(local + vec3(0.0, 0.0, reach)) - scalar_at(local - vec3(0.0, 0.0, reach)));
    float steep = length(gradient);
    vec3 normal = -gradient / max(steep, 1e-4);
    float surface = clamp(steep * 3.0, 0.0, 1.0);
    float lit = 0.5 + 0.9 * clamp(0.5 + 0.5 * dot(normal, normalize(light)), 0.0, 1.0);
    float grazed = smoothstep(0.55, 1.0, 1.0 - abs(dot(normal, normalize(view))));
    return colour * mix(1.0, lit * (1.0 - 0.45 * grazed), surface);
}
