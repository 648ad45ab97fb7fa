# scenes/meshes/: the meshes of scenes/make_meshes.cpp, and the bunny of Debian's glmark2-data.
find_file(LAVER_BUNNY bunny.obj PATHS /usr/share/glmark2/models NO_DEFAULT_PATH)
if(NOT LAVER_BUNNY)
  message(FATAL_ERROR "The ready scenes need /usr/share/glmark2/models/bunny.obj: "
                      "install the package glmark2-data, or name the file with -DLAVER_BUNNY=FILE.")
endif()

set(LAVER_MESH_FOLDER ${CMAKE_SOURCE_DIR}/scenes/meshes)
set(LAVER_MADE_MESHES plane sheet block room room-left room-right torus wavy-sphere trefoil)
list(TRANSFORM LAVER_MADE_MESHES PREPEND ${LAVER_MESH_FOLDER}/)
list(TRANSFORM LAVER_MADE_MESHES APPEND .obj)

add_executable(make_meshes scenes/make_meshes.cpp)
target_link_libraries(make_meshes PRIVATE laver_warnings)
add_custom_command(
  OUTPUT ${LAVER_MADE_MESHES}
  COMMAND make_meshes ${LAVER_MESH_FOLDER}
  DEPENDS make_meshes
  COMMENT "Making the meshes of the ready scenes"
  VERBATIM)
add_custom_command(
  OUTPUT ${LAVER_MESH_FOLDER}/bunny.obj
  COMMAND ${CMAKE_COMMAND} -E make_directory ${LAVER_MESH_FOLDER}
  COMMAND ${CMAKE_COMMAND} -E copy ${LAVER_BUNNY} ${LAVER_MESH_FOLDER}/bunny.obj
  DEPENDS ${LAVER_BUNNY}
  COMMENT "Copying the bunny of the ready scenes"
  VERBATIM)

# scenes/images/: the images of scenes/make_images.cpp.
set(LAVER_IMAGE_FOLDER ${CMAKE_SOURCE_DIR}/scenes/images)
set(LAVER_MADE_IMAGES ${LAVER_IMAGE_FOLDER}/waves.png ${LAVER_IMAGE_FOLDER}/sky.exr)
add_executable(make_images scenes/make_images.cpp)
target_link_libraries(make_images PRIVATE laver_base laver_warnings)
add_custom_command(
  OUTPUT ${LAVER_MADE_IMAGES}
  COMMAND make_images ${LAVER_IMAGE_FOLDER}
  DEPENDS scenes/make_images.cpp
  COMMENT "Making the pictures of the ready scenes"
  VERBATIM)
add_custom_target(laver_meshes ALL
  DEPENDS ${LAVER_MADE_MESHES} ${LAVER_MESH_FOLDER}/bunny.obj ${LAVER_MADE_IMAGES})
