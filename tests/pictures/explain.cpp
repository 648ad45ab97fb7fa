#include "pictures/explain.h"

#include "pictures/harness.h"

namespace laver::test {

void expectExplained(const Image& image, const Image& truth, const Scene& scene,
                     const Reference& reference, double tolerance) {
  const PixelDifferences found = explainPixels(image, truth, Judge(scene, reference), tolerance);
  EXPECT_EQ(found.unexplained, 0U) << found.first;
  EXPECT_LT(static_cast<double>(found.differing), kMaxExplained * image.width * image.height);
}

void expectTraversalsMatch(const Scene& scene, double tolerance) {
  const Image image = render(scene);
  expectSameByAll(image, scene);
  const Reference reference(scene);
  expectExplained(image, reference.render().image, scene, reference, tolerance);
}

}  // namespace laver::test
