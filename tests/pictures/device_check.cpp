// `laver devices --check`: a right device is found right, and a wrong, failing or hanging one is
// not.
#include "lab/device_check.h"

#include <filesystem>

#include "pictures/command_line.h"
#include "pictures/harness.h"

namespace laver::test {
namespace {

class DevicesCheck : public CommandLine {
 protected:
  /// A program in place of laver.
  std::string script(const std::string& text) {
    write("laver.sh", "#!/bin/sh\n" + text);
    const fs::path file = folder_ / "laver.sh";
    fs::permissions(file, fs::perms::owner_all);
    return file.string();
  }

  /// The checks of device 0 by a script.
  std::vector<DeviceCheck> check(const std::string& text, double limit = 100.0) {
    std::vector<DeviceCheck> all;
    checkDevice(script(text), 0, testDeviceInfo(), limit,
                [&](const DeviceCheck& check) { all.push_back(check); });
    return all;
  }
};

std::size_t indexOfTestDevice() {
  const Instance instance(false);
  std::size_t index = 0;
  for (const VkPhysicalDevice device : instance.devices()) {
    if (deviceInfo(device).name == testDeviceInfo().name) break;
    ++index;
  }
  return index;
}

TEST_F(DevicesCheck, EveryTraversalOfTheTestDeviceIsRight) {
  std::size_t count = 0;
  checkDevice(LAVER_BINARY, indexOfTestDevice(), testDeviceInfo(), 100.0,
              [&](const DeviceCheck& check) {
                EXPECT_TRUE(check.right) << check.name << ": " << check.finding;
                ++count;
              });
  EXPECT_EQ(count, 1 + 2 * traversals().size());
}

TEST_F(DevicesCheck, AnotherPictureIsWrong) {
  for (const DeviceCheck& check : check("exec '" LAVER_BINARY "' \"$@\" --reference --seed 5\n")) {
    EXPECT_FALSE(check.right) << check.name;
    EXPECT_NE(check.finding.find("% of the pixels differ"), std::string::npos) << check.finding;
  }
}

TEST_F(DevicesCheck, AProgramThatFailsOrHangsIsAFinding) {
  for (const DeviceCheck& check : check("echo no luck >&2; exit 4\n")) {
    EXPECT_FALSE(check.right);
    EXPECT_EQ(check.finding, "no picture, exit code 4: no luck");
  }
  for (const DeviceCheck& check : check("exec sleep 100\n", 0.1)) {
    EXPECT_FALSE(check.right);
    EXPECT_EQ(check.finding, "no picture within 0.1 s");
  }
}

TEST_F(DevicesCheck, TheCommandPrintsALinePerPicture) {
  const Outcome run = laver("devices --check");
  EXPECT_EQ(run.code, 0) << run.out << run.err;
  EXPECT_NE(run.out.find("   normals, lane     right"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("all pictures are right\n"), std::string::npos) << run.out;
}

}  // namespace
}  // namespace laver::test
