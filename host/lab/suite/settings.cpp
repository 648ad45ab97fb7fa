#include "lab/suite/settings.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string_view>

#include "core/error.h"
#include "scene/diagnostics.h"
#include "scene/suggest.h"

namespace laver::suite {
namespace {

using nlohmann::json;

/// A key whose value becomes an option of a render.
struct Key {
  enum class Kind { Number, Text, Names, Flag };
  std::string_view name, option;
  Kind kind;
};

constexpr std::array kKeys = {
    Key{"samples", "--spp", Key::Kind::Number},
    Key{"seed", "--seed", Key::Kind::Number},
    Key{"size", "--size", Key::Kind::Text},
    Key{"crop", "--crop", Key::Kind::Text},
    Key{"integrator", "--integrator", Key::Kind::Names},
    Key{"sampler", "--sampler", Key::Kind::Text},
    Key{"filter", "--filter", Key::Kind::Text},
    Key{"layers", "--layers", Key::Kind::Names},
    Key{"error", "--error", Key::Kind::Number},
    Key{"dialect", "--dialect", Key::Kind::Text},
    Key{"noriCompat", "--nori-compat", Key::Kind::Flag},
};
constexpr std::string_view kMetric = "metric", kTolerance = "tolerance", kMaxShare = "maxShare",
                           kNoise = "noise", kSignificance = "significance", kPass = "pass";
constexpr std::string_view kLayers = "--layers=";

std::vector<std::string_view> allNames() {
  std::vector<std::string_view> names = {kMetric, kTolerance, kMaxShare, kSignificance, kPass};
  for (const Key& key : kKeys) names.push_back(key.name);
  return names;
}

/// A key of the file's object, and the byte offsets of its opening quote and of its value.
struct Place {
  std::string key;
  std::size_t keyAt, valueAt;
};

/// The place of a key whose closing quote is before `end`.
Place placeOf(const std::string& key, const std::string& text, std::size_t end) {
  const auto escaped = [&](std::size_t quote) {
    std::size_t first = quote;
    while (first > 0 && text[first - 1] == '\\') --first;
    return (quote - first) % 2 == 1;
  };
  std::size_t start = end - 1;
  do start = text.rfind('"', start - 1);
  while (escaped(start));
  return {key, start, text.find_first_not_of(" \t\r\n:", end)};
}

/// The reason alone, of "[json.exception...] parse error at line 1, column 2: reason".
std::string reasonOf(const json::parse_error& error) {
  const std::string text = error.what();
  const std::size_t column = text.find(", column ");
  const std::size_t at = column == std::string::npos ? column : text.find(": ", column);
  return at == std::string::npos ? text : text.substr(at + 2);
}

/// Reads one file.
class Reader {
 public:
  Reader(const xml::TextSource& source, const CheckOptions& check)
      : source_(source), check_(check), diagnostics_(source) {}

  Settings read() {
    const json all = parsed();
    std::set<std::string> seen;
    for (const Place& place : places_) {
      if (!seen.insert(place.key).second)
        diagnostics_.error(place.keyAt, fmt::format("{} is given twice", xml::inQuotes(place.key)));
      else
        take(place, all.at(place.key));
    }
    const auto metric = std::ranges::find(places_, kMetric, &Place::key);
    if (!noise_ && metric != places_.end() && !seen.contains(std::string(kTolerance)))
      diagnostics_.error(metric->keyAt, "a \"metric\" needs a \"tolerance\"");
    for (const Place& place : places_)
      if (belongsToNoise(place.key) ? !noise_ : noise_ && belongsToBound(place.key))
        diagnostics_.error(place.keyAt, fmt::format("\"{}\" is {} the metric \"noise\"", place.key,
                                                    noise_ ? "not for" : "for"));
    diagnostics_.throwErrors();
    if (noise_) {
      settings_.noise = limits_;
      renderVariances();
    }
    return settings_;
  }

 private:
  json parsed() {
    std::istringstream in(source_.text());
    const auto note = [&](int depth, json::parse_event_t event, const json& value) {
      if (event == json::parse_event_t::key && depth == 1)
        places_.push_back(placeOf(value.get<std::string>(), source_.text(),
                                  static_cast<std::size_t>(in.tellg())));
      return true;
    };
    try {
      json all = json::parse(in, note);
      if (all.is_object()) return all;
      diagnostics_.error(0, "expected an object, { ... }");
    } catch (const json::parse_error& error) {
      diagnostics_.error(std::max<std::size_t>(error.byte, 1) - 1, reasonOf(error));
    } catch (const json::exception& error) {
      diagnostics_.error(0, error.what());  // a number out of range
    }
    diagnostics_.throwErrors();
    return {};
  }

  void take(const Place& place, const json& value) {
    const auto key = std::ranges::find(kKeys, place.key, &Key::name);
    try {
      if (key != kKeys.end())
        takeOption(*key, value);
      else if (!takeBound(place.key, value))
        diagnostics_.error(place.keyAt,
                           fmt::format("unknown key {}, expected {}", xml::inQuotes(place.key),
                                       xml::expectedNames(place.key, allNames())));
    } catch (const Error& error) {
      diagnostics_.error(place.valueAt, fmt::format("\"{}\": {}", place.key, error.what()));
    }
  }

  static bool belongsToNoise(std::string_view key) { return key == kSignificance || key == kPass; }
  static bool belongsToBound(std::string_view key) { return key == kTolerance || key == kMaxShare; }

  void renderVariances() {
    for (std::string& option : settings_.options) {
      if (!option.starts_with(kLayers)) continue;
      if ((option + ",").find("variance,") == std::string::npos) option += ",variance";
      return;
    }
    settings_.options.push_back(std::string(kLayers) + "variance");
  }

  void takeMetric(const std::string& name) {
    const std::vector<std::string> names = metricNames();
    std::vector<std::string_view> known(names.begin(), names.end());
    known.push_back(kNoise);
    if (std::ranges::find(known, name) == known.end())
      throw Error(ExitCode::Usage, "expected " + xml::expectedNames(name, known));
    noise_ = name == kNoise;
    if (!noise_) settings_.bound.metric = name;
  }

  bool takeBound(const std::string& key, const json& value) {
    Bound& bound = settings_.bound;
    if (key == kMetric) {
      takeMetric(text(value));
    } else if (key == kSignificance) {
      limits_.significance = number(value);
      if (!(limits_.significance > 0.0 && limits_.significance < 1.0))
        throw Error(ExitCode::Usage, "expected a number between 0 and 1");
    } else if (key == kPass) {
      limits_.pass = number(value);
      if (limits_.pass < 0.0 || limits_.pass > 1.0)
        throw Error(ExitCode::Usage, "expected a number from 0 to 1");
    } else if (key == kTolerance) {
      bound.tolerance = number(value);
      if (bound.tolerance < 0.0) throw Error(ExitCode::Usage, "expected a number of 0 or more");
    } else if (key == kMaxShare) {
      bound.maxShare = number(value);
      if (*bound.maxShare < 0.0 || *bound.maxShare > 1.0)
        throw Error(ExitCode::Usage, "expected a number from 0 to 1");
    } else {
      return false;
    }
    return true;
  }

  void takeOption(const Key& key, const json& value) {
    std::string option(key.option);
    switch (key.kind) {
      case Key::Kind::Flag:
        if (!value.is_boolean()) throw Error(ExitCode::Usage, "expected true or false");
        if (!value.get<bool>()) return;
        break;
      case Key::Kind::Number:
        number(value);
        option.append("=").append(value.dump());
        break;
      case Key::Kind::Text:
        option.append("=").append(text(value));
        break;
      case Key::Kind::Names:
        option.append("=").append(names(value));
        break;
    }
    check_({option});
    settings_.options.push_back(std::move(option));
  }

  static double number(const json& value) {
    if (!value.is_number()) throw Error(ExitCode::Usage, "expected a number");
    return value.get<double>();
  }

  static std::string text(const json& value) {
    if (!value.is_string()) throw Error(ExitCode::Usage, "expected a text in quotes");
    return value.get<std::string>();
  }

  /// One name or an array of names, separated by commas. A user's file lies beside the settings.
  std::string names(const json& value) const {
    std::string all;
    for (const json& name : value.is_array() ? value : json::array({value})) {
      std::string one = text(name);
      if (one.ends_with(".glsl"))
        one = (std::filesystem::path(source_.file()).parent_path() / one).string();
      all += (all.empty() ? "" : ",") + one;
    }
    return all;
  }

  const xml::TextSource& source_;
  const CheckOptions& check_;
  xml::Diagnostics diagnostics_;
  std::vector<Place> places_;
  Settings settings_;
  bool noise_ = false;  ///< the metric
  NoiseLimits limits_;
};

}  // namespace

std::string help() {
  return fmt::format(
      "Tests, in FOLDER and below:\n"
      "  SCENE.xml with SCENE.expected.exr (or .png) or SCENE.test.json beside it;\n"
      "  files whose root is <test>, as laver TEST.xml runs them.\n"
      "\n"
      "SCENE.test.json is an object with any of these keys:\n"
      "  {}.\n"
      "Metrics are those of laver compare. Without a metric, it is {} with the tolerance {:g}, a\n"
      "quarter of a step of an 8-bit picture: one pixel in a hundred may have a sample that "
      "another\n"
      "driver's rounding puts on the other side of an edge. The metric \"noise\" is the test of\n"
      "laver compare --noise, with its \"significance\" and \"pass\"; both pictures then have\n"
      "variances, and need neither the same seed nor the same number of samples. \"size\" is "
      "\"WxH\",\n"
      "\"layers\" an array.\n"
      "\n"
      "Exit code: 0 if no test failed, 5 if one did, 4 without a device, 2 without a test.",
      fmt::join(allNames(), ", "), kDefaultBound.metric, kDefaultBound.tolerance);
}

Settings readSettings(const std::string& file, const CheckOptions& check) {
  const xml::FileText read = xml::readFile(file);
  if (!read.problem.empty())
    throw Error(ExitCode::Scene, fmt::format("{}: error: {}", file, read.problem));
  const xml::TextSource source(file, read.text);
  return Reader(source, check).read();
}

}  // namespace laver::suite
