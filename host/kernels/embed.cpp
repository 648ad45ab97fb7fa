// Build tool: composes and compiles the common kernels and writes them as C++.
#include <cstdio>
#include <exception>
#include <fstream>

#include "core/parallel.h"
#include "kernels/cache.h"
#include "kernels/modules.h"

namespace laver {

std::span<const EmbeddedModule> embeddedModules() { return {}; }

namespace {

void write(const char* path, const std::vector<std::string>& texts,
           const std::vector<Spirv>& modules) {
  std::ofstream out(path);
  out << "#include \"kernels/modules.h\"\n\nnamespace laver {\nnamespace {\n\n";
  for (std::size_t i = 0; i < modules.size(); ++i) {
    out << "const std::uint32_t kModule" << i << "[] = {";
    for (const std::uint32_t word : modules[i]) out << word << ',';
    out << "};\n";
  }
  out << "const EmbeddedModule kModules[] = {\n";
  for (std::size_t i = 0; i < modules.size(); ++i)
    out << "    {\"" << hashOfKernel(texts[i]) << "\", kModule" << i << "},\n";
  out << "};\n\n}  // namespace\n\n"
         "std::span<const EmbeddedModule> embeddedModules() { return kModules; }\n\n"
         "}  // namespace laver\n";
  out.flush();
  if (!out) throw std::runtime_error(std::string(path) + ": cannot be written");
}

}  // namespace
}  // namespace laver

int main(int argc, char** argv) {
  using namespace laver;
  try {
    if (argc != 2) throw std::runtime_error("usage: embed_kernels FILE.cpp");
    const std::vector<std::string> texts = commonKernels();
    std::vector<Spirv> modules(texts.size());
    parallelFor(texts.size(), 1, 0, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        modules[i] = compileGlsl(texts[i], Effort::Thorough);
    });
    write(argv[1], texts, modules);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
