# One object library a folder of src/, one test program a folder of tests/.

add_library(knotfit_settings INTERFACE)
target_compile_features(knotfit_settings INTERFACE cxx_std_20)
target_include_directories(knotfit_settings INTERFACE
  ${PROJECT_SOURCE_DIR}/include ${PROJECT_SOURCE_DIR}/src ${PROJECT_BINARY_DIR}/generated)
# No fused multiply-adds behind our back: the same bits whatever the target.
target_compile_options(knotfit_settings INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion -ffp-contract=off)
# GCC 12 at -O3 warns of std::string's own operator+ (its bug 105651).
target_compile_options(knotfit_settings INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>)
if(KNOTFIT_SANITIZE)
  target_compile_options(knotfit_settings INTERFACE -fsanitize=${KNOTFIT_SANITIZE} -fno-omit-frame-pointer
                         -fno-sanitize-recover=all)
  target_link_options(knotfit_settings INTERFACE -fsanitize=${KNOTFIT_SANITIZE})
  target_compile_definitions(knotfit_settings INTERFACE KNOTFIT_SANITIZED)
endif()

if(KNOTFIT_BUILD_FUZZ)
  target_compile_options(knotfit_settings INTERFACE -fsanitize=fuzzer-no-link)
endif()

# knotfit_folder(NAME sources...): src/NAME as the object library knotfit_NAME.
function(knotfit_folder name)
  foreach(source IN LISTS ARGN)
    get_filename_component(path ${source} ABSOLUTE)
    if(NOT EXISTS ${path} AND NOT IS_ABSOLUTE ${source})  # absolute: generated
      message(FATAL_ERROR "src/${name}/${source} is not there")
    endif()
  endforeach()
  add_library(knotfit_${name} OBJECT ${ARGN})
  set_target_properties(knotfit_${name} PROPERTIES POSITION_INDEPENDENT_CODE ON CXX_VISIBILITY_PRESET hidden
    VISIBILITY_INLINES_HIDDEN ON)
  target_link_libraries(knotfit_${name} PRIVATE knotfit_settings)
  set_property(GLOBAL APPEND PROPERTY KNOTFIT_FOLDERS ${name})
endfunction()

# knotfit_test(NAME FOLDERS a b ... SOURCES ... [LINK ...]): tests/NAME as one program over the
# folders it needs; every TEST becomes a ctest entry.
function(knotfit_test name)
  cmake_parse_arguments(arg "" "" "FOLDERS;SOURCES;LINK" ${ARGN})
  foreach(source IN LISTS arg_SOURCES)
    if(NOT EXISTS ${CMAKE_CURRENT_SOURCE_DIR}/${source})
      message(FATAL_ERROR "tests/${name}/${source} is not there")
    endif()
  endforeach()
  foreach(folder IN LISTS arg_FOLDERS)
    if(NOT TARGET knotfit_${folder})
      message(FATAL_ERROR "tests/${name} needs src/${folder}, which is not there")
    endif()
  endforeach()
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
