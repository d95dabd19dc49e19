# What `cmake --install` puts where, by component: core, cad, program, python.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(BEADMESH_CMAKE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/beadmesh)

# ---- headers: all but those that say in their first line that they are a room's own; the CAD reader's with it
set(cad_headers read/panel_reader.h)
file(GLOB_RECURSE headers RELATIVE ${PROJECT_SOURCE_DIR}/src/beadmesh CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/beadmesh/*.h)
foreach(header ${headers})
  file(STRINGS ${PROJECT_SOURCE_DIR}/src/beadmesh/${header} first LIMIT_COUNT 1)
  if(first MATCHES "^// (Inside the|Internal to|Private to)")
    continue()
  endif()
  cmake_path(GET header PARENT_PATH folder)
  set(component core)
  if(header IN_LIST cad_headers)
    set(component cad)
  endif()
  install(FILES ${PROJECT_SOURCE_DIR}/src/beadmesh/${header}
    DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/beadmesh/${folder} COMPONENT ${component})
endforeach()

# ---- libraries and the package for find_package
function(beadmesh_install_library target component)
  install(TARGETS ${target} EXPORT beadmesh-${component}
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT ${component})
  install(EXPORT beadmesh-${component} NAMESPACE beadmesh:: DESTINATION ${BEADMESH_CMAKE_DIR} COMPONENT ${component})
endfunction()

beadmesh_install_library(beadmesh_shared core)
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/beadmeshConfig.cmake.in ${PROJECT_BINARY_DIR}/beadmeshConfig.cmake
  INSTALL_DESTINATION ${BEADMESH_CMAKE_DIR} NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/beadmeshConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/beadmeshConfig.cmake ${PROJECT_BINARY_DIR}/beadmeshConfigVersion.cmake
  DESTINATION ${BEADMESH_CMAKE_DIR} COMPONENT core)
install(FILES LICENSE THIRD_PARTY.md DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT core)
if(NOT BEADMESH_CAD)
  return()
endif()
beadmesh_install_library(beadmesh_cad_shared cad)

# ---- the program, its manual page and its completions
install(TARGETS beadmesh_app RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program)
set(manual ${PROJECT_BINARY_DIR}/beadmesh.1)
add_custom_command(OUTPUT ${manual} DEPENDS beadmesh_app ${PROJECT_SOURCE_DIR}/scripts/manual_page.py
  COMMAND ${Python_EXECUTABLE} ${PROJECT_SOURCE_DIR}/scripts/manual_page.py $<TARGET_FILE:beadmesh_app> ${manual}
  COMMENT "Manual page from the program's help")
add_custom_target(beadmesh_manual ALL DEPENDS ${manual})
install(FILES ${manual} DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT program)
install(FILES packaging/beadmesh.bash RENAME beadmesh COMPONENT program
  DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
install(FILES packaging/_beadmesh DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions COMPONENT program)
install(FILES packaging/beadmesh.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d COMPONENT program)

# ---- the Python package
if(BEADMESH_PYTHON)
  set(BEADMESH_PYTHON_DIR lib/python3/dist-packages CACHE STRING "Folder of Python packages, below the prefix")
  install(TARGETS beadmesh_python LIBRARY DESTINATION ${BEADMESH_PYTHON_DIR}/beadmesh COMPONENT python)
  install(DIRECTORY python/beadmesh DESTINATION ${BEADMESH_PYTHON_DIR} COMPONENT python
    FILES_MATCHING PATTERN "*.py" PATTERN "*.pyi" PATTERN "py.typed" PATTERN "__pycache__" EXCLUDE)
endif()
