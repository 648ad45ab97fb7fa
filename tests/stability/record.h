#pragma once
#include <chrono>
#include <cstdint>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "image/bitmap.h"

namespace laver::test {

/// One row of the suite's table: a method that fails, and ours, on the same input.
struct Row {
  std::string what;     ///< the input
  std::string subject;  ///< a traversal, or a C++ twin and how it was compiled
  std::uint64_t rays = 0;
  std::optional<double> naive;  ///< none if there is no naive method
  double ours = 0;
  double wanted = 0;    ///< upper bound for ours
  std::string unit;     ///< of the three: misses, ulp, ...
  double seconds = -1;  ///< of ours; negative: measured since the last row
};

/// The rows and pictures of one case, written as JSON for the report when it ends. Each row is an
/// expectation: ours is within `wanted`, and the naive method is not; otherwise the case would show
/// nothing.
class Record {
 public:
  /// `name` and `title` appear in the suite's table; `full` means the slow form.
  Record(std::string name, std::string title, bool full);
  ~Record();
  Record(const Record&) = delete;
  Record& operator=(const Record&) = delete;

  void add(const Row& row);
  /// A pair of pictures for the page.
  void picture(const std::string& caption, const Bitmap& naive, const Bitmap& ours);
  /// A table for the page; its first row has the headings.
  void table(const std::string& caption, const std::vector<std::vector<std::string>>& cells);

 private:
  nlohmann::json json_;
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

/// Input size of the quick or the full form; builds without optimisation use a share of it.
std::uint64_t amount(bool full, std::uint64_t quick, std::uint64_t whole);

}  // namespace laver::test

/// Defines a case in its two forms, Stability.NAME and FullStability.NAME, from the following body,
/// which uses `record` and `full`.
#define LAVER_STABILITY(name, title)                                \
  static void body##name(::laver::test::Record& record, bool full); \
  TEST(Stability, name) {                                           \
    ::laver::test::Record record(#name, title, false);              \
    body##name(record, false);                                      \
  }                                                                 \
  TEST(FullStability, name) {                                       \
    ::laver::test::Record record(#name, title, true);               \
    body##name(record, true);                                       \
  }                                                                 \
  static void body##name([[maybe_unused]] ::laver::test::Record& record, [[maybe_unused]] bool full)
