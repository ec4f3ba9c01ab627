vec3 shaded(vec3 colour) { return colour; }
