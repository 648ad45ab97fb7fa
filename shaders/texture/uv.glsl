// The texture coordinates as red and green.
vec3 uvTexture(TextureRecord t, vec2 st) { return vec3(st, 0.0); }
