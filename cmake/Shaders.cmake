# Embeds the texts of shaders/ in the binary, and the common kernels, which laver's own code
# (host/kernels/) composes and compiles during the build.
find_package(glslang CONFIG REQUIRED)
find_library(LAVER_SPIRV_TOOLS_OPT SPIRV-Tools-opt REQUIRED)
find_library(LAVER_SPIRV_TOOLS SPIRV-Tools REQUIRED)
find_library(LAVER_XXHASH xxhash REQUIRED)
add_library(laver_compiler INTERFACE)
target_link_libraries(laver_compiler INTERFACE
  glslang::SPIRV glslang::glslang glslang::glslang-default-resource-limits
  ${LAVER_SPIRV_TOOLS_OPT} ${LAVER_SPIRV_TOOLS} ${LAVER_XXHASH})

set(LAVER_SHADER_DIR ${CMAKE_CURRENT_SOURCE_DIR}/shaders)
file(GLOB_RECURSE LAVER_SHADER_TEXTS CONFIGURE_DEPENDS
  ${LAVER_SHADER_DIR}/*.glsl ${LAVER_SHADER_DIR}/*.h)
set(LAVER_SHADER_TEXTS_CPP ${CMAKE_CURRENT_BINARY_DIR}/shader_texts.cpp)
add_custom_command(OUTPUT ${LAVER_SHADER_TEXTS_CPP}
  COMMAND ${CMAKE_COMMAND} -DROOT=${LAVER_SHADER_DIR} -DOUTPUT=${LAVER_SHADER_TEXTS_CPP}
    -P ${CMAKE_CURRENT_SOURCE_DIR}/cmake/EmbedTexts.cmake
  DEPENDS ${LAVER_SHADER_TEXTS} ${CMAKE_CURRENT_SOURCE_DIR}/cmake/EmbedTexts.cmake
  COMMENT "Texts of the shaders" VERBATIM)

# laver_embed_kernels(LIBRARY): adds the common kernels to LIBRARY.
function(laver_embed_kernels library)
  add_executable(embed_kernels host/kernels/embed.cpp)
  target_link_libraries(embed_kernels PRIVATE ${library} laver_warnings)
  set(modules ${CMAKE_CURRENT_BINARY_DIR}/kernel_modules.cpp)
  add_custom_command(OUTPUT ${modules}
    COMMAND embed_kernels ${modules}
    DEPENDS embed_kernels
    COMMENT "Composing and compiling the common kernels" VERBATIM)
  add_library(laver_modules STATIC ${modules})
  target_include_directories(laver_modules PRIVATE host)
endfunction()
