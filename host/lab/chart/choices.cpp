#include "lab/chart/choices.h"

#include <fmt/format.h>

#include <algorithm>

namespace laver::chart {
namespace {

/// Each step quarters the variance.
constexpr std::uint32_t kSamples[] = {1, 4, 16, 64, 256};
constexpr double kErrors[] = {0.04, 0.02, 0.01, 0.005};
/// Of a pixel, so that the error asked for decides and not this.
constexpr std::uint32_t kMostAdaptive = 1024;

void addSeries(const Series& series, std::uint32_t mostSamples, std::vector<Choice>& choices) {
  if (series.adaptive)
    for (const double error : kErrors) choices.push_back({series, 0, error, kMostAdaptive});
  else
    for (const std::uint32_t samples : kSamples)
      if (samples <= mostSamples) choices.push_back({series, samples, 0.0});
}

}  // namespace

std::string nameOf(const Series& series) {
  std::string name = series.program == "laver" ? "" : series.program + ", ";
  name += series.sampler;
  if (series.adaptive) name += " adaptive";
  name += std::string(", ") + series.filter->name;
  return series.traversal.empty() ? name : name + ", " + series.traversal;
}

std::vector<std::string> Choice::arguments() const {
  std::vector<std::string> list{"--filter", series.filter->name};
  const auto add = [&](const char* option, const std::string& value) {
    if (value.empty()) return;
    list.emplace_back(option);
    list.push_back(value);
  };
  add("--sampler", series.sampler);
  add("--traversal", series.traversal);
  if (series.adaptive) add("--error", fmt::format("{}", error));
  add("--spp", std::to_string(series.adaptive ? most : samples));
  return list;
}

std::vector<std::string> traversalsBeside(const std::string& unasked) {
  if (unasked == "lane") return {};
  return {"lane", unasked == "packet64" ? "packet32" : "packet64"};
}

std::vector<Filter> filtersFor(const Scene& scene) {
  std::vector<Filter> filters{scene.filter};
  for (const FilterRow* row : filterRows())
    if (row != scene.filter.row) filters.push_back(filterOf(*row));
  // The narrower ones first.
  std::stable_sort(filters.begin() + 1, filters.end(),
                   [](const Filter& a, const Filter& b) { return a.radius < b.radius; });
  return filters;
}

std::vector<Choice> choicesFor(const Scene& scene, const std::vector<Program>& programs,
                               const std::vector<std::string>& traversals,
                               std::uint32_t mostSamples) {
  std::vector<Choice> choices;
  for (const Filter& filter : filtersFor(scene)) {
    for (const SamplerRow* sampler : samplerRows()) {
      addSeries({"laver", sampler->name, filter.row, "", false}, mostSamples, choices);
      if (sampler->adaptive && filter.row == scene.filter.row)
        addSeries({"laver", sampler->name, filter.row, "", true}, mostSamples, choices);
    }
    if (filter.row == scene.filter.row)
      for (const std::string& traversal : traversals)
        addSeries({"laver", samplers::independent.name, filter.row, traversal, false}, mostSamples,
                  choices);
    for (const Program& program : programs)
      for (const SamplerRow* sampler : samplerRows())
        addSeries({program.name, sampler->name, filter.row, "", false}, mostSamples, choices);
  }
  return choices;
}

std::vector<std::vector<std::size_t>> sameButForProgram(const std::vector<Choice>& choices) {
  std::vector<std::vector<std::size_t>> groups;
  for (std::size_t i = 0; i < choices.size(); ++i) {
    const auto found = std::find_if(groups.begin(), groups.end(), [&](const auto& group) {
      return choices[group[0]].arguments() == choices[i].arguments();
    });
    (found == groups.end() ? groups.emplace_back() : *found).push_back(i);
  }
  return groups;
}

}  // namespace laver::chart
