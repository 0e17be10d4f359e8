# OpenCASCADE for CAD exchange (STEP, IGES), LGPL-2.1 with exception, always the shared libraries:
# KNOTFIT_CAD_LIBRARIES, KNOTFIT_CAD_INCLUDES; both empty without KNOTFIT_WITH_CAD. Its own package
# file wants every module installed, and its targets would have to be found by each project that
# uses the static library; plain libraries need neither.
set(KNOTFIT_CAD_LIBRARIES)
set(KNOTFIT_CAD_INCLUDES)
if(NOT KNOTFIT_WITH_CAD)
  return()
endif()
find_path(KNOTFIT_OCCT_INCLUDE STEPControl_Writer.hxx PATH_SUFFIXES opencascade)
foreach(library TKSTEP TKSTEPBase TKIGES TKXSBase TKTopAlgo TKBRep TKGeomBase TKG3d TKG2d TKMath TKernel)
  find_library(KNOTFIT_OCCT_${library} ${library})
  mark_as_advanced(KNOTFIT_OCCT_${library})
  if(NOT KNOTFIT_OCCT_${library} OR NOT KNOTFIT_OCCT_INCLUDE)
    message(FATAL_ERROR "OpenCASCADE (${library}, for STEP and IGES) was not found: install "
      "libocct-data-exchange-dev (scripts/setup does), or configure with -DKNOTFIT_WITH_CAD=OFF")
  endif()
  list(APPEND KNOTFIT_CAD_LIBRARIES ${KNOTFIT_OCCT_${library}})
endforeach()
mark_as_advanced(KNOTFIT_OCCT_INCLUDE)
set(KNOTFIT_CAD_INCLUDES ${KNOTFIT_OCCT_INCLUDE})
