#include "image/flip.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/glm.hpp>
#include <numbers>

#include "core/error.h"
#include "core/parallel.h"

namespace laver {
namespace {

using glm::dmat3;
using glm::dvec3;

// A viewing distance of 0.7 m of a screen 0.7 m and 3840 pixels wide.
constexpr double kPixelsPerDegree = 0.7 * 3840.0 / 0.7 * std::numbers::pi / 180.0;

// Columns of linear sRGB in XYZ, and the white point D65.
const dmat3 kToXyz =
    glm::transpose(dmat3(10135552.0 / 24577794.0, 8788810.0 / 24577794.0, 4435075.0 / 24577794.0,
                         2613072.0 / 12288897.0, 8788810.0 / 12288897.0, 887015.0 / 12288897.0,
                         1425312.0 / 73733382.0, 8788810.0 / 73733382.0, 70074185.0 / 73733382.0));
const dmat3 kFromXyz = glm::inverse(kToXyz);
const dvec3 kWhite = kToXyz * dvec3(1.0);

/// A picture of three numbers a pixel.
struct Planes {
  int width = 0, height = 0;
  std::vector<dvec3> pixels;

  std::size_t at(int x, int y) const {
    return static_cast<std::size_t>(std::clamp(y, 0, height - 1)) *
               static_cast<std::size_t>(width) +
           static_cast<std::size_t>(std::clamp(x, 0, width - 1));
  }
};

Planes mapped(Planes planes, const std::function<dvec3(dvec3)>& map) {
  parallelFor(planes.pixels.size(), 4096, 0, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) planes.pixels[i] = map(planes.pixels[i]);
  });
  return planes;
}

/// Opponent colours, linear in XYZ: luminance, red to green, blue to yellow.
dvec3 toOpponent(dvec3 rgb) {
  const dvec3 p = kToXyz * rgb / kWhite;
  return {116.0 * p.y - 16.0, 500.0 * (p.x - p.y), 200.0 * (p.y - p.z)};
}

dvec3 fromOpponent(dvec3 c) {
  const double y = (c.x + 16.0) / 116.0;
  return kFromXyz * (dvec3(y + c.y / 500.0, y, y - c.z / 200.0) * kWhite);
}

/// CIELAB, with chroma that grows with the luminance (Hunt, "Light and Dark Adaptation and the
/// Perception of Color", 1952).
dvec3 toHuntLab(dvec3 rgb) {
  constexpr double delta = 6.0 / 29.0;
  const auto f = [](double t) {
    return t > delta * delta * delta ? std::cbrt(t) : t / (3.0 * delta * delta) + 4.0 / 29.0;
  };
  const dvec3 p = kToXyz * rgb / kWhite;
  const double lightness = 116.0 * f(p.y) - 16.0;
  return {lightness, 0.01 * lightness * 500.0 * (f(p.x) - f(p.y)),
          0.01 * lightness * 200.0 * (f(p.y) - f(p.z))};
}

/// Distance for large colour differences (Abasi et al., "Distance Metrics for Very Large Color
/// Differences", 2020), to the power of 0.7.
double colourDistance(dvec3 a, dvec3 b) {
  return std::pow(std::abs(a.x - b.x) + std::hypot(a.y - b.y, a.z - b.z), 0.7);
}

/// Numbers from -radius to radius.
std::vector<double> kernelOf(int radius, const std::function<double(double)>& value) {
  std::vector<double> kernel;
  for (int i = -radius; i <= radius; ++i) kernel.push_back(value(i));
  return kernel;
}

/// Positive numbers scaled to a sum of 1, negative ones to one of -1.
std::vector<double> balanced(std::vector<double> kernel) {
  double positive = 0.0, negative = 0.0;
  for (const double k : kernel) (k > 0.0 ? positive : negative) += std::abs(k);
  for (double& k : kernel) k /= k > 0.0 ? positive : negative;
  return kernel;
}

/// One kernel for each number of a pixel.
using Kernels = std::array<std::vector<double>, 3>;

/// A convolution along rows (dx = 1) or columns (dy = 1); the border's pixels go on beyond it.
Planes convolved(const Planes& in, const Kernels& kernels, int dx, int dy) {
  Planes out = in;
  const int radius = static_cast<int>(kernels[0].size() / 2);
  parallelFor(static_cast<std::size_t>(in.height), 4, 0, [&](std::size_t begin, std::size_t end) {
    for (int y = static_cast<int>(begin); y < static_cast<int>(end); ++y)
      for (int x = 0; x < in.width; ++x) {
        dvec3 sum(0.0);
        for (int i = -radius; i <= radius; ++i) {
          const auto k = static_cast<std::size_t>(i + radius);
          sum += dvec3(kernels[0][k], kernels[1][k], kernels[2][k]) *
                 in.pixels[in.at(x + i * dx, y + i * dy)];
        }
        out.pixels[out.at(x, y)] = sum;
      }
  });
  return out;
}

/// What the eye resolves of opponent colours: contrast sensitivity as sums of Gaussians.
Planes filtered(const Planes& opponent) {
  struct Lobe {
    double a, b;
  };
  // The third colour has two lobes; the sum of both in two dimensions is normalised.
  constexpr Lobe luminance{1.0, 0.0047}, redGreen{1.0, 0.0053}, wide{34.1, 0.04},
      narrow{13.5, 0.025};
  const double pi = std::numbers::pi;
  const int radius =
      static_cast<int>(std::ceil(3.0 * std::sqrt(wide.b / (2.0 * pi * pi)) * kPixelsPerDegree));
  const auto lobe = [&](Lobe l) {
    return kernelOf(radius, [=](double x) {
      const double d = x / kPixelsPerDegree;
      return std::sqrt(l.a * std::sqrt(pi / l.b)) * std::exp(-pi * pi * d * d / l.b);
    });
  };
  const auto sumOf = [](const std::vector<double>& kernel) {
    double sum = 0.0;
    for (const double k : kernel) sum += k;
    return sum;
  };
  const auto over = [](std::vector<double> kernel, double divisor) {
    for (double& k : kernel) k /= divisor;
    return kernel;
  };
  const std::vector<double> first = lobe(luminance), second = lobe(redGreen), third = lobe(wide),
                            fourth = lobe(narrow);
  const double both = std::hypot(sumOf(third), sumOf(fourth));
  const Kernels one = {over(first, sumOf(first)), over(second, sumOf(second)), over(third, both)};
  const Kernels other = {one[0], one[1], over(fourth, both)};
  Planes result = convolved(convolved(opponent, one, 1, 0), one, 0, 1);
  const Planes more = convolved(convolved(opponent, other, 1, 0), other, 0, 1);
  for (std::size_t i = 0; i < result.pixels.size(); ++i) result.pixels[i].z += more.pixels[i].z;
  return result;
}

/// Strength of edges (x) and of points (y) in the luminance.
Planes features(const Planes& opponent) {
  const double deviation = 0.5 * 0.082 * kPixelsPerDegree;
  const int radius = static_cast<int>(std::ceil(3.0 * deviation));
  const auto gauss = [=](double x) { return std::exp(-x * x / (2.0 * deviation * deviation)); };
  const std::vector<double> smooth = balanced(kernelOf(radius, gauss));
  const std::vector<double> slope =
      balanced(kernelOf(radius, [=](double x) { return -x * gauss(x); }));
  const std::vector<double> bend = balanced(kernelOf(
      radius, [=](double x) { return (x * x / (deviation * deviation) - 1.0) * gauss(x); }));
  const Planes luminance = mapped(opponent, [](dvec3 c) { return dvec3((c.x + 16.0) / 116.0); });
  const Kernels derivatives = {slope, bend, smooth}, blur = {smooth, smooth, smooth};
  const Planes alongX = convolved(convolved(luminance, derivatives, 1, 0), blur, 0, 1);
  Planes result = convolved(convolved(luminance, blur, 1, 0), derivatives, 0, 1);
  for (std::size_t i = 0; i < result.pixels.size(); ++i) {
    const dvec3 x = alongX.pixels[i];
    dvec3& y = result.pixels[i];
    y = {std::hypot(x.x, y.x), std::hypot(x.y, y.y), 0.0};
  }
  return result;
}

/// The largest colour distance on a screen, between green and blue.
double largestDistance() {
  return colourDistance(toHuntLab({0.0, 1.0, 0.0}), toHuntLab({0.0, 0.0, 1.0}));
}

/// The distance's 0.4 of the largest takes 0.95 of the range.
double redistributed(double distance, double largest) {
  constexpr double share = 0.4, range = 0.95;
  const double knee = share * largest;
  if (distance < knee) return range / knee * distance;
  return range + (distance - knee) / (largest - knee) * (1.0 - range);
}

/// FLIP of pictures in [0, 1].
std::vector<double> flipOf(const Planes& a, const Planes& b) {
  const Planes opponentA = mapped(a, toOpponent), opponentB = mapped(b, toOpponent);
  const auto seen = [](const Planes& opponent) {
    return mapped(filtered(opponent), [](dvec3 c) {
      return toHuntLab(glm::clamp(fromOpponent(c), dvec3(0.0), dvec3(1.0)));
    });
  };
  const Planes seenA = seen(opponentA), seenB = seen(opponentB);
  const Planes featuresA = features(opponentA), featuresB = features(opponentB);
  const double largest = largestDistance();
  std::vector<double> values(a.pixels.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double colour = redistributed(colourDistance(seenA.pixels[i], seenB.pixels[i]), largest);
    const dvec3 feature = glm::abs(featuresA.pixels[i] - featuresB.pixels[i]);
    const double strength = std::sqrt(std::max(feature.x, feature.y) / std::numbers::sqrt2);
    values[i] = std::pow(colour, 1.0 - strength);
  }
  return values;
}

bool isFinite(dvec3 v) { return std::isfinite(v.x + v.y + v.z); }

/// R, G and B.
Planes planesOf(const Image& image) {
  std::array<std::size_t, 3> places{};
  for (std::size_t c = 0; c < 3; ++c) {
    const auto found =
        std::find(image.channels.begin(), image.channels.end(), std::string(1, "RGB"[c]));
    if (found == image.channels.end())
      throw Error(ExitCode::Usage, "FLIP compares the channels R, G and B; one is missing");
    places[c] = static_cast<std::size_t>(found - image.channels.begin());
  }
  Planes planes{image.width, image.height, {}};
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      planes.pixels.emplace_back(image.at(x, y, places[0]), image.at(x, y, places[1]),
                                 image.at(x, y, places[2]));
  return planes;
}

/// Calls flip() for both pictures without what is not finite, where it sets 1.
std::vector<double> ofFinite(const Image& first, const Image& second,
                             const std::function<std::vector<double>(Planes, Planes)>& flip) {
  if (first.width != second.width || first.height != second.height)
    throw Error(ExitCode::Usage, "the pictures differ in size");
  const Planes a = planesOf(first), b = planesOf(second);
  const auto finite = [](dvec3 v) { return isFinite(v) ? v : dvec3(0.0); };
  std::vector<double> values = flip(mapped(a, finite), mapped(b, finite));
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!isFinite(a.pixels[i]) || !isFinite(b.pixels[i])) values[i] = 1.0;
  return values;
}

dvec3 clamped(dvec3 v) { return glm::clamp(v, dvec3(0.0), dvec3(1.0)); }

// The ACES tone mapper (Narkowicz, "ACES Filmic Tone Mapping Curve", 2015) with 0.6 of the
// exposure: (x (p x + q)) / (x (r x + s) + t).
constexpr double kP = 0.36 * 2.51, kQ = 0.6 * 0.03, kR = 0.36 * 2.43, kS = 0.6 * 0.59, kT = 0.14;

dvec3 toneMapped(dvec3 x) { return clamped(x * (kP * x + kQ) / (x * (kR * x + kS) + kT)); }

/// The first and the last exposure, in powers of 2: the brightest luminance, and the median, come
/// to 0.85.
std::pair<double, double> exposuresOf(const Planes& reference) {
  std::vector<double> luminances;
  for (const dvec3& rgb : reference.pixels)
    luminances.push_back(glm::dot(glm::transpose(kToXyz)[1], rgb));
  std::sort(luminances.begin(), luminances.end());
  const double median = luminances[luminances.size() / 2];  // the upper one, as in their program
  constexpr double tiny = 1e-5;
  // 0.85 = (p x^2 + q x) / (r x^2 + s x + t).
  const double a = kP - 0.85 * kR, b = kQ - 0.85 * kS, c = -0.85 * kT;
  const double half = -0.5 * b / a;
  const double x = half + std::sqrt(half * half - c / a);
  return {std::log2(x / std::max(luminances.back(), tiny)), std::log2(x / std::max(median, tiny))};
}

}  // namespace

std::vector<double> ldrFlip(const Image& a, const Image& reference) {
  return ofFinite(a, reference, [](const Planes& first, const Planes& second) {
    return flipOf(mapped(first, clamped), mapped(second, clamped));
  });
}

std::vector<double> hdrFlip(const Image& a, const Image& reference) {
  return ofFinite(a, reference, [](const Planes& first, const Planes& second) {
    const auto [start, stop] = exposuresOf(second);
    const int count = std::max(2, static_cast<int>(std::ceil(stop - start)));
    std::vector<double> largest(first.pixels.size());
    for (int i = 0; i < count; ++i) {
      const double scale = std::exp2(start + i * (stop - start) / (count - 1));
      const auto expose = [=](dvec3 v) { return toneMapped(v * scale); };
      const std::vector<double> values = flipOf(mapped(first, expose), mapped(second, expose));
      for (std::size_t k = 0; k < largest.size(); ++k) largest[k] = std::max(largest[k], values[k]);
    }
    return largest;
  });
}

}  // namespace laver
