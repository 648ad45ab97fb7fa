# `cmake --install` and, by `cpack`, a Debian package.
include(GNUInstallDirs)
install(TARGETS laver)
install(FILES README.md LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} RENAME copyright)  # Debian's name for it

# The ready scenes without the bunny, which comes from glmark2-data.
file(GLOB LAVER_OWN_SCENES CONFIGURE_DEPENDS scenes/*.xml)
list(FILTER LAVER_OWN_SCENES EXCLUDE REGEX bunny)
install(FILES ${LAVER_OWN_SCENES} DESTINATION ${CMAKE_INSTALL_DATADIR}/laver/scenes)
install(FILES ${LAVER_MADE_MESHES} DESTINATION ${CMAKE_INSTALL_DATADIR}/laver/scenes/meshes)
install(FILES ${LAVER_MADE_IMAGES} DESTINATION ${CMAKE_INSTALL_DATADIR}/laver/scenes/images)

set(CPACK_GENERATOR DEB)
set(CPACK_STRIP_FILES ON)
set(CPACK_PACKAGE_CONTACT "The laver authors <laver@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_PACKAGE_DESCRIPTION
"laver reads Nori's XML scenes, traces them in Vulkan compute shaders on a GPU or,
by Mesa's lavapipe, on a CPU, and writes OpenEXR and PNG. It needs no window. A
double-precision reference renderer and a comparison command say how far a picture
is from the truth.")
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# The Vulkan loader is opened at run time, so dpkg-shlibdeps does not detect it.
set(CPACK_DEBIAN_PACKAGE_DEPENDS libvulkan1)
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS mesa-vulkan-drivers)
include(CPack)
