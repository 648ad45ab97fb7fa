// What the device's sampling routines draw, against exact probabilities and solid angles:
// integrators of the test show the numbers themselves, one sample a pixel. A test has some hundred
// cells at most, and a bound of 4.9 standard deviations, which a right routine exceeds in a cell
// with a probability of 1e-6.
#include <boost/math/constants/constants.hpp>
#include <functional>
#include <glm/glm.hpp>

#include "image/io.h"
#include "lab/hypothesis/statistics.h"
#include "pictures/command_line.h"

namespace laver::test {
namespace {

constexpr double kPi = boost::math::constants::pi<double>();
constexpr int kSide = 512;
constexpr double kSamples = kSide * kSide;
constexpr double kDeviates = 4.9;
/// Of a chi-squared test. Seeds are fixed: a right routine passes on every run, or on none.
constexpr double kLevel = 1e-4;

/// Values may not be negative: they are shown with 2 added.
std::string integratorOf(const std::string& includes, const std::string& value) {
  return includes +
         "void integrate(Rays rays, Hits hits, inout vec3 radiance[R]) {\n"
         "  FOR_RAYS (uint r = 0u; r < R; ++r) {\n    " +
         value + "\n  }\n}\n";
}

std::string lightSample(const std::string& shown) {
  return integratorOf(
      "#include \"emitter/sources.glsl\"\n",
      "Surface s;\n"
      "    s.position = rays.origin[r];\n"
      "    s.geometric = s.normal = vec3(0.0, 0.0, 1.0);\n"
      "    const SourceSample light = sampleSources(s, randomPair(r, 2u).x, randomPair(r, 3u));\n"
      "    radiance[r] = " +
          shown + ";");
}

struct LightDrawn {
  glm::dvec3 direction;
  double density;
};

/// A part of all directions, and its solid angle.
struct Cell {
  std::function<bool(const glm::dvec3&)> has;
  double solidAngle;
};

class SamplingRoutines : public CommandLine {
 protected:
  SamplingRoutines() { write("away.obj", "v 0 0 -1\nv 0.1 0 -1\nv 0 0.1 -1\nf 1 2 3\n"); }

  /// The values that an integrator shows, less `offset`; the camera is in the origin.
  std::vector<glm::dvec3> shown(const std::string& integrator, const std::string& objects,
                                double offset, const std::string& camera = "perspective") {
    write("shown.glsl", integrator);
    write("s.xml",
          "<scene><integrator type=\"shown\"/><sampler type=\"independent\"/>"
          "<mesh type=\"obj\"><string name=\"filename\" value=\"away.obj\"/></mesh>" +
              objects + "<camera type=\"" + camera +
              "\"><rfilter type=\"box\"/><float name=\"fov\" value=\"1\"/>" +
              (camera == "thinlens" ? "<float name=\"aperture_radius\" value=\"0.25\"/>"
                                      "<float name=\"focus_distance\" value=\"2\"/>"
                                    : "") +
              "<transform name=\"toWorld\"><lookat origin=\"0,0,0\" target=\"0.3,0.2,-1\" "
              "up=\"0,1,0\"/></transform></camera></scene>");
    const Outcome run = laver("s.xml --device $device --dialect base -q --spp 1 --size " +
                              std::to_string(kSide) + "x" + std::to_string(kSide) + " -o a.exr");
    EXPECT_EQ(run.code, 0) << run.err;
    std::vector<glm::dvec3> values;
    if (run.code != 0) return values;
    const Image image = readExr((folder_ / "a.exr").string());
    for (int y = 0; y < kSide; ++y)
      for (int x = 0; x < kSide; ++x)
        values.push_back(glm::dvec3(image.at(x, y, 0), image.at(x, y, 1), image.at(x, y, 2)) -
                         offset);
    return values;
  }

  std::vector<LightDrawn> lightsDrawn(const std::string& objects) {
    const auto directions = shown(lightSample("light.direction + 2.0"), objects, 2.0);
    const auto densities = shown(lightSample("vec3(light.density)"), objects, 0.0);
    std::vector<LightDrawn> drawn;
    for (std::size_t i = 0; i < directions.size(); ++i)
      drawn.push_back({directions[i], densities[i].x});
    return drawn;
  }
};

/// 1 of values that are the mean of two samples: a sample on the border of two pixels, where its
/// float was rounded to it, shows in both.
double isMixed(const glm::dvec3& direction) {
  return std::abs(glm::length(direction) - 1.0) < 1e-6 ? 0.0 : 1.0;
}
constexpr double kMixed = 1e-3 * kSamples;

void expectMean(const Moments& moments, double wanted) {
  const double deviation = std::sqrt(moments.variance() / kSamples);
  EXPECT_LT(deviation, 0.2 * wanted) << "a cell that tells nothing";
  // 2^-20: where the variance is that of rounding.
  EXPECT_LT(std::abs(moments.mean() - wanted), kDeviates * deviation + 0x1p-20 * wanted)
      << moments.mean() << ", not " << wanted;
}

/// The mean of 1 / density over the samples in a cell is the cell's solid angle, if samples have
/// that density and reach all of the cell. The cells are all that samples reach.
void expectSolidAngles(const std::vector<LightDrawn>& drawn, const std::vector<Cell>& cells) {
  ASSERT_EQ(static_cast<double>(drawn.size()), kSamples);
  std::vector<Moments> means(cells.size());
  Moments mean;
  double mixed = 0.0, whole = 0.0;
  for (const LightDrawn& light : drawn) {
    EXPECT_TRUE(light.density >= 0.0 && std::isfinite(light.density));
    mixed += isMixed(light.direction);
    mean.add(light.density > 0.0 ? 1.0 / light.density : 0.0);
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const bool has = light.density > 0.0 && cells[i].has(light.direction);
      means[i].add(has ? 1.0 / light.density : 0.0);
    }
  }
  EXPECT_LE(mixed, kMixed);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    SCOPED_TRACE(i);
    expectMean(means[i], cells[i].solidAngle);
    whole += cells[i].solidAngle;
  }
  expectMean(mean, whole);
}

/// Of a triangle seen from the origin (Van Oosterom and Strackee, "The Solid Angle of a Plane
/// Triangle", 1983).
Cell triangleCell(glm::dvec3 a, glm::dvec3 b, glm::dvec3 c) {
  a = glm::normalize(a), b = glm::normalize(b), c = glm::normalize(c);
  const double volume = glm::dot(a, glm::cross(b, c));
  const double side = std::copysign(1.0, volume);
  const auto has = [=](const glm::dvec3& d) {
    return side * glm::dot(d, glm::cross(a, b)) > 0.0 &&
           side * glm::dot(d, glm::cross(b, c)) > 0.0 && side * glm::dot(d, glm::cross(c, a)) > 0.0;
  };
  return {has, 2.0 * std::atan2(std::abs(volume),
                                1.0 + glm::dot(a, b) + glm::dot(b, c) + glm::dot(c, a))};
}

/// The four parts of a triangle between the middles of its edges.
void addParts(glm::dvec3 a, glm::dvec3 b, glm::dvec3 c, std::vector<Cell>& cells) {
  const glm::dvec3 ab = 0.5 * (a + b), bc = 0.5 * (b + c), ca = 0.5 * (c + a);
  cells.push_back(triangleCell(a, ab, ca));
  cells.push_back(triangleCell(ab, b, bc));
  cells.push_back(triangleCell(ca, bc, c));
  cells.push_back(triangleCell(ab, bc, ca));
}

/// Cosine with an axis and turn around it, in [0, 1).
glm::dvec2 heightAndTurn(const glm::dvec3& axis, const glm::dvec3& d) {
  const glm::dvec3 other = std::abs(axis.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  const glm::dvec3 x = glm::normalize(glm::cross(axis, other)), y = glm::cross(axis, x);
  const double turn = std::atan2(glm::dot(d, y), glm::dot(d, x)) / (2.0 * kPi);
  return {glm::dot(d, axis), turn < 0.0 ? turn + 1.0 : turn};
}

/// Cells of equal solid angle, in rows between cosines `low` and 1 with an axis.
std::vector<Cell> capCells(const glm::dvec3& axis, double low, int rows, int columns) {
  std::vector<Cell> cells;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column)
      cells.push_back({[=](const glm::dvec3& d) {
                         const glm::dvec2 at = heightAndTurn(axis, d);
                         const double height = (at.x - low) / (1.0 - low) * rows;
                         return std::floor(height) == row && std::floor(at.y * columns) == column;
                       },
                       2.0 * kPi * (1.0 - low) / rows / columns});
  return cells;
}

/// Counts of points of the unit square in 16 x 16 equal cells.
void expectUniform(const std::vector<glm::dvec2>& points) {
  constexpr int kCells = 16;
  std::vector<double> counts(kCells * kCells);
  for (const glm::dvec2& p : points) {
    ASSERT_TRUE(p.x >= 0.0 && p.x <= 1.0 && p.y >= 0.0 && p.y <= 1.0) << p.x << ' ' << p.y;
    const auto cell = [](double x) { return std::min(static_cast<int>(x * kCells), kCells - 1); };
    counts[static_cast<std::size_t>(cell(p.y) * kCells + cell(p.x))] += 1.0;
  }
  const std::vector<double> expected(counts.size(), kSamples / (kCells * kCells));
  EXPECT_GT(chiSquaredTest(counts, expected, 5.0).p, kLevel);
}

std::string areaLight(const std::string& radiance) {
  return "<emitter type=\"area\"><color name=\"radiance\" value=\"" + radiance + "\"/></emitter>";
}

TEST_F(SamplingRoutines, PointsOfTrianglesAndSpheresHaveTheirDensity) {
  // Of unequal areas and distances, facing the origin.
  const std::vector<glm::dvec3> p = {{-1, -1, 2}, {2, -1, 2}, {-1, 2, 2.5}, {2, 3, 1}};
  write("l.obj", "v -1 -1 2\nv 2 -1 2\nv -1 2 2.5\nv 2 3 1\nf 1 3 2\nf 2 3 4\n");
  const std::string objects =
      "<mesh type=\"obj\"><string name=\"filename\" value=\"l.obj\"/>" + areaLight("1 2 3") +
      "</mesh><mesh type=\"sphere\"><point name=\"center\" value=\"-3,0,0.5\"/>"
      "<float name=\"radius\" value=\"1\"/>" +
      areaLight("3 3 1") + "</mesh>";
  std::vector<Cell> cells;
  addParts(p[0], p[2], p[1], cells);
  addParts(p[1], p[2], p[3], cells);
  const glm::dvec3 centre(-3.0, 0.0, 0.5);
  for (const Cell& cell :
       capCells(glm::normalize(centre), std::sqrt(1.0 - 1.0 / glm::dot(centre, centre)), 2, 4))
    cells.push_back(cell);
  expectSolidAngles(lightsDrawn(objects), cells);
}

TEST_F(SamplingRoutines, DirectionsToAConstantBackgroundHaveTheirDensity) {
  const auto drawn = lightsDrawn("<emitter type=\"constant\"/>");
  expectSolidAngles(drawn, capCells(glm::normalize(glm::dvec3(1, 2, 3)), -1.0, 8, 8));
}

TEST_F(SamplingRoutines, DirectionsToADistantDiskHaveTheirDensity) {
  const auto drawn = lightsDrawn(
      "<emitter type=\"distantdisk\"><color name=\"radiance\" value=\"1 1 1\"/>"
      "<float name=\"thetaA\" value=\"40\"/><transform name=\"toWorld\">"
      "<rotate axis=\"1,0,0\" angle=\"-90\"/></transform></emitter>");
  expectSolidAngles(drawn, capCells({0.0, 1.0, 0.0}, std::cos(glm::radians(40.0)), 4, 8));
}

TEST_F(SamplingRoutines, DirectionsToAnImageHaveTheirDensity) {
  Image image = rgbImage(8, 4);
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 8; ++x)
      for (std::size_t c = 0; c < 3; ++c)
        image.pixels[static_cast<std::size_t>(y * 8 + x) * 3 + c] =
            static_cast<float>(1 + (x * 5 + y * 3 + static_cast<int>(c)) % 7);
  writeExr((folder_ / "sky.exr").string(), image);
  for (const char* turned :
       {"", "<scale value=\"1,2,0.7\"/><rotate axis=\"1,2,3\" angle=\"50\"/>"}) {
    SCOPED_TRACE(turned);
    const auto drawn = lightsDrawn(
        std::string("<emitter type=\"envmap\"><string name=\"filename\" value=\"sky.exr\"/>"
                    "<transform name=\"toWorld\">") +
        turned + "</transform></emitter>");
    expectSolidAngles(drawn, capCells(glm::normalize(glm::dvec3(2, -1, 1)), -1.0, 8, 8));
  }
}

TEST_F(SamplingRoutines, PointLightsAreDrawnByTheirPower) {
  std::string objects;
  const std::vector<glm::dvec3> axes = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (const auto& [position, power] : {std::pair{"2,0,0", "1"}, {"0,3,0", "2"}, {"0,0,1", "5"}})
    objects += std::string("<emitter type=\"point\"><point name=\"position\" value=\"") + position +
               "\"/><color name=\"power\" value=\"" + power + " " + power + " " + power +
               "\"/></emitter>";
  std::vector<double> counts(3);
  for (const LightDrawn& light : lightsDrawn(objects)) {
    EXPECT_EQ(light.density, 0.0);
    for (std::size_t i = 0; i < 3; ++i)
      counts[i] += glm::dot(light.direction, axes[i]) > 0.999 ? 1.0 : 0.0;
  }
  const std::vector<double> expected = {kSamples / 8.0, kSamples / 4.0, kSamples * 5.0 / 8.0};
  EXPECT_GT(chiSquaredTest(counts, expected, 5.0).p, kLevel);
}

TEST_F(SamplingRoutines, DirectionsOfTheHemisphereAreUniformOrByTheirCosine) {
  const glm::dvec3 normal = glm::normalize(glm::dvec3(0.6, -0.3, -0.4));
  for (const bool cosine : {false, true}) {
    const std::string name = cosine ? "cosineDirection" : "uniformDirection";
    SCOPED_TRACE(name);
    std::vector<glm::dvec2> points;
    double mixed = 0.0;
    for (const glm::dvec3& d :
         shown(integratorOf("#include \"shared/direction.h\"\n",
                            "radiance[r] = 2.0 + " + name +
                                "(normalize(vec3(0.6, -0.3, -0.4)), randomPair(r, 2u));"),
               "", 2.0)) {
      mixed += isMixed(d);
      const glm::dvec2 at = heightAndTurn(normal, d);
      const double height = glm::clamp(at.x, 0.0, 1.0);
      EXPECT_GE(at.x, -1e-6);
      points.emplace_back(cosine ? height * height : height, at.y);
    }
    EXPECT_LE(mixed, kMixed);
    expectUniform(points);
  }
}

TEST_F(SamplingRoutines, PointsOfTheLensAreUniform) {
  std::vector<glm::dvec2> points;
  for (const glm::dvec3& p :
       shown(integratorOf("",
                          "const vec3 p = lensPoint(randomPair(r, 1u));\n"
                          "    radiance[r] = 2.0 + vec3(dot(p, params.lensX) / dot(params.lensX, "
                          "params.lensX),\n"
                          "        dot(p, params.lensY) / dot(params.lensY, params.lensY), 0.0);"),
             "", 2.0, "thinlens")) {
    const double turn = std::atan2(p.y, p.x) / (2.0 * kPi);
    points.emplace_back(std::min(p.x * p.x + p.y * p.y, 1.0), turn < 0.0 ? turn + 1.0 : turn);
    EXPECT_LT(glm::length(p), 1.0 + 1e-5);
  }
  expectUniform(points);
}

TEST_F(SamplingRoutines, PairsOfEachDimensionAreUniform) {
  for (const unsigned dimension : {0U, 1U, 2U, 7U}) {
    SCOPED_TRACE(dimension);
    std::vector<glm::dvec2> points;
    for (const glm::dvec3& pair :
         shown(integratorOf("", "radiance[r] = vec3(randomPair(r, " + std::to_string(dimension) +
                                    "u), 0.0);"),
               "", 0.0))
      points.emplace_back(pair);
    expectUniform(points);
  }
}

}  // namespace
}  // namespace laver::test
