#include <algorithm>
#include <atomic>
#include <future>
#include <optional>
#include <thread>

#include "lab/suite/run.h"

namespace laver::suite {
namespace {

/// Threads that take the next test each, until none is left or they are stopped.
class Workers {
 public:
  Workers(const std::vector<Test>& tests, const Options& options) : promises_(tests.size()) {
    const std::size_t count = std::clamp<std::size_t>(options.jobs, 1, tests.size());
    for (std::size_t i = 0; i < count; ++i)
      threads_.emplace_back([this, &tests, &options] { work(tests, options); });
  }
  ~Workers() { next_ = promises_.size(); }
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;

  /// Waits for a test's result; none if it was not run.
  std::optional<Result> result(std::size_t test) { return promises_[test].get_future().get(); }

 private:
  void work(const std::vector<Test>& tests, const Options& options) {
    for (std::size_t i; (i = next_++) < tests.size();) {
      std::optional<Result> result;
      if (!options.stopped()) result = runTest(tests[i], options);
      // What an interruption ended is no result.
      if (options.stopped()) result.reset();
      promises_[i].set_value(std::move(result));
    }
  }

  std::vector<std::promise<std::optional<Result>>> promises_;
  std::atomic<std::size_t> next_ = 0;
  std::vector<std::jthread> threads_;  // destroyed first
};

}  // namespace

std::vector<Result> runTests(const std::vector<Test>& tests, const Options& options,
                             const std::function<void(const Result&)>& report) {
  Workers workers(tests, options);
  std::vector<Result> results;
  while (results.size() < tests.size()) {
    std::optional<Result> result = workers.result(results.size());
    if (!result) break;
    report(*result);
    results.push_back(std::move(*result));
  }
  return results;
}

}  // namespace laver::suite
