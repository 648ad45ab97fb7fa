# Warnings of laver's own code; dependencies are system headers.
option(LAVER_WERROR "Treat warnings as errors" ON)
add_library(laver_warnings INTERFACE)
target_compile_options(laver_warnings INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wdouble-promotion
  $<$<BOOL:${LAVER_WERROR}>:-Werror>)
# Vulkan's structs are initialised with their sType and filled member by member.
target_compile_options(laver_warnings INTERFACE -Wno-missing-field-initializers)
# gcc 12 reports an overlapping copy for `"literal" + std::string` (GCC bug 105651).
target_compile_options(laver_warnings INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>)
# The reference and the tree builder rely on the rounding of each operation.
target_compile_options(laver_warnings INTERFACE -ffp-contract=off)
