// A repeated image times a colour, not interpolated. t counts from its upper edge.
vec3 nearestTexture(TextureRecord t, vec2 st) {
  const vec2 size = vec2(t.image.width, t.image.height);
  const uvec2 pixel = uvec2(vec2(unitPart(st.x), unitPart(st.y)) * size);
  return t.color1 * pixelOf(t.image, min(pixel.x, t.image.width - 1u), min(pixel.y, t.image.height - 1u));
}
