// In place of CAD exchange where knotfit is built without OpenCASCADE.
#include "knotfit/cad.h"
#include "knotfit/curve_io.h"
#include "knotfit/exceptions.h"
namespace knotfit {
namespace {

[[noreturn]] void refuse(const std::string& path) {
  throw InvalidInput(path +
                     ": this knotfit was built without CAD exchange (STEP, IGES); build it with OpenCASCADE "
                     "and -DKNOTFIT_WITH_CAD=ON");
}

}  // namespace

bool cad_available() {
  return false;
}

void write_cad(const std::string& path, const std::vector<Surface>&, const CadOptions&, bool) {
  refuse(path);
}

std::vector<CadFace> read_cad_faces(const std::string& path, CadUnit) {
  refuse(path);
}

std::vector<Surface> read_cad(const std::string& path, CadUnit) {
  refuse(path);
}

void write_cad_curve(const std::string& path, const Curve&, const CadOptions&, bool) {
  refuse(path);
}

std::vector<Curve> read_cad_curves(const std::string& path, CadUnit) {
  refuse(path);
}

}  // namespace knotfit
