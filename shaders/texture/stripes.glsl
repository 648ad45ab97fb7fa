// Two colours by the parity of the whole part of s.
vec3 stripesTexture(TextureRecord t, vec2 st) {
  const float whole = trunc(st.x);
  return whole == 2.0 * trunc(0.5 * whole) ? t.color1 : t.color2;
}
