// A background of one radiance.
vec3 backgroundAt(vec3 direction) { return params.backgroundRadiance; }
