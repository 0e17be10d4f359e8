# Builds and runs the consumer with what pkg-config says, without CMake's package files.
set(ENV{PKG_CONFIG_PATH} ${PREFIX}/${LIBDIR}/pkgconfig)
set(flags)
if(KIND STREQUAL static)
  set(flags --static)
endif()
execute_process(COMMAND ${PKG_CONFIG} ${flags} --cflags --libs knotfit
  OUTPUT_VARIABLE arguments OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
separate_arguments(arguments UNIX_COMMAND "${arguments}")
execute_process(COMMAND ${CXX} -std=c++20 ${SOURCE} ${arguments} -Wl,-rpath,${PREFIX}/${LIBDIR} -o ${PROGRAM}
  COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${PROGRAM} COMMAND_ERROR_IS_FATAL ANY)

execute_process(COMMAND ldd ${PROGRAM} OUTPUT_VARIABLE loaded COMMAND_ERROR_IS_FATAL ANY)
if(KIND STREQUAL static AND loaded MATCHES "libknotfit")
  message(FATAL_ERROR "the static consumer loads libknotfit.so:\n${loaded}")
elseif(KIND STREQUAL shared AND NOT loaded MATCHES "libknotfit")
  message(FATAL_ERROR "the shared consumer does not load libknotfit.so:\n${loaded}")
endif()
