// A library for LD_PRELOAD: the allocation number LAVER_FAILING_ALLOCATION, from 1, that the
// program itself asks for fails. Those of shared libraries, the driver's among them, do not count;
// nor do functions of the program fail that such a library calls, as drivers do with templates that
// both have: the next one fails in their place. The number of all is written to the file
// LAVER_COUNTED_ALLOCATIONS at the end, if it is set and not 0, as in the programs that start
// laver.
#include <dlfcn.h>
#include <execinfo.h>
#include <link.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <new>

namespace {

struct Program {
  std::uintptr_t first = UINTPTR_MAX, end = 0;
};

/// The addresses of the executable, which is the first object.
Program loadedProgram() {
  Program program;
  const auto add = [](dl_phdr_info* info, std::size_t, void* data) {
    auto* const found = static_cast<Program*>(data);
    for (int i = 0; i < info->dlpi_phnum; ++i) {
      const auto& header = info->dlpi_phdr[i];
      if (header.p_type != PT_LOAD) continue;
      const std::uintptr_t first = info->dlpi_addr + header.p_vaddr;
      if (first < found->first) found->first = first;
      if (first + header.p_memsz > found->end) found->end = first + header.p_memsz;
    }
    return 1;
  };
  dl_iterate_phdr(add, &program);
  return program;
}

const Program& program() {
  static const Program program = loadedProgram();
  return program;
}

std::atomic<std::uint64_t> counted{0};

/// Whether all callers are the program or the runtime of C++.
bool calledByProgram() {
  void* frames[256];
  const int count = backtrace(frames, 256);
  static const char* const kRuntime[] = {"libc.so", "libstdc++.so", "libgcc_s.so", "failing_new"};
  for (int i = 0; i < count; ++i) {
    const auto place = reinterpret_cast<std::uintptr_t>(frames[i]);
    if (place >= program().first && place < program().end) continue;
    Dl_info info{};
    if (dladdr(frames[i], &info) == 0) return false;
    bool runtime = false;
    for (const char* name : kRuntime)
      runtime = runtime || std::strstr(info.dli_fname, name) != nullptr;
    if (!runtime) return false;
  }
  return true;
}

bool fails(const void* caller) {
  static const char* const text = std::getenv("LAVER_FAILING_ALLOCATION");
  static std::atomic<std::uint64_t> failing =
      text == nullptr ? 0 : std::strtoull(text, nullptr, 10);
  const auto place = reinterpret_cast<std::uintptr_t>(caller);
  if (place < program().first || place >= program().end || ++counted != failing) return false;
  if (calledByProgram()) return true;
  ++failing;
  return false;
}

/// Null if it fails. A multiple of the alignment, as aligned_alloc() demands.
void* memory(std::size_t bytes, std::size_t alignment, const void* caller) {
  if (fails(caller)) return nullptr;
  if (bytes == 0) bytes = 1;
  if (alignment <= alignof(std::max_align_t)) return std::malloc(bytes);
  return std::aligned_alloc(alignment, (bytes + alignment - 1) / alignment * alignment);
}

void* orThrow(void* memory) {
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

struct Report {
  Report() {
    void* frame = nullptr;
    backtrace(&frame, 1);  // the first call loads a library
  }
  ~Report() {
    const char* const name = std::getenv("LAVER_COUNTED_ALLOCATIONS");
    std::FILE* const file = name == nullptr || counted == 0 ? nullptr : std::fopen(name, "w");
    if (file == nullptr) return;
    std::fprintf(file, "%llu", static_cast<unsigned long long>(counted));
    std::fclose(file);
  }
} const report;

}  // namespace

#define CALLER __builtin_return_address(0)
using std::align_val_t, std::nothrow_t, std::size_t;

void* operator new(size_t bytes) { return orThrow(memory(bytes, 1, CALLER)); }
void* operator new[](size_t bytes) { return orThrow(memory(bytes, 1, CALLER)); }
void* operator new(size_t bytes, align_val_t alignment) {
  return orThrow(memory(bytes, static_cast<size_t>(alignment), CALLER));
}
void* operator new[](size_t bytes, align_val_t alignment) {
  return orThrow(memory(bytes, static_cast<size_t>(alignment), CALLER));
}
void* operator new(size_t bytes, const nothrow_t& /*nothrow*/) noexcept {
  return memory(bytes, 1, CALLER);
}
void* operator new[](size_t bytes, const nothrow_t& /*nothrow*/) noexcept {
  return memory(bytes, 1, CALLER);
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, size_t /*bytes*/) noexcept { std::free(memory); }
void operator delete[](void* memory, size_t /*bytes*/) noexcept { std::free(memory); }
void operator delete(void* memory, align_val_t /*alignment*/) noexcept { std::free(memory); }
void operator delete[](void* memory, align_val_t /*alignment*/) noexcept { std::free(memory); }
void operator delete(void* memory, size_t /*bytes*/, align_val_t /*alignment*/) noexcept {
  std::free(memory);
}
void operator delete[](void* memory, size_t /*bytes*/, align_val_t /*alignment*/) noexcept {
  std::free(memory);
}
