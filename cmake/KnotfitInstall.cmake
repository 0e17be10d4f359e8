# cmake --install: the libraries, their headers, the tool, find_package(knotfit) and pkg-config.
# Components: runtime (shared library, tool, man page); development (headers, package files; goes
# with runtime); static (the archive and its targets; goes with development).
include(CMakePackageConfigHelpers)

set(KNOTFIT_CMAKE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/knotfit)

# An export set a kind, since only the static one needs the other libraries to be found.
install(TARGETS knotfit_shared EXPORT knotfit-shared
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT runtime NAMELINK_COMPONENT development)
install(EXPORT knotfit-shared NAMESPACE knotfit:: FILE knotfit-shared.cmake
  DESTINATION ${KNOTFIT_CMAKE_DIR} COMPONENT development)
install(TARGETS knotfit_static EXPORT knotfit-static
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT static)
install(EXPORT knotfit-static NAMESPACE knotfit:: FILE knotfit-static.cmake
  DESTINATION ${KNOTFIT_CMAKE_DIR} COMPONENT static)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/knotfit
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development FILES_MATCHING PATTERN "*.h")

configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/knotfit-config.cmake.in
  ${PROJECT_BINARY_DIR}/generated/knotfit-config.cmake INSTALL_DESTINATION ${KNOTFIT_CMAKE_DIR})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/generated/knotfit-config-version.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/generated/knotfit-config.cmake
  ${PROJECT_BINARY_DIR}/generated/knotfit-config-version.cmake
  DESTINATION ${KNOTFIT_CMAKE_DIR} COMPONENT development)

# knotfit.pc finds its prefix from where it lies, so that an installed tree can be moved.
file(RELATIVE_PATH KNOTFIT_PC_PREFIX
  ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_PREFIX})
string(REGEX REPLACE "/$" "" KNOTFIT_PC_PREFIX "${KNOTFIT_PC_PREFIX}")
set(KNOTFIT_PC_LIBS)
foreach(library IN LISTS LAPACK_LIBRARIES KNOTFIT_CAD_LIBRARIES)
  if(library MATCHES "^-")
    string(APPEND KNOTFIT_PC_LIBS " ${library}")
  else()
    get_filename_component(name ${library} NAME_WE)
    string(REGEX REPLACE "^lib" "" name ${name})
    string(APPEND KNOTFIT_PC_LIBS " -l${name}")
  endif()
endforeach()
set(KNOTFIT_PC_NLOPT)
if(KNOTFIT_WITH_NLOPT)
  set(KNOTFIT_PC_NLOPT ", nlopt")
endif()
configure_file(${CMAKE_CURRENT_LIST_DIR}/knotfit.pc.in ${PROJECT_BINARY_DIR}/generated/knotfit.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/generated/knotfit.pc
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT development)

install(FILES ${PROJECT_SOURCE_DIR}/LICENSE
  DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT runtime)
if(TARGET knotfit_tool)
  install(TARGETS knotfit_tool RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT runtime)
  # Completions go where each shell looks for them; a file a shell, named as the shell wants it.
  foreach(place
      "knotfit.1|${CMAKE_INSTALL_MANDIR}/man1"
      "knotfit.bash|${CMAKE_INSTALL_DATADIR}/bash-completion/completions|knotfit"
      "_knotfit|${CMAKE_INSTALL_DATADIR}/zsh/site-functions"
      "knotfit.fish|${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d")
    string(REPLACE "|" ";" place ${place})
    list(GET place 0 name)
    set(file ${PROJECT_BINARY_DIR}/tool/pages/${name})
    list(GET place 1 folder)
    list(LENGTH place parts)
    if(parts GREATER 2)
      list(GET place 2 name)
    endif()
    install(FILES ${file} DESTINATION ${folder} RENAME ${name} COMPONENT runtime)
  endforeach()
endif()
