# GLSL -> SPIR-V by glslang, made small by spirv-opt, checked by spirv-val, embedded as C++ arrays in
# a library.
set(LAVER_SHADER_DIR ${CMAKE_CURRENT_SOURCE_DIR}/shaders)
file(GLOB LAVER_KERNELS CONFIGURE_DEPENDS ${LAVER_SHADER_DIR}/*.comp)
file(GLOB_RECURSE LAVER_SHADER_HEADERS CONFIGURE_DEPENDS
  ${LAVER_SHADER_DIR}/*.glsl ${LAVER_SHADER_DIR}/*.h)

set(LAVER_SPIRV_DIR ${CMAKE_CURRENT_BINARY_DIR}/spirv)
file(MAKE_DIRECTORY ${LAVER_SPIRV_DIR})

# What makes a kernel quick to compile: lavapipe takes 0.5 to 0.6 of the time for one that comes
# unrolled, inlined and cleaned. Loops are unrolled first, while the arithmetic in them stands in
# functions: spirv-opt's unrolling drops NoContraction, its inlining keeps it. Not for gathering by
# strips with loops of unknown length, which takes as long.
set(LAVER_SPIRV_SMALL --merge-return --eliminate-local-single-block --eliminate-local-single-store
  --ssa-rewrite --ccp --eliminate-dead-code-aggressive --loop-unroll -O)

# laver_kernel(NAME FILE defines...): one more kernel for the next laver_kernel_library. NAME.spv is
# as glslang made it, NAME.embedded.spv as it is embedded.
macro(laver_kernel name kernel)
  set(spirv ${LAVER_SPIRV_DIR}/${name}.spv)
  set(embedded ${LAVER_SPIRV_DIR}/${name}.embedded.spv)
  set(array ${LAVER_SPIRV_DIR}/${name}.inc)
  set(small "")
  if(NOT ${name} STREQUAL gather_packet)
    set(small ${LAVER_SPIRV_SMALL})
  endif()
  add_custom_command(OUTPUT ${spirv} ${embedded} ${array}
    COMMAND ${LAVER_GLSLANG} --quiet --target-env vulkan1.1 -I${LAVER_SHADER_DIR} ${ARGN} ${kernel}
      -o ${spirv}
    COMMAND ${LAVER_SPIRV_OPT} --target-env=vulkan1.1 ${small} ${spirv} -o ${embedded}
    COMMAND ${LAVER_SPIRV_VAL} --target-env vulkan1.1 ${embedded}
    COMMAND ${CMAKE_COMMAND} -DWORDS=${embedded} -DARRAY=${array} -DNAME=spirv_${name}
      -P ${CMAKE_SOURCE_DIR}/cmake/WordArray.cmake
    DEPENDS ${kernel} ${LAVER_SHADER_HEADERS}
    COMMENT "SPIR-V ${name}" VERBATIM)
  string(APPEND includes "#include \"${array}\"\n")
  string(APPEND entries "      {\"${name}\", spirv_${name}},\n")
  list(APPEND arrays ${array})
endmacro()

# laver_kernel_library(TARGET FUNCTION): the kernels named since the last one. A static library with
# std::span<const std::uint32_t> laver::FUNCTION(const std::string& kernel), which throws
# std::out_of_range. Only the list of kernels stands in its source, written anew when that changes.
macro(laver_kernel_library target function)
  set(lookup ${function})
  file(CONFIGURE OUTPUT ${LAVER_SPIRV_DIR}/${target}.cpp @ONLY CONTENT
"#include <cstdint>
#include <map>
#include <span>
#include <string>

namespace laver {
namespace {
@includes@}  // namespace

std::span<const std::uint32_t> @lookup@(const std::string& kernel) {
  static const std::map<std::string, std::span<const std::uint32_t>> kernels = {
@entries@  };
  return kernels.at(kernel);
}

}  // namespace laver
")
  set_source_files_properties(${LAVER_SPIRV_DIR}/${target}.cpp PROPERTIES OBJECT_DEPENDS "${arrays}")
  add_library(${target} STATIC ${LAVER_SPIRV_DIR}/${target}.cpp ${arrays})
  set(includes "")
  set(entries "")
  set(arrays "")
endmacro()

# Each is compiled for any device, and for subgroups of 8 lanes that shuffle: those that trace for
# packets of 32 rays and of 64.
# Those that show textures or a background are compiled with and without them, those that trace with
# and without spheres: a driver would read their code, a fifth of all, before a specialisation
# constant could leave it out. What most pictures need is compiled once more for plain scenes (layout.h).
set(LAVER_PACKETS 32 64)
set(LAVER_TEXTURED_KERNELS albedo direct_whitted)
foreach(kernel IN LISTS LAVER_KERNELS)
  get_filename_component(name ${kernel} NAME_WE)
  set(variants _)
  if(name IN_LIST LAVER_TEXTURED_KERNELS)
    list(APPEND variants _textured_)
  endif()
  if(NOT name STREQUAL gather)
    list(TRANSFORM variants APPEND spheres_ OUTPUT_VARIABLE with_spheres)
    list(APPEND variants ${with_spheres})
  endif()
  foreach(variant IN LISTS variants)
    set(defines "")
    if(variant MATCHES textured)
      list(APPEND defines -DLAVER_TEXTURES)
    endif()
    if(variant MATCHES spheres)
      list(APPEND defines -DLAVER_SPHERES)
    endif()
    laver_kernel(${name}${variant}lane ${kernel} ${defines})
    if(name STREQUAL gather)
      laver_kernel(gather_packet ${kernel} -DLAVER_PACKET)
    else()
      foreach(rays ${LAVER_PACKETS})
        laver_kernel(${name}${variant}packet${rays} ${kernel} ${defines} -DLAVER_PACKET=${rays})
      endforeach()
    endif()
  endforeach()
endforeach()
foreach(rays ${LAVER_PACKETS})
  foreach(normals 0 1)
    foreach(albedos 0 1)
      foreach(sampler 0 1 2)
        laver_kernel(direct_whitted_packet${rays}_plain_${normals}${albedos}${sampler}
          ${LAVER_SHADER_DIR}/direct_whitted.comp -DLAVER_PACKET=${rays} -DLAVER_PLAIN
          -DPLAIN_NORMALS=${normals} -DPLAIN_ALBEDOS=${albedos} -DPLAIN_SAMPLER=${sampler})
      endforeach()
    endforeach()
  endforeach()
endforeach()
foreach(filter 1 2 3 4)
  laver_kernel(gather_packet_plain_${filter} ${LAVER_SHADER_DIR}/gather.comp -DLAVER_PACKET
    -DLAVER_PLAIN -DPLAIN_FILTER=${filter})
endforeach()
# Methods that laver does not render with, for `laver chart`.
laver_kernel(charted_methods ${LAVER_SHADER_DIR}/charted/methods.comp)
laver_kernel_library(laver_shaders spirvOf)
