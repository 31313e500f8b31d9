# Installs the library fiberchain::dem for find_package(fiberchain), and the program with its data.
include(CMakePackageConfigHelpers)

# Public headers: what a user includes, and what these include. Kernels, storage and files' internals are not among them.
set(public_headers
  dem/analysis/observables.hpp
  dem/chain/arc_chain.hpp
  dem/equilibrium/dynamic_relaxation.hpp
  dem/equilibrium/newton.hpp
  dem/flow/integrate_in_flow.hpp
  dem/insertion/random_insertion.hpp
  dem/motion/time_step.hpp
  dem/record/csv.hpp
  dem/run/run_scene.hpp
  dem/run/session.hpp
  dem/scene/build_fiber.hpp
  dem/scene/build_packing.hpp
  dem/trajectory/checkpoint.hpp
  dem/trajectory/h5md.hpp
  dem/vibration/choose.hpp
  dem/vibration/release.hpp)
set(to_read ${public_headers})
while(to_read)
  list(POP_FRONT to_read header)
  file(STRINGS ${PROJECT_SOURCE_DIR}/${header} includes REGEX "^#include \"dem/")
  foreach(include IN LISTS includes)
    string(REGEX REPLACE "^#include \"(.*)\".*" "\\1" included "${include}")
    if(NOT included IN_LIST public_headers)
      list(APPEND public_headers ${included})
      list(APPEND to_read ${included})
    endif()
  endforeach()
endwhile()
foreach(header IN LISTS public_headers)
  get_filename_component(room ${header} DIRECTORY)
  install(FILES ${PROJECT_SOURCE_DIR}/${header} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/fiberchain/${room})
endforeach()

set_target_properties(fiberchain_dem PROPERTIES EXPORT_NAME dem)
install(TARGETS fiberchain_dem EXPORT fiberchain-targets)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/fiberchain)
install(EXPORT fiberchain-targets NAMESPACE fiberchain:: DESTINATION ${package_dir})
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/fiberchain-config.cmake.in
  ${PROJECT_BINARY_DIR}/fiberchain-config.cmake INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/fiberchain-config-version.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/fiberchain-config.cmake ${PROJECT_BINARY_DIR}/fiberchain-config-version.cmake
  DESTINATION ${package_dir})

if(FIBERCHAIN_BUILD_PROGRAM)
  install(TARGETS fiberchain)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/data/ DESTINATION ${CMAKE_INSTALL_DATADIR}/fiberchain)
endif()
