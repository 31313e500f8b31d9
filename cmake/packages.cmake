# `cpack -G DEB` makes Debian packages of what is installed: the program with its data, the library with its headers, the
# Python module. `.ci/package` makes them and tries them on a bare machine.
set(CPACK_PACKAGE_CONTACT "Fiberchain developers <fiberchain@localhost>")
set(CPACK_PACKAGE_VENDOR Fiberchain)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL program dem calibration python)
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SECTION science)

# fiberchain_package(GROUP NAME [key value]...): the Debian package of a group of components.
function(fiberchain_package group name)
  string(TOUPPER ${group} key)
  set(CPACK_DEBIAN_${key}_PACKAGE_NAME ${name} PARENT_SCOPE)
  while(ARGN)
    list(POP_FRONT ARGN setting value)
    set(CPACK_DEBIAN_${key}_${setting} ${value} PARENT_SCOPE)
  endwhile()
endfunction()
fiberchain_package(program fiberchain PACKAGE_RECOMMENDS gnuplot-nox)
# what find_package(fiberchain) and the headers want
fiberchain_package(library libfiberchain-dev PACKAGE_SECTION libdevel PACKAGE_DEPENDS
  "libboost-dev, libeigen3-dev, libfmt-dev, libgsl-dev, libhdf5-dev, libssl-dev, libsundials-dev, libudunits2-dev, libyaml-cpp-dev, pkg-config, zlib1g-dev")
fiberchain_package(python python3-fiberchain PACKAGE_SECTION python PACKAGE_DEPENDS "python3, python3-numpy, fiberchain")
set(CPACK_COMPONENT_PROGRAM_GROUP program)
set(CPACK_COMPONENT_DEM_GROUP library)
set(CPACK_COMPONENT_CALIBRATION_GROUP library)
set(CPACK_COMPONENT_PYTHON_GROUP python)
include(CPack)
