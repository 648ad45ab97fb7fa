// Paths from the camera. The including file says how light is found:
//   SAMPLES_SOURCES   at each vertex one light source is drawn
//   SAMPLES_BSDF      emission that directions drawn from the BSDF meet counts; with both, each is weighted by
//                     the balance heuristic (Veach and Guibas, "Optimally Combining Sampling Techniques for
//                     Monte Carlo Rendering", 1995)
//   SHOWS_EMISSION    emission that the camera sees counts
//   MAX_BOUNCES       surfaces that scatter, at most; 0: no maximum
//   ONLY_DISCRETE     only paths from discrete BSDFs, such as a mirror's, go on
// Light that only a discrete BSDF finds, and what the camera sees itself, has weight 1.
#include "emitter/sources.glsl"

// Vertices before Russian roulette.
const uint CERTAIN_BOUNCES = 3u;
const float MAX_SURVIVAL = 0.99;
// Of whitted.
const float WHITTED_SURVIVAL = 0.95;

// Random pairs of each bounce, after the film's and the aperture's: which source, and roulette; a point of
// it; a direction.
const uint BOUNCE_DIMENSIONS = 3u;

float survival(vec3 throughput, uint bounce) {
  if (ONLY_DISCRETE) return WHITTED_SURVIVAL;
  const float largest = greater(throughput.r, greater(throughput.g, throughput.b));
  return bounce < CERTAIN_BOUNCES ? 1.0 : lesser(largest, MAX_SURVIVAL);
}

// The weight of emission that a ray finds, by the densities per solid angle with which its direction was
// drawn, 0 for discrete ones, and with which light sampling would have drawn it.
float foundWeight(float density, float sampled) {
  if (density == 0.0 || !SAMPLES_SOURCES) return 1.0;
  return SAMPLES_BSDF ? density / (density + sampled) : 0.0;
}

void integrate(Rays rays, Hits hits, inout vec3 radiance[R]) {
  vec3 throughput[R];
  float density[R];
  bool counts[R];  // emission that is met
  FOR_RAYS (uint r = 0u; r < R; ++r) {
    throughput[r] = vec3(1.0);
    density[r] = 0.0;
    counts[r] = SHOWS_EMISSION;
  }
  uint bounce = 0u;
  bool goesOn = true;
  DO(goesOn) {
    Segments toSources;
    Rays next;
    vec3 arriving[R];
    goesOn = false;
    FOR_RAYS (uint r = 0u; r < R; ++r) {
      const bool hit = rays.isActive[r] && hits.slot[r] != NO_HIT;
      const vec3 direction = rays.direction[r];
      if (HAS_BACKGROUND) {
        if (rays.isActive[r] && !hit && counts[r])
          radiance[r] += throughput[r] * backgroundAt(direction) *
                         foundWeight(density[r], backgroundDensity(direction));
      }
      Surface s = surfaceFrom(rays.origin[r], direction, rays.tmin[r], hit ? hits.slot[r] : 0u);
      const Material m = materialOf(s);
      const vec3 wi = unitOr(-direction, s.normal);
      if (HAS_EMISSION) {
        if (hit && counts[r])
          radiance[r] += throughput[r] * emittedTowards(s, wi) *
                         foundWeight(density[r], sourceDensity(s, rays.origin[r], direction));
      }
      s.normal = bsdfNormal(s);
      const uint dimension = 2u + BOUNCE_DIMENSIONS * bounce;
      const vec2 choices = randomPair(r, dimension);
      bool scatters = hit && (MAX_BOUNCES == 0u || bounce < MAX_BOUNCES);

      arriving[r] = vec3(0.0);
      toSources.from[r] = s.position;
      toSources.direction[r] = s.normal;
      if (SAMPLES_SOURCES) {
        const SourceSample light = sampleSources(s, choices.x, randomPair(r, dimension + 1u));
        const float cosine = dotProduct(s.normal, light.direction);
        vec3 value = evalBsdf(m, s.normal, wi, light.direction, light.radiance * abs(cosine));
        if (SAMPLES_BSDF && light.density > 0.0)
          value *= light.density / (light.density + pdfBsdf(m, s.normal, wi, light.direction));
        arriving[r] = throughput[r] * value;
        toSources.from[r] = offsetOrigin(s, light.direction);
        toSources.direction[r] = light.end - toSources.from[r];
        if (HAS_FAR_PARTS) {
          if (isFarPoint(toSources.from[r], light.end)) {
            toSources.from[r] = light.end;
            toSources.direction[r] = -toSources.direction[r];
          }
        }
      }
      const bool apart = any(notEqual(toSources.direction[r], vec3(0.0)));
      if (!apart) toSources.direction[r] = s.normal;
      toSources.isActive[r] = scatters && apart && any(greaterThan(arriving[r], vec3(0.0)));

      vec3 wo;
      const vec3 weight = sampleBsdf(m, s.normal, wi, randomPair(r, dimension + 2u), wo);
      density[r] = pdfBsdf(m, s.normal, wi, wo);
      const bool discrete = density[r] == 0.0;
      const float chance = survival(throughput[r] * weight, bounce);
      scatters = scatters && (!ONLY_DISCRETE || discrete) && (SAMPLES_BSDF || MAX_BOUNCES != 1u) &&
                 choices.y < chance && any(greaterThan(weight, vec3(0.0)));
      counts[r] = SAMPLES_BSDF || discrete;
      throughput[r] *= weight / chance;
      next.origin[r] = offsetOrigin(s, wo);
      next.direction[r] = wo;
      next.tmin[r] = 0.0;
      next.tmax[r] = FAR_AWAY;
      next.isActive[r] = scatters;
      goesOn = goesOn || scatters;
    }
    if (SAMPLES_SOURCES) {
      bool clear[R];
      unoccluded(toSources, clear);
      FOR_RAYS (uint r = 0u; r < R; ++r) {
        if (clear[r]) radiance[r] += arriving[r];
      }
    }
    rays = next;
    goesOn = anyOfSubgroup(goesOn);
    if (goesOn) hits = closest(rays);
    ++bounce;
  } WHILE(goesOn);
}
