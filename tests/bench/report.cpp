#include "bench/report.h"

#include <fmt/format.h>

#include <fstream>

#include "core/error.h"

namespace laver::bench {
namespace {

/// "hits 0.31, differing 0.0002"
std::string plain(const nlohmann::json& facts) {
  std::string out;
  for (const auto& [key, value] : facts.items()) {
    const std::string text = value.is_string()         ? value.get<std::string>()
                             : value.is_number_float() ? fmt::format("{:.4g}", value.get<double>())
                                                       : value.dump();
    out += fmt::format("{}{} {}", out.empty() ? "" : ", ", key, text);
  }
  return out;
}

}  // namespace

void Report::section(const std::string& title, const nlohmann::json& facts) {
  sections_.push_back({{"title", title}, {"facts", facts}, {"timings", nlohmann::json::array()}});
  fmt::print("\n{}\n  {}\n", title, plain(facts));
}

void Report::timing(const std::string& name, const std::vector<double>& seconds, double rays,
                    double against, const nlohmann::json& more) {
  const double middle = median(seconds);
  const double low = quantile(seconds, 0.25), high = quantile(seconds, 0.75);
  nlohmann::json entry{
      {"name", name}, {"median", middle}, {"quartiles", {low, high}}, {"seconds", seconds}};
  std::string line = fmt::format("  {:<34}{:>9.2f} ms [{:.2f}, {:.2f}]", name, middle * 1e3,
                                 low * 1e3, high * 1e3);
  if (rays > 0) {
    entry["mraysPerSecond"] = rays / middle * 1e-6;
    line += fmt::format("{:>9.1f} Mray/s", rays / middle * 1e-6);
  }
  if (against > 0) {
    entry["timesLaver"] = middle / against;
    line += fmt::format("  x{:.2f}", middle / against);
  }
  if (!more.is_null()) {
    entry["more"] = more;
    line += "  " + plain(more);
  }
  sections_.back()["timings"].push_back(entry);
  fmt::print("{}\n", line);
  std::fflush(stdout);
}

void Report::figure(const std::string& name, double got, const std::string& wanted,
                    const std::string& unit) {
  figures_.push_back({{"name", name}, {"got", got}, {"wanted", wanted}, {"unit", unit}});
}

void Report::printFigures() const {
  fmt::print("\n| figure | got | wanted |\n|---|---|---|\n");
  for (const auto& figure : figures_)
    fmt::print("| {} | {:.3g}{} | {} |\n", figure["name"].get<std::string>(),
               figure["got"].get<double>(), figure["unit"].get<std::string>(),
               figure["wanted"].get<std::string>());
}

void Report::save(const std::string& file) const {
  std::ofstream out(file);
  out << nlohmann::json{{"sections", sections_}, {"figures", figures_}}.dump(1) << '\n';
  if (!out) throw Error(ExitCode::Output, "cannot write " + file);
}

}  // namespace laver::bench
