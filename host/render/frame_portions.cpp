// Tracing in smaller steps, for drivers that cut loops short.
#include <fmt/format.h>

#include <algorithm>

#include "render/frame.h"
#include "render/tiling.h"

namespace laver {
namespace {

/// Workgroups, of 64 samples, whose queries are answered together: bounds the answers in memory to
/// 256 KiB per query, or where several queries are answered at once, as for long paths, to 16 KiB.
constexpr std::uint32_t kGroups = 1024, kGroupsOfPaths = 64;

/// Queries per dispatch: lavapipe's 65,535 loop iterations leave about 1,000 to each.
constexpr std::uint32_t kQueries = 64;
constexpr std::uint32_t kAllQueries = 0xffffffff;

}  // namespace

/// First `lane` instead of packets, then one dispatch for several queries, then one per query, then
/// one per portion of the tree. Returns false if the steps cannot be smaller.
bool Frame::takesSmallerSteps() {
  if (isPacket(traversal_)) {
    traversal_ = Traversal::Lane;
    work_.fallback =
        fmt::format("{} packets ran more loops than the driver lets one invocation run",
                    status_.incomplete / 8);
  } else if (!portions_) {
    portions_ = Portions{{}, {packed_.bvh.root}, packed_.bvh.stack};
    queriesAtOnce_ = kQueries;
    work_.fallback = fmt::format(
        "{} rays ran more loops than the driver lets one invocation run: dispatches of {} queries",
        status_.incomplete, kQueries);
  } else if (queriesAtOnce_ > 1) {
    queriesAtOnce_ = 1;
    work_.fallback = fmt::format(
        "{} rays ran more loops than the driver lets one invocation run: one dispatch per query",
        status_.incomplete);
    return true;
  } else if (portions_->nodes.empty()) {
    portions_ = portionsOf(packed_.bvh, shared::PORTION_PRIMITIVES);
    onDevice_.upload(std::span<const shared::Node>(portions_->nodes));
    work_.fallback = fmt::format(
        "{} rays ran more loops than the driver lets one invocation run: {} portions of the tree",
        status_.incomplete, portions_->roots.size());
  } else {
    return false;
  }
  compileTrace(traversal_);
  return true;
}

/// Splits a dispatch into ones of at most `most` workgroups, or of one row of them.
std::vector<Frame::Dispatch> Frame::split(const Dispatch& whole, std::uint32_t most) const {
  const auto [columns, rows, layers] = whole.groups;
  std::vector<Dispatch> parts;
  if (mapped()) {
    for (std::uint32_t first = 0; first < columns * rows; first += most) {
      Dispatch part = whole;
      part.pass.firstWork += first;
      part.groups = {std::min(most, columns * rows - first), 1, 1};
      parts.push_back(part);
    }
    return parts;
  }
  const std::uint32_t side = 8U >> whole.pass.sideShift / 2;
  const std::uint32_t rowsOfPart = std::clamp(most / columns, 1U, rows);
  const std::uint32_t layersOfPart = std::clamp(most / (columns * rowsOfPart), 1U, layers);
  for (std::uint32_t layer = 0; layer < layers; layer += layersOfPart)
    for (std::uint32_t row = 0; row < rows; row += rowsOfPart) {
      Dispatch part = whole;
      shared::Pass& pass = part.pass;
      pass.dispatchSample += layer << pass.sideShift;
      pass.part.y += row * side;
      pass.part.w = std::min(pass.part.w, pass.part.y + rowsOfPart * side);
      pass.tileRows = groupsOf(pass.part.w - pass.part.y, side);
      pass.rowStride = rowStride(pass.tileRows);
      part.groups = {columns, pass.tileRows, std::min(layersOfPart, layers - layer)};
      parts.push_back(part);
    }
  return parts;
}

void Frame::dispatchPortions(const shared::Pass& pass) {
  for (const Dispatch& dispatch : tracing(pass))
    for (const Dispatch& part : split(dispatch, queriesAtOnce_ > 1 ? kGroupsOfPaths : kGroups))
      if (!answerQueries(part)) return;
}

/// Answers the first queries of all samples, portion by portion of the tree, then the next ones,
/// until no sample makes another; then stores the samples. Returns whether no loop was cut short.
///
/// Where a dispatch answers several queries, most samples need no more than it could: at first, and
/// each time the number of answers has doubled, it is tried to do the rest at once. What such a
/// trial stores is overwritten by the next, but lights in several dispatches add to what is stored.
bool Frame::answerQueries(Dispatch dispatch) {
  shared::Status before = status_;
  before.queries = 0;  // those of other samples do not count
  const auto run = [&] {
    onDevice_.status().upload(std::as_bytes(std::span(&before, 1)));
    device_.run(
        [&](VkCommandBuffer commands) { record(commands, kernels_.trace->kernel, dispatch); });
    onDevice_.status().download(std::as_writable_bytes(std::span(&status_, 1)));
    return status_.incomplete == 0;
  };
  const auto& [columns, rows, layers] = dispatch.groups;
  const std::uint64_t samples = std::uint64_t{columns} * rows * layers * 64;
  shared::Pass& pass = dispatch.pass;
  const bool tries = queriesAtOnce_ > 1 && pass.firstDispatch != 0 && pass.lastDispatch != 0;
  const auto finish = [&](std::uint32_t more) {
    pass.portion = shared::ALL_ANSWERED;
    pass.root = portions_->roots.front();
    pass.queryCount = more;
    return run();
  };
  std::uint32_t queries = 1, nextTrial = 0;
  for (pass.query = 0; pass.query < queries; pass.query += queriesAtOnce_) {
    if (tries && pass.query >= nextTrial) {
      if (finish(kAllQueries)) return true;
      nextTrial = 2 * pass.query + queriesAtOnce_;
    }
    pass.queryCount = queriesAtOnce_;
    onDevice_.reserveAnswers((pass.query + pass.queryCount) * samples);
    for (pass.portion = 0; pass.portion < portions_->roots.size(); ++pass.portion) {
      pass.root = portions_->roots[pass.portion];
      if (!run()) return false;
    }
    queries = std::max(queries, status_.queries);
  }
  return finish(0);
}

}  // namespace laver
