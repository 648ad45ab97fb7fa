// One colour.
vec3 constantTexture(TextureRecord t, vec2 st) { return t.color1; }
