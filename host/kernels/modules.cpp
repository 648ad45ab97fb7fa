#include "kernels/modules.h"

#include <algorithm>

#include "kernels/cache.h"
#include "kernels/compose.h"

namespace laver {

std::vector<std::string> commonKernels() {
  std::vector<std::string> texts;
  TraceKey whitted;
  whitted.integrator = "direct_whitted";
  whitted.bsdfs = {{.name = "diffuse", .colors = {"albedo"}}};
  whitted.lights = true;
  whitted.jumpLevels = 2;
  const auto addWhitted = [&](Traversal traversal, bool slivers) {
    for (const bool normals : {false, true})
      for (const bool materials : {false, true}) {
        TraceKey key = whitted;
        key.traversal = traversal;
        key.slivers = slivers;
        key.normals = normals;
        key.materials = materials;
        texts.push_back(compose(key));
      }
  };
  for (const Traversal traversal : {Traversal::Packet32, Traversal::Packet64})
    for (const bool slivers : {false, true}) addWhitted(traversal, slivers);
  for (const char* integrator : {"normals", "depth", "ao"}) {
    TraceKey key;
    key.integrator = integrator;
    if (key.integrator == "ao") key.properties = {{"float", "length", ""}};
    key.jumpLevels = 2;
    key.traversal = Traversal::Packet32;
    texts.push_back(compose(key));
  }
  GatherKey gather;
  gather.filter = "gaussian_narrow";
  gather.strips = true;
  texts.push_back(compose(gather));
  return texts;
}

Module moduleOf(const std::string& text) {
  const std::string hash = hashOfKernel(text);
  const auto modules = embeddedModules();
  const auto found = std::find_if(modules.begin(), modules.end(),
                                  [&](const EmbeddedModule& m) { return m.hash == hash; });
  if (found != modules.end())
    return {Spirv(found->words.begin(), found->words.end()), ModuleSource::Embedded};
  const KernelCache cache = KernelCache::ofUser();
  if (auto kept = cache.read(hash)) return {std::move(*kept), ModuleSource::Cached};
  Module module{compileGlsl(text, Effort::Quick), ModuleSource::Compiled};
  cache.write(hash, module.words);
  return module;
}

}  // namespace laver
