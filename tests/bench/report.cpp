#include "bench/report.h"

#include <fmt/format.h>

#include <fstream>
#include <iterator>

#include "core/atomic_file.h"
#include "core/error.h"

namespace laver::bench {
namespace {

std::string plain(const nlohmann::json& value) {
  if (value.is_string()) return value.get<std::string>();
  return value.is_number_float() ? fmt::format("{:.4g}", value.get<double>()) : value.dump();
}

/// "hits: 0.31; triangles: 69666"
std::string factsText(const nlohmann::json& facts) {
  std::string text;
  for (const auto& [name, value] : facts.items())
    text += fmt::format("{}{}: {}", text.empty() ? "" : "; ", name, plain(value));
  return text;
}

std::string rowOf(const nlohmann::json& timing) {
  const auto ms = [](const nlohmann::json& seconds) {
    return fmt::format("{:.2f}", seconds.get<double>() * 1e3);
  };
  return fmt::format(
      "| {} | {} | {} to {} | {} | {} |\n", timing["name"].get<std::string>(), ms(timing["median"]),
      ms(timing["quartiles"][0]), ms(timing["quartiles"][1]),
      timing.contains("mraysPerSecond") ? plain(timing["mraysPerSecond"]) : "",
      timing.contains("ratio") ? fmt::format("{:.2f}", timing["ratio"].get<double>()) : "");
}

}  // namespace

Report::Report(const nlohmann::json& about) : about_(about) {
  fmt::print("{}\n", factsText(about));
}

void Report::section(const std::string& title, const nlohmann::json& facts) {
  sections_.push_back({{"title", title}, {"facts", facts}, {"timings", nlohmann::json::array()}});
  fmt::print("\n{}\n  {}\n", title, factsText(facts));
}

void Report::timing(const std::string& name, const std::vector<double>& seconds, double rays,
                    double against) {
  const double middle = median(seconds);
  const double low = quantile(seconds, 0.25), high = quantile(seconds, 0.75);
  nlohmann::json entry{
      {"name", name}, {"median", middle}, {"quartiles", {low, high}}, {"seconds", seconds}};
  std::string line = fmt::format("  {:<38}{:>9.2f} ms [{:.2f}, {:.2f}]", name, middle * 1e3,
                                 low * 1e3, high * 1e3);
  if (rays > 0) {
    entry["mraysPerSecond"] = rays / middle * 1e-6;
    line += fmt::format("{:>9.1f} Mray/s", rays / middle * 1e-6);
  }
  if (against > 0) {
    entry["ratio"] = middle / against;
    line += fmt::format("  x{:.2f}", middle / against);
  }
  sections_.back()["timings"].push_back(entry);
  fmt::print("{}\n", line);
  std::fflush(stdout);
}

void Report::figure(const std::string& name, double value, const std::string& unit) {
  figures_.push_back({{"name", name}, {"value", value}, {"unit", unit}});
}

std::string Report::summary() const {
  std::string text = "| summary | value |\n|---|---|\n";
  for (const auto& figure : figures_)
    text += fmt::format("| {} | {:.3g}{} |\n", figure["name"].get<std::string>(),
                        figure["value"].get<double>(), figure["unit"].get<std::string>());
  return text;
}

std::string Report::markdown() const {
  std::string text = "\n| measured on | |\n|---|---|\n";
  for (const auto& [name, value] : about_.items())
    text += fmt::format("| {} | {} |\n", name, plain(value));
  text += '\n' + summary();
  for (const auto& section : sections_) {
    text += fmt::format(
        "\n### {}\n\n{}\n\n| | median, ms | quartiles, ms | Mray/s | ratio |\n"
        "|---|--:|--:|--:|--:|\n",
        section["title"].get<std::string>(), factsText(section["facts"]));
    for (const auto& timing : section["timings"]) text += rowOf(timing);
  }
  return text;
}

void Report::printSummary() const { fmt::print("\n{}", summary()); }

void Report::saveJson(const std::string& file) const {
  const std::string text =
      nlohmann::json{{"about", about_}, {"sections", sections_}, {"figures", figures_}}.dump(1);
  replaceFile(file, std::as_bytes(std::span(text)));
}

void Report::saveMarkdown(const std::string& file) const {
  const std::string marker = "<!-- figures -->";
  std::ifstream in(file);
  std::string text((std::istreambuf_iterator<char>(in)), {});
  const auto at = text.find(marker + '\n');
  if (at == std::string::npos)
    throw Error(ExitCode::Output, fmt::format("{} has no line {}", file, marker));
  text.resize(at + marker.size());
  text += '\n' + markdown();
  replaceFile(file, std::as_bytes(std::span(text)));
}

}  // namespace laver::bench
