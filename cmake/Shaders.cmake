# GLSL -> SPIR-V by glslang, checked by spirv-val, embedded as C++ arrays in laver_shaders.
file(GLOB LAVER_KERNELS CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/shaders/*.comp)
file(GLOB_RECURSE LAVER_SHADER_HEADERS CONFIGURE_DEPENDS
  ${CMAKE_CURRENT_SOURCE_DIR}/shaders/*.glsl ${CMAKE_CURRENT_SOURCE_DIR}/shaders/*.h)

set(LAVER_SPIRV_DIR ${CMAKE_CURRENT_BINARY_DIR}/spirv)
file(MAKE_DIRECTORY ${LAVER_SPIRV_DIR})
set(includes "")
set(entries "")
set(arrays "")
# laver_kernel(NAME FILE defines...)
macro(laver_kernel name kernel)
  set(spirv ${LAVER_SPIRV_DIR}/${name}.spv)
  set(array ${LAVER_SPIRV_DIR}/${name}.inc)
  set(compile ${LAVER_GLSLANG} --quiet --target-env vulkan1.1
    -I${CMAKE_CURRENT_SOURCE_DIR}/shaders ${ARGN} ${kernel})
  add_custom_command(OUTPUT ${spirv} ${array}
    COMMAND ${compile} -o ${spirv}
    COMMAND ${LAVER_SPIRV_VAL} --target-env vulkan1.1 ${spirv}
    COMMAND ${compile} --vn spirv_${name} -o ${array}
    DEPENDS ${kernel} ${LAVER_SHADER_HEADERS}
    COMMENT "SPIR-V ${name}" VERBATIM)
  string(APPEND includes "#include \"${array}\"\n")
  string(APPEND entries "      {\"${name}\", spirv_${name}},\n")
  list(APPEND arrays ${array})
endmacro()

# An integrator is compiled for both traversals.
foreach(kernel IN LISTS LAVER_KERNELS)
  get_filename_component(name ${kernel} NAME_WE)
  file(STRINGS ${kernel} integrator REGEX "integrator.glsl")
  if(integrator)
    laver_kernel(${name}_lane ${kernel})
    laver_kernel(${name}_packet ${kernel} -DLAVER_PACKET)
  else()
    laver_kernel(${name} ${kernel})
  endif()
endforeach()

# Only the list of kernels stands in this file; it is written anew when that changes.
file(CONFIGURE OUTPUT ${LAVER_SPIRV_DIR}/spirv.cpp @ONLY CONTENT
"#include \"vulkan/spirv.h\"

#include <map>

namespace laver {
namespace {
@includes@}  // namespace

std::span<const std::uint32_t> spirvOf(const std::string& kernel) {
  static const std::map<std::string, std::span<const std::uint32_t>> kernels = {
@entries@  };
  return kernels.at(kernel);
}

}  // namespace laver
")
set_source_files_properties(${LAVER_SPIRV_DIR}/spirv.cpp PROPERTIES OBJECT_DEPENDS "${arrays}")
add_library(laver_shaders STATIC ${LAVER_SPIRV_DIR}/spirv.cpp ${arrays})
target_include_directories(laver_shaders PRIVATE ${CMAKE_CURRENT_SOURCE_DIR}/host)
