# Debian packages by `cpack -G DEB` in the build folder: knotfit (tool and shared library), libknotfit-dev (headers, archive,
# package files) and, with KNOTFIT_BUILD_PYTHON, python3-knotfit for Debian's interpreter. scripts/debian makes and tries them.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "The knotfit maintainers")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_HOMEPAGE "")
set(CPACK_COMPONENTS_ALL runtime development static)

set(CPACK_DEBIAN_TOOL_PACKAGE_NAME knotfit)
set(CPACK_DEBIAN_TOOL_PACKAGE_SECTION science)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_NAME libknotfit-dev)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SHLIBDEPS OFF)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_DEPENDS "knotfit (= ${PROJECT_VERSION})")
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SUGGESTS "libtbb-dev, libopenblas-dev, libfmt-dev, libcairo2-dev, libnlopt-dev")
set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-knotfit)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
if(KNOTFIT_BUILD_PYTHON)
  list(APPEND CPACK_COMPONENTS_ALL python-debian)
  list(GET KNOTFIT_PYTHON_VERSION 0 major)
  list(GET KNOTFIT_PYTHON_VERSION 1 minor)
  math(EXPR next "${minor} + 1")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
    "python3 (>= ${major}.${minor}), python3 (<< ${major}.${next}), python3-numpy")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "python3-scipy, python3-matplotlib, python3-sklearn")
endif()

include(CPack)
cpack_add_component_group(tool DESCRIPTION
  "B-spline surfaces with the fewest control points that meet a tolerance: command-line tool")
cpack_add_component_group(library DESCRIPTION
  "B-spline surfaces with the fewest control points that meet a tolerance: headers and libraries")
cpack_add_component_group(python DESCRIPTION
  "B-spline surfaces with the fewest control points that meet a tolerance: Python package")
cpack_add_component(runtime GROUP tool)
cpack_add_component(development GROUP library)
cpack_add_component(static GROUP library)
cpack_add_component(python-debian GROUP python)
