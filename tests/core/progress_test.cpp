#include "core/progress.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "core/points/point_set.h"

namespace stipple {
namespace {

class Recorder final : public Progress {
 public:
  void report(double fraction, std::string_view message) override {
    fractions.push_back(fraction);
    lastMessage = message;
  }
  void publish(const PointSet& state) override { publishedSize = state.size(); }
  bool cancelled() const override { return stop; }

  std::vector<double> fractions;
  std::string lastMessage;
  Index publishedSize = 0;
  bool stop = false;
};

TEST(PartialProgress, MapsItsFractionsIntoItsPartOfTheWhole) {
  Recorder whole;
  PartialProgress half(whole, 0.5, 1.0);
  PartialProgress quarter(half, 0.0, 0.5);
  half.report(0, "start");
  quarter.report(1, "nested");
  half.report(1, "end");
  EXPECT_EQ(whole.fractions, (std::vector<double>{0.5, 0.75, 1.0}));
  EXPECT_EQ(whole.lastMessage, "end");
}

TEST(PartialProgress, PassesStatesUpAndCancellationDown) {
  Recorder whole;
  PartialProgress part(whole, 0, 0.1);
  part.publish(PointSet({{0, 0, 0}, {1, 1, 1}}));
  EXPECT_EQ(whole.publishedSize, 2u);
  EXPECT_NO_THROW(part.throwIfCancelled());
  whole.stop = true;
  EXPECT_THROW(part.throwIfCancelled(), Cancelled);
}

}  // namespace
}  // namespace stipple
