#pragma once
#include <chrono>
#include <cstdint>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "image/bitmap.h"

namespace laver::test {

/// One line of the suite's table: a method that fails, and ours, on the same input.
struct Row {
  std::string what;     ///< the input
  std::string subject;  ///< whose text ran: a traversal, or the C++ twin and how it was compiled
  std::uint64_t rays = 0;
  std::optional<double> naive;  ///< none where no naive method is to be had
  double ours = 0;
  double wanted = 0;    ///< ours may not exceed it
  std::string unit;     ///< of the three: misses, ulp, ...
  double seconds = -1;  ///< of ours; negative: since the last row, or the beginning
};

/// The rows and pictures of one case, written as JSON for the report when it ends. Each row is an
/// expectation: ours stays within what is wanted, and the naive method does not, or the case would
/// show nothing.
class Record {
 public:
  /// `name` and `title` as in the suite's table; `full`: the slow form.
  Record(std::string name, std::string title, bool full);
  ~Record();
  Record(const Record&) = delete;
  Record& operator=(const Record&) = delete;

  void add(const Row& row);
  /// A pair of pictures for the page.
  void picture(const std::string& caption, const Bitmap& naive, const Bitmap& ours);
  /// A table for the page and the README, first row the headings.
  void table(const std::string& caption, const std::vector<std::vector<std::string>>& cells);

 private:
  nlohmann::json json_;
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

/// Input sizes of the quick and the full form; builds that are not optimised take a share of them.
std::uint64_t amount(bool full, std::uint64_t quick, std::uint64_t whole);

}  // namespace laver::test

/// Defines a case in its two forms, Stability.NAME and FullStability.NAME, from the body that
/// follows, which has `record` and `full`.
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
