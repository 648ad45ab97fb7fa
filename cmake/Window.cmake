# The window of --gui and `laver view`, if GLFW and Dear ImGui are installed. It does not depend on
# Vulkan: of laver_base it uses only host/show/ and host/image/.
find_package(glfw3 3.3 QUIET)
find_package(OpenGL QUIET)
find_path(LAVER_IMGUI_INCLUDE backends/imgui_impl_opengl3.h PATH_SUFFIXES imgui)
find_library(LAVER_IMGUI imgui)
find_library(LAVER_STB stb)  # Debian builds Dear ImGui without its copy
if(glfw3_FOUND AND OpenGL_FOUND AND LAVER_IMGUI_INCLUDE AND LAVER_IMGUI
   AND LAVER_STB)
  set(LAVER_HAS_WINDOW ON)
  add_library(laver_window STATIC host/show/window.cpp host/show/panels.cpp)
  target_include_directories(laver_window SYSTEM PRIVATE ${LAVER_IMGUI_INCLUDE})
  target_link_libraries(laver_window PRIVATE ${LAVER_IMGUI} ${LAVER_STB} glfw OpenGL::GL ${CMAKE_DL_LIBS})
else()
  set(LAVER_HAS_WINDOW OFF)
  message(STATUS "No libglfw3-dev or libimgui-dev: laver is built without a window")
  add_library(laver_window STATIC host/show/no_window.cpp)
endif()
target_include_directories(laver_window PRIVATE host)
target_link_libraries(laver_window PRIVATE fmt::fmt glm::glm laver_warnings
                                           $<LINK_ONLY:laver_base>)
target_link_libraries(laver_base PRIVATE laver_window)
