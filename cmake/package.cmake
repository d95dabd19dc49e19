# cpack: one Debian package with program, libraries, headers and Python package.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME beadmesh)
set(CPACK_PACKAGE_VENDOR "beadmesh")
set(CPACK_PACKAGE_CONTACT "The beadmesh developers <beadmesh@users.noreply.github.com>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY ${PROJECT_DESCRIPTION})
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION
" Reads sheet-metal body panels (STEP, IGES, BREP, STL), recognises their beads by the medial axis, and writes quad shell
 meshes for Nastran, LS-DYNA, Abaqus, CalculiX, VTK and Gmsh: nodes on every crest, no edge under the minimum length.
 Program, C++ library and Python package.")
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${PROJECT_BINARY_DIR})
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "python3, python3-numpy")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "libexpected-dev, python3-meshio, python3-matplotlib")
include(CPack)
