# The installed libraries: the rooms in two shared ones. The core knows nothing of OpenCASCADE; the CAD reader links it
# dynamically, as its licence wants. The programs of this build link the rooms themselves.
find_package(tl-expected REQUIRED)
include(GNUInstallDirs)

function(beadmesh_shared_library target name)
  cmake_parse_arguments(LIBRARY "" "" "ROOMS;PRIVATELY" ${ARGN})
  list(TRANSFORM LIBRARY_ROOMS REPLACE "(.+)" "$<TARGET_OBJECTS:beadmesh_\\1>")
  add_library(${target} SHARED ${LIBRARY_ROOMS})
  set_target_properties(${target} PROPERTIES OUTPUT_NAME ${name} LINKER_LANGUAGE CXX VERSION ${PROJECT_VERSION}
    SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR} INSTALL_RPATH "$ORIGIN")
  target_include_directories(${target} INTERFACE
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  target_compile_features(${target} INTERFACE cxx_std_20)
  if(NOT BEADMESH_SANITIZE AND NOT BEADMESH_SANITIZE_THREADS AND NOT BEADMESH_FUZZ)
    target_link_options(${target} PRIVATE -Wl,--no-undefined)  # a core that needs the CAD reader fails here
  endif()
  # For the build only: a shared library does not pass these on, but CMake would look for their targets at the user's.
  target_link_libraries(${target} PRIVATE $<BUILD_INTERFACE:beadmesh_options> ${LIBRARY_PRIVATELY})
endfunction()

beadmesh_shared_library(beadmesh_shared beadmesh
  ROOMS core geometry panel read flatten delaunay medial bead blocking mesh write report pipeline
  PRIVATELY $<BUILD_INTERFACE:TBB::tbb> $<BUILD_INTERFACE:fmt::fmt> $<BUILD_INTERFACE:ZLIB::ZLIB>)
target_link_libraries(beadmesh_shared INTERFACE tl::expected)
set_target_properties(beadmesh_shared PROPERTIES EXPORT_NAME core)
add_library(beadmesh::core ALIAS beadmesh_shared)

if(BEADMESH_CAD)
  beadmesh_shared_library(beadmesh_cad_shared beadmesh_cad
    ROOMS cad
    PRIVATELY $<BUILD_INTERFACE:TBB::tbb> $<BUILD_INTERFACE:fmt::fmt> $<BUILD_INTERFACE:${BEADMESH_CAD_KERNEL}>)
  target_link_libraries(beadmesh_cad_shared PUBLIC beadmesh_shared)
  set_target_properties(beadmesh_cad_shared PROPERTIES EXPORT_NAME cad)
  add_library(beadmesh::cad ALIAS beadmesh_cad_shared)
endif()
