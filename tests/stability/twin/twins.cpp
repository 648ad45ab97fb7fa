#include "stability/twin/twin.h"

namespace laver::test {

const Twin* twinUnoptimised();
const Twin* twinOptimised();
const Twin* twinContracted();
const Twin* twinNanKeeping();

std::vector<const Twin*> twins() {
  std::vector<const Twin*> all{twinUnoptimised(), twinOptimised(), twinNanKeeping()};
#ifdef __x86_64__
  if (__builtin_cpu_supports("fma") == 0) return all;
#endif
  all.push_back(twinContracted());
  return all;
}

}  // namespace laver::test
