// What a slice's vertices give its fragments. Who follows a ray instead has variables of these names.
in vec3 local;  // the position, of local_from_p
in float t_near;
in vec3 ray;    // from one slice to the next at spacing 1
in vec3 light;  // directions to the light and along the ray, in the coordinates of `local`
in vec3 view;
