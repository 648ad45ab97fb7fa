#include "render/observer.h"

#include <gtest/gtest.h>

#include <limits>

namespace laver::test {
namespace {

struct Notes : Observer {
  explicit Notes(double share = 0.0, bool ends = false) : share_(share), ends_(ends) {}

  void started(const std::string& device) override { text += device + ' '; }
  bool stop() override { return ends_; }
  void progress(double share, std::uint64_t samples) override {
    text += std::to_string(share).substr(0, 5) + '/' + std::to_string(samples) + ' ';
  }
  void rowsChanged(const Image& /*picture*/, int first, int end) override {
    text += std::to_string(first) + '-' + std::to_string(end) + ' ';
  }
  void finished(const Image& /*picture*/) override { text += "end"; }
  double timeShare() const override { return share_; }

  std::string text;

 private:
  double share_;
  bool ends_;
};

TEST(Observers, AllReceiveRowsOfTheFirstPictureAndAllProgress) {
  Notes a, b;
  Observers observers({&a, &b});
  const Image picture = rgbImage(2, 2);
  observers.started("cpu");
  observers.beginPicture(0, 4);
  observers.rowsChanged(picture, 0, 1);
  observers.progress(0.5, 10);
  observers.beginPicture(3, 4);
  observers.rowsChanged(picture, 1, 2);
  observers.progress(1.0, 80);
  observers.finished(picture);
  EXPECT_EQ(a.text, "cpu 0-1 0.125/10 1.000/80 end");
  EXPECT_EQ(b.text, a.text);
}

TEST(Observers, OneCanStopTheRender) {
  Notes goesOn, ends(0.0, true);
  EXPECT_FALSE(Observers({&goesOn}).stop());
  EXPECT_TRUE(Observers({&goesOn, &ends}).stop());
}

TEST(Observers, UnfinishedRowsAreDueIfAnObserverHasTimeForThem) {
  Notes none, always(std::numeric_limits<double>::infinity());
  EXPECT_FALSE(Observers({}).due());
  EXPECT_FALSE(Observers({&none}).due());
  Observers observers({&none, &always});
  EXPECT_TRUE(observers.due());
  observers.show([] {});
  EXPECT_TRUE(observers.due());
  observers.beginPicture(1, 2);
  EXPECT_FALSE(observers.due());
}

}  // namespace
}  // namespace laver::test
