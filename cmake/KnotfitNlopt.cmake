# Evolutionary placement by NLopt. Off: the methods are not listed, all else is the same. NLopt's own parts are under
# permissive licences, and Debian's library also holds Luksan's solvers, which knotfit does not call, under the LGPL:
# it is linked as a shared library (docs/decisions/0006-libraries.md).
if(KNOTFIT_WITH_NLOPT)
  pkg_check_modules(nlopt REQUIRED IMPORTED_TARGET nlopt)
endif()
