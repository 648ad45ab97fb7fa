// Merges the rows that the cases wrote into the suite's table: printed, as JSON and as a page.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>

#include "stability/page.h"

namespace {

using nlohmann::json;

/// All cases by name; the full form if both exist.
json readCases(const std::filesystem::path& folder) {
  std::vector<json> cases;
  if (std::filesystem::is_directory(folder))
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      if (entry.path().extension() != ".json") continue;
      std::ifstream in(entry.path());
      cases.push_back(json::parse(in));
    }
  const auto key = [](const json& c) {
    return std::pair(c["case"].get<std::string>(), !c["full"].get<bool>());
  };
  std::sort(cases.begin(), cases.end(),
            [&](const json& a, const json& b) { return key(a) < key(b); });
  const auto same = [](const json& a, const json& b) { return a["case"] == b["case"]; };
  cases.erase(std::unique(cases.begin(), cases.end(), same), cases.end());
  return cases;
}

void print(const json& cases) {
  fmt::print("{:14} {:44} {:20} {:>10} {:>10} {:>10} {:>8}  {:14} {:>7}\n", "case", "input",
             "text that ran", "rays", "naive", "ours", "wanted", "unit", "seconds");
  using laver::test::figure;
  for (const auto& c : cases)
    for (const auto& row : c["rows"])
      fmt::print("{:14} {:44} {:20} {:>10} {:>10} {:>10} {:>8}  {:14} {:>7.1f}{}\n",
                 c["case"].get<std::string>(), row["what"].get<std::string>(),
                 row["subject"].get<std::string>(), figure(row["rays"]), figure(row["naive"]),
                 figure(row["ours"]), figure(row["wanted"]), row["unit"].get<std::string>(),
                 row["seconds"].get<double>(), row["passed"].get<bool>() ? "" : "  FAILED");
  for (const auto& c : cases)
    for (const auto& table : c["tables"]) {
      fmt::print("\n{}\n", table["caption"].get<std::string>());
      for (const auto& line : table["cells"]) {
        for (const auto& cell : line) fmt::print("  {:>20}", cell.get<std::string>());
        fmt::print("\n");
      }
    }
}

void report(const std::filesystem::path& folder) {
  const json cases = readCases(folder / "rows");
  print(cases);
  json table = cases;
  for (auto& c : table) c.erase("pictures");
  std::ofstream(folder / "stability.json") << table.dump(1) << '\n';
  std::ofstream(folder / "stability.html") << laver::test::page(cases);
  fmt::print("\nWrote {0}/stability.json and {0}/stability.html\n", folder.string());
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("usage: stability_report FOLDER\n", stderr);
    return 2;
  }
  try {
    report(argv[1]);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "stability_report: %s\n", error.what());
    return 1;
  }
}
