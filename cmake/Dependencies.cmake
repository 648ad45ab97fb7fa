# Packages of Debian 12 and 13; cmake/bootstrap.sh installs them.
find_package(Threads REQUIRED)
find_package(Vulkan REQUIRED)
find_package(glm REQUIRED)
find_package(pugixml REQUIRED)
find_package(OpenEXR QUIET REQUIRED)
find_package(PNG REQUIRED)
find_package(JPEG REQUIRED)
find_package(Boost REQUIRED)  # headers: distributions of statistics
find_package(CLI11 REQUIRED)
find_package(fmt REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(PkgConfig REQUIRED)
pkg_check_modules(CAIRO REQUIRED IMPORTED_TARGET cairo)  # charts
find_path(LAVER_VOLK_INCLUDE volk.h REQUIRED)
find_path(LAVER_DEFLATE_INCLUDE libdeflate.h REQUIRED)
find_library(LAVER_DEFLATE deflate REQUIRED)
find_path(LAVER_XXHASH_INCLUDE xxhash.h REQUIRED)
find_library(LAVER_XXHASH xxhash REQUIRED)
find_path(LAVER_TINYOBJ_INCLUDE tiny_obj_loader.h REQUIRED)

add_library(laver_dependencies INTERFACE)
target_include_directories(laver_dependencies SYSTEM INTERFACE
  ${LAVER_VOLK_INCLUDE} ${LAVER_DEFLATE_INCLUDE} ${LAVER_XXHASH_INCLUDE} ${LAVER_TINYOBJ_INCLUDE}
  ${Vulkan_INCLUDE_DIRS})
target_link_libraries(laver_dependencies INTERFACE
  Threads::Threads glm::glm pugixml::pugixml OpenEXR::OpenEXR OpenEXR::OpenEXRCore
  ${LAVER_DEFLATE} PNG::PNG JPEG::JPEG Boost::headers CLI11::CLI11 fmt::fmt
  nlohmann_json::nlohmann_json PkgConfig::CAIRO ${CMAKE_DL_LIBS})
target_compile_definitions(laver_dependencies INTERFACE VK_NO_PROTOTYPES)
