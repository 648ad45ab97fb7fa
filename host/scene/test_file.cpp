#include "scene/test_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "core/error.h"
#include "scene/node.h"
#include "scene/numbers.h"
#include "scene/reader.h"
#include "scene/suggest.h"

namespace laver {
namespace {

using xml::Diagnostics;
using xml::TextSource;

constexpr std::uint32_t kSamples = 100'000;         // of a t-test
constexpr std::uint32_t kSamplesPerCell = 5000;     // of a chi-squared test
constexpr std::int64_t kMostSamples = 100'000'000;  // 5 GB of answers
constexpr std::int64_t kMostCells = 1000;           // of cos(theta)

/// Reads a file's tags into a TestFile.
class TestReader {
 public:
  TestReader(const TextSource& source, const SceneOverrides& overrides, Diagnostics& diagnostics)
      : source_(source), overrides_(overrides), diagnostics_(diagnostics) {}

  TestFile read(pugi::xml_node root) {
    readType(root);
    for (const pugi::xml_node child : root.children()) {
      const std::string_view tag = child.name();
      if (tag == "string" || tag == "float" || tag == "integer")
        readProperty(child);
      else if (tag == "scene")
        readScene(child);
      else if (tag != "bsdf" && tag != "emitter")
        error(child,
              fmt::format("<{}> in <test>: expected <bsdf>, <emitter>, <scene> or a property",
                          child.name()));
    }
    readParts(root);
    check(root);
    return std::move(test_);
  }

 private:
  void error(pugi::xml_node node, const std::string& message) {
    diagnostics_.error(offsetOf(node, source_), message);
  }

  void readType(pugi::xml_node root) {
    const std::string_view type = root.attribute("type").value();
    if (type == "chi2test")
      test_.kind = TestFile::Kind::ChiSquared;
    else if (type != "ttest")
      error(root, fmt::format("the type of a test is {}, expected \"ttest\" or \"chi2test\"",
                              xml::inQuotes(type)));
  }

  void readProperty(pugi::xml_node node) {
    const std::string_view name = node.attribute("name").value();
    const std::string_view value = node.attribute("value").value();
    if (name == "references") {
      readList(node, value, test_.references);
    } else if (name == "angles") {
      readList(node, value, test_.angles);
    } else if (name == "distances") {
      readList(node, value, test_.distances);
    } else if (name == "significanceLevel") {
      const auto level = parseReal(value);
      if (!level || !(level.value > 0.0) || !(level.value < 1.0))
        error(node, "significanceLevel must be more than 0 and less than 1, found " +
                        xml::inQuotes(value));
      test_.significanceLevel = level.value;
    } else if (name == "sampleCount") {
      readCount(node, value, kMostSamples, test_.sampleCount);
    } else if (name == "resolution") {
      readCount(node, value, kMostCells, test_.resolution);
    } else if (name == "minExpFrequency") {
      readCount(node, value, kMostSamples, test_.minExpFrequency);
    } else if (name == "testCount") {
      readCount(node, value, kMostCells, test_.testCount);
    } else {
      diagnostics_.warning(
          offsetOf(node, source_),
          fmt::format(
              "<test> has no property {}: ignored; it takes references, angles, "
              "distances, sampleCount, significanceLevel, resolution, minExpFrequency, testCount",
              xml::inQuotes(name)));
    }
  }

  void readList(pugi::xml_node node, std::string_view text, std::vector<double>& list) {
    for (const std::string_view piece : splitList(text)) {
      const auto number = parseReal(piece);
      if (!number)
        error(node, fmt::format("{} {}, expected a list of numbers", xml::inQuotes(piece),
                                number.problem));
      list.push_back(number.value);
    }
  }

  /// A count of -1 stands for the default.
  void readCount(pugi::xml_node node, std::string_view text, std::int64_t most,
                 std::uint32_t& count) {
    const auto number = parseInteger(text);
    if (number && number.value == -1) return;
    if (!number || number.value < 1 || number.value > most)
      error(node, fmt::format("{} must be 1 to {}, found {}", node.attribute("name").value(), most,
                              xml::inQuotes(text)));
    count = static_cast<std::uint32_t>(number.value);
  }

  void readScene(pugi::xml_node node) {
    xml::Draft draft{.overrides = overrides_, .scene = {}, .meshes = {}, .meshLights = {}};
    draft.scene.file = source_.file();
    xml::Reader(source_, draft, diagnostics_).readScene(node);
    if (diagnostics_.errorCount() != 0) return;
    xml::loadFiles(source_, draft, diagnostics_);
    test_.scenes.push_back(std::move(draft.scene));
  }

  /// BSDFs are read as those of spheres in a scene, and emitters as those of that scene. Their tags
  /// are taken out of <test>.
  void readParts(pugi::xml_node root) {
    if (!root.child("bsdf") && !root.child("emitter")) return;
    pugi::xml_node scene = root.append_child("scene");
    scene.append_child("integrator").append_attribute("type") = "normals";
    while (const pugi::xml_node bsdf = root.child("bsdf")) {
      pugi::xml_node mesh = scene.append_child("mesh");
      mesh.append_attribute("type") = "sphere";
      mesh.append_move(bsdf);
    }
    std::size_t emitters = 0;
    for (pugi::xml_node emitter; (emitter = root.child("emitter")); ++emitters)
      scene.append_move(emitter);
    SceneOverrides overrides = overrides_;
    overrides.shading = true;
    overrides.integrator.reset();
    xml::Draft draft{.overrides = overrides, .scene = {}, .meshes = {}, .meshLights = {}};
    draft.scene.file = source_.file();
    xml::Reader(source_, draft, diagnostics_).readScene(scene);
    if (diagnostics_.errorCount() != 0) return;
    xml::loadFiles(source_, draft, diagnostics_);
    for (Mesh& mesh : draft.scene.meshes) test_.bsdfs.push_back(std::move(mesh.bsdf));
    test_.lights = std::move(draft.scene.lights);
    root.remove_child(scene);
    if (test_.lights.size() != emitters)
      error(root, "a background cannot be tested, expected emitters without extent");
  }

  void check(pugi::xml_node root) {
    if (diagnostics_.errorCount() != 0) return;
    const bool student = test_.kind == TestFile::Kind::Student;
    if (test_.sampleCount == 0)
      test_.sampleCount =
          student ? kSamples : 2 * test_.resolution * test_.resolution * kSamplesPerCell;
    const std::size_t bsdfs = test_.bsdfs.size(), scenes = test_.scenes.size(),
                      lights = test_.lights.size();
    if (int{bsdfs != 0} + int{scenes != 0} + int{lights != 0} > 1)
      return error(root, "a test of several kinds of things, expected one");
    if (!student && bsdfs == 0) return error(root, "a chi2test tests BSDFs, expected <bsdf>");
    if (bsdfs + scenes + lights == 0)
      return error(root, "nothing to test, expected <bsdf>, <emitter> or <scene>");
    if (!student) return;
    if (bsdfs != 0 && test_.angles.empty())
      return error(root, "a ttest of BSDFs needs the property \"angles\"");
    if (lights != 0 && test_.distances.empty())
      return error(root, "a ttest of emitters needs the property \"distances\"");
    // References may stand for each of several BSDFs.
    const std::size_t tests =
        scenes + bsdfs * test_.angles.size() + lights * test_.distances.size();
    const bool shared = bsdfs != 0 && test_.references.size() == test_.angles.size();
    for (std::size_t i = 1; shared && i < bsdfs; ++i)
      for (std::size_t k = 0; k < test_.angles.size(); ++k)
        test_.references.push_back(test_.references[k]);
    if (test_.references.size() != tests)
      error(root, fmt::format("{} reference values for {} tests", test_.references.size(), tests));
  }

  const TextSource& source_;
  const SceneOverrides& overrides_;
  Diagnostics& diagnostics_;
  TestFile test_;
};

}  // namespace

bool isTestFile(const std::string& file) {
  // A pipe can be read only once.
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) return false;
  pugi::xml_document document;
  document.load_file(file.c_str());  // on an error, what comes before it
  return std::string_view(document.document_element().name()) == "test";
}

TestFile loadTestFile(const std::string& file, const SceneOverrides& overrides) {
  const TextSource source = xml::sourceOf(file);
  Diagnostics diagnostics(source);
  pugi::xml_document document;
  const pugi::xml_node root = xml::parseDocument(source, document, diagnostics, "test");
  diagnostics.throwErrors();
  TestFile test = TestReader(source, overrides, diagnostics).read(root);
  diagnostics.throwErrors();
  test.warnings = diagnostics.warnings();
  return test;
}

}  // namespace laver
