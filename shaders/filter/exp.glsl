// exp(x) for |x| <= 87 within 2 ulp; drivers' exp is off by up to 29. exp(x) = 2^n exp(r),
// |r| <= ln 2 / 2, where the Taylor polynomial of degree 7 is off by r^8 / 8! < 6e-9.
float expOf(float x) {
  precise float n = floor(x * 1.44269504 + 0.5);
  precise float r = (x - n * 0.693359375) + n * 2.12194440e-4;
  // Estrin's scheme, for short chains of dependent products.
  precise float r2 = r * r;
  precise float low = r * 0.5 + 1.0;
  precise float middle = (r * (1.0 / 24.0) + 1.0 / 6.0);
  precise float high = (r * (1.0 / 720.0) + 1.0 / 120.0) + r2 * (1.0 / 5040.0);
  precise float result = ((middle + r2 * high) * r2 * r + low * r) + 1.0;
  return result * uintBitsToFloat(uint(int(n) + 127) << 23);
}
