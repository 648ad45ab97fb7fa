// No background: black.
vec3 backgroundAt(vec3 direction) { return vec3(0.0); }
