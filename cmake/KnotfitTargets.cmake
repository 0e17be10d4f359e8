# One object library a folder of src/, one test program a folder of tests/.

add_library(knotfit_settings INTERFACE)
target_compile_features(knotfit_settings INTERFACE cxx_std_20)
target_include_directories(knotfit_settings INTERFACE
  ${PROJECT_SOURCE_DIR}/include ${PROJECT_SOURCE_DIR}/src ${PROJECT_BINARY_DIR}/generated)
# No fused multiply-adds behind our back: the same bits whatever the target.
target_compile_options(knotfit_settings INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion -ffp-contract=off)
if(KNOTFIT_SANITIZE)
  target_compile_options(knotfit_settings INTERFACE -fsanitize=${KNOTFIT_SANITIZE} -fno-omit-frame-pointer
                         -fno-sanitize-recover=all)
  target_link_options(knotfit_settings INTERFACE -fsanitize=${KNOTFIT_SANITIZE})
  target_compile_definitions(knotfit_settings INTERFACE KNOTFIT_SANITIZED)
endif()

# knotfit_folder(NAME sources...): src/NAME as the object library knotfit_NAME.
function(knotfit_folder name)
  set(present)
  foreach(source IN LISTS ARGN)
    get_filename_component(path ${source} ABSOLUTE)
    if(EXISTS ${path} OR IS_ABSOLUTE ${source})
      list(APPEND present ${source})
    else()
      message(WARNING "src/${name}/${source} is not there")
    endif()
  endforeach()
  if(NOT present)
    return()
  endif()
  add_library(knotfit_${name} OBJECT ${present})
  set_target_properties(knotfit_${name} PROPERTIES POSITION_INDEPENDENT_CODE ON CXX_VISIBILITY_PRESET default)
  target_link_libraries(knotfit_${name} PRIVATE knotfit_settings)
  set_property(GLOBAL APPEND PROPERTY KNOTFIT_FOLDERS ${name})
endfunction()

# knotfit_test(NAME FOLDERS a b ... SOURCES ... [LINK ...]): tests/NAME as one program over the
# folders it needs; every TEST becomes a ctest entry.
function(knotfit_test name)
  cmake_parse_arguments(arg "" "" "FOLDERS;SOURCES;LINK" ${ARGN})
  set(program knotfit_test_${name})
  add_executable(${program} ${arg_SOURCES})
  target_include_directories(${program} PRIVATE ${PROJECT_SOURCE_DIR}/tests)
  target_link_libraries(${program} PRIVATE knotfit_settings GTest::gtest_main)
  foreach(folder IN LISTS arg_FOLDERS)
    target_link_libraries(${program} PRIVATE knotfit_${folder})
  endforeach()
  target_link_libraries(${program} PRIVATE ${KNOTFIT_LIBRARIES} ${arg_LINK})
  target_compile_definitions(${program} PRIVATE KNOTFIT_TEST_DATA="${PROJECT_SOURCE_DIR}/tests/data")
  gtest_discover_tests(${program} TEST_PREFIX ${name}. DISCOVERY_TIMEOUT 60 PROPERTIES TIMEOUT 600)
endfunction()
