// Two colours by the parity of the unit squares of (s, t).

// 1 if floor(x) is odd, else 0.
float oddness(float x) {
  const float whole = floor(x);
  return whole - 2.0 * floor(0.5 * whole);
}

vec3 checkerTexture(TextureRecord t, vec2 st) {
  return oddness(st.x) == oddness(st.y) ? t.color1 : t.color2;
}
