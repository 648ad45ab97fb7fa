// A repeated image times a colour.
vec3 bitmapTexture(TextureRecord t, vec2 st) {
  return t.color1 * imageAt(t.image, unitPart(st.x), 1.0 - unitPart(st.y), true);
}
