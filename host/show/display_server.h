#pragma once
#include <memory>
#include <string>
#include <thread>

#include "image/image.h"
#include "show/connection.h"

namespace laver {

/// Shows a growing picture in tev or HDRView, from a thread of its own. The newest values of all
/// rows are kept, and a row that changes again before it was sent is sent once: nobody waits for a
/// viewer. A viewer that cannot be reached or goes away costs one line on stderr.
class DisplayServer {
 public:
  /// `name` is what the viewer calls the picture.
  DisplayServer(ViewerAddress address, std::string name);
  /// Waits for the viewer to take what it has not: until it has taken nothing for 1 s, 10 s at
  /// most.
  ~DisplayServer();
  DisplayServer(const DisplayServer&) = delete;
  DisplayServer& operator=(const DisplayServer&) = delete;

  /// Takes rows [firstRow, endRow) of the picture, whose size and channels stay the same.
  void rowsChanged(const Image& picture, int firstRow, int endRow);

 private:
  struct State;
  std::shared_ptr<State> state_;  ///< outlives this object if a name is still being looked up
  std::thread thread_;
};

}  // namespace laver
