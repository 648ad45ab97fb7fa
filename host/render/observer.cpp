#include "render/observer.h"

#include <algorithm>

namespace laver {
namespace {

double largestShare(const std::vector<Observer*>& observers) {
  double share = 0.0;
  for (const Observer* observer : observers) share = std::max(share, observer->timeShare());
  return share;
}

}  // namespace

bool stops(const std::vector<Observer*>& observers) {
  return std::any_of(observers.begin(), observers.end(), [](Observer* o) { return o->stop(); });
}

Observers::Observers(const std::vector<Observer*>& observers)
    : observers_(observers), throttle_(largestShare(observers)) {}

void Observers::started(const std::string& device) const {
  for (Observer* observer : observers_) observer->started(device);
}

void Observers::waiting() const {
  for (Observer* observer : observers_) observer->waiting();
}

void Observers::beginPicture(std::size_t index, std::size_t count) {
  index_ = index;
  count_ = count;
}

void Observers::progress(double share, std::uint64_t samples) const {
  const double done = (static_cast<double>(index_) + share) / static_cast<double>(count_);
  for (Observer* observer : observers_) observer->progress(done, samples);
}

void Observers::rowsChanged(const Image& picture, int first, int end) const {
  if (index_ != 0) return;
  for (Observer* observer : observers_) observer->rowsChanged(picture, first, end);
}

void Observers::finished(const Image& picture) const {
  for (Observer* observer : observers_) observer->finished(picture);
}

}  // namespace laver
