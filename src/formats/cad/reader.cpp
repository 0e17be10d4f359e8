#include <fmt/format.h>

#include <IGESControl_Reader.hxx>
#include <IGESData_GlobalSection.hxx>
#include <IGESData_IGESModel.hxx>
#include <STEPControl_Reader.hxx>
#include <TopoDS_Shape.hxx>

#include "formats/cad/occt.h"
#include "knotfit/errors.h"
namespace knotfit::cad {
namespace {

template <class Reader>
void read_with(const std::string& file, const std::string& path, const char* name, TopoDS_Shape& shape) {
  Reader reader;
  const IFSelect_ReturnStatus status = reader.ReadFile(file.c_str());
  if (status != IFSelect_RetDone)
    throw FileError(path, fmt::format("OpenCASCADE cannot read it as {}", name));
  reader.TransferRoots();
  if (reader.NbShapes() == 0) throw FileError(path, "holds no B-spline surface: no shape at all");
  shape = reader.OneShape();
}

}  // namespace

void read_shape(const std::string& file, FileKind kind, const std::string& path, TopoDS_Shape& shape) {
  if (kind == FileKind::step)
    read_with<STEPControl_Reader>(file, path, "STEP", shape);
  else
    read_with<IGESControl_Reader>(file, path, "IGES", shape);
}

}  // namespace knotfit::cad
