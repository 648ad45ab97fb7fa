#pragma once
#include <memory>
#include <string>
#include <thread>

#include "render/observer.h"
#include "show/connection.h"

namespace laver {

/// Shows a growing picture in tev or HDRView, from a thread of its own. The newest values of all
/// rows are kept, and a row that changes again before it was sent is sent once: nobody waits for a
/// viewer. A viewer that cannot be reached or goes away costs one line on stderr.
class TevClient : public Observer {
 public:
  /// `name` is what the viewer calls the picture.
  TevClient(ViewerAddress address, std::string name);
  /// Waits for the viewer to take what it has not: until it has taken nothing for 1 s, 10 s at
  /// most.
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
