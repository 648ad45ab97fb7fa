# Warnings of laver's own code; dependencies are system headers.
option(LAVER_WERROR "Treat warnings as errors" ON)
add_library(laver_warnings INTERFACE)
target_compile_options(laver_warnings INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wdouble-promotion
  $<$<BOOL:${LAVER_WERROR}>:-Werror>)
# Vulkan's structs are begun with their sType and filled member by member.
target_compile_options(laver_warnings INTERFACE -Wno-missing-field-initializers)
# gcc 12 takes `"literal" + std::string` for an overlapping copy (GCC bug 105651).
target_compile_options(laver_warnings INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>)
# The reference's and the builder's arithmetic is written as it is meant to round.
target_compile_options(laver_warnings INTERFACE -ffp-contract=off)
