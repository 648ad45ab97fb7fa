#pragma once
#include <memory>
#include <string>
#include <thread>

#include "render/observer.h"
#include "show/connection.h"

namespace laver {

/// Shows a render in progress in tev or HDRView, from its own thread. Rows that change faster than
/// the viewer takes them are sent once, with their newest values, so the render never waits for the
/// viewer. A viewer that cannot be reached or disconnects costs one warning on stderr.
class TevClient : public Observer {
 public:
  /// `name` is the image's name in the viewer.
  TevClient(ViewerAddress address, std::string name);
  /// Waits until the viewer has received the rest, at most 10 s, and at most 1 s without progress.
  ~TevClient() override;
  TevClient(const TevClient&) = delete;
  TevClient& operator=(const TevClient&) = delete;

  /// The picture's size and channels stay the same.
  void rowsChanged(const Image& picture, int first, int end) override;
  double timeShare() const override { return 0.01; }

 private:
  struct State;
  std::shared_ptr<State> state_;  ///< outlives this object if a name is still being looked up
  std::thread thread_;
};

}  // namespace laver
