#include "stability/record.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "core/base64.h"
#include "image/io.h"

namespace laver::test {
namespace {

std::filesystem::path folder() { return std::filesystem::path(LAVER_STABILITY_DIR) / "rows"; }

/// A PNG as a data URI.
std::string dataUri(const Bitmap& bitmap) {
  return "data:image/png;base64," + base64(encodePng(bitmap));
}

}  // namespace

Record::Record(std::string name, std::string title, bool full) {
  std::filesystem::create_directories(folder());
  json_ = {{"case", std::move(name)},
           {"title", std::move(title)},
           {"full", full},
           {"rows", nlohmann::json::array()},
           {"pictures", nlohmann::json::array()},
           {"tables", nlohmann::json::array()}};
}

Record::~Record() {
  json_["passed"] = !testing::Test::HasFailure();
  std::ofstream(folder() / fmt::format("{}{}.json", json_["full"].get<bool>() ? "full-" : "",
                                       json_["case"].get<std::string>()))
      << json_.dump(1);
}

void Record::add(const Row& row) {
  const auto now = std::chrono::steady_clock::now();
  const double seconds =
      row.seconds >= 0 ? row.seconds : std::chrono::duration<double>(now - last_).count();
  last_ = now;
  // Written so that NaN fails.
  const bool holds = row.ours <= row.wanted;
  const bool shows = !row.naive || !(*row.naive <= row.wanted);
  json_["rows"].push_back({{"what", row.what},
                           {"subject", row.subject},
                           {"rays", row.rays},
                           {"naive", row.naive ? nlohmann::json(*row.naive) : nlohmann::json()},
                           {"ours", row.ours},
                           {"wanted", row.wanted},
                           {"unit", row.unit},
                           {"seconds", seconds},
                           {"passed", holds && shows}});
  EXPECT_TRUE(holds) << row.what << ", " << row.subject << ": " << row.ours << " " << row.unit
                     << " of " << row.rays << ", wanted at most " << row.wanted;
  EXPECT_TRUE(shows) << row.what << ", " << row.subject
                     << ": the naive method does not fail, so the case shows nothing";
}

void Record::picture(const std::string& caption, const Bitmap& naive, const Bitmap& ours) {
  json_["pictures"].push_back(
      {{"caption", caption}, {"naive", dataUri(naive)}, {"ours", dataUri(ours)}});
}

void Record::table(const std::string& caption, const std::vector<std::vector<std::string>>& cells) {
  json_["tables"].push_back({{"caption", caption}, {"cells", cells}});
}

std::uint64_t amount(bool full, std::uint64_t quick, std::uint64_t whole) {
#ifdef LAVER_SLOW_BUILD
  quick = std::max<std::uint64_t>(quick / 20, 1);
  whole = std::max<std::uint64_t>(whole / 20, 1);
#endif
  return full ? whole : quick;
}

}  // namespace laver::test
