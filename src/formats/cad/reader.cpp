#include <fmt/format.h>

#include <IFSelect_WorkLibrary.hxx>
#include <IGESControl_Reader.hxx>
#include <IGESData_IGESModel.hxx>
#include <Interface_Check.hxx>
#include <Interface_InterfaceModel.hxx>
#include <Interface_Protocol.hxx>
#include <STEPControl_Reader.hxx>
#include <StepGeom_Curve.hxx>
#include <StepGeom_Pcurve.hxx>
#include <StepRepr_DefinitionalRepresentation.hxx>
#include <StepRepr_RepresentationItem.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopoDS_Shape.hxx>
#include <XSControl_WorkSession.hxx>

#include "formats/cad/occt.h"
#include "formats/file_bytes.h"
#include "knotfit/exceptions.h"
namespace knotfit::cad {
namespace {

/// A representation may hold anything; a curve in parameters is taken to hold a curve.
bool is_curve_of_nothing(const Handle(Standard_Transient) & entity) {
  const auto pcurve = Handle(StepGeom_Pcurve)::DownCast(entity);
  if (pcurve.IsNull() || pcurve->ReferenceToCurve().IsNull()) return false;
  const auto& representation = pcurve->ReferenceToCurve();
  return representation->NbItems() < 1 || representation->ItemsValue(1).IsNull() ||
         !representation->ItemsValue(1)->IsKind(STANDARD_TYPE(StepGeom_Curve));
}

/// OpenCASCADE translates what it could not load as if it had: references lead nowhere, and it crashes.
/// \throws FileError  an entity that could not be loaded; names it and says why
void check_loaded(const Handle(Interface_InterfaceModel) & model, const std::string& path) {
  for (int k = 1; k <= model->NbEntities(); ++k) {
    const Handle(Interface_Check)& check = model->Check(k, true);
    if (is_curve_of_nothing(model->Value(k)))
      throw FileError(path, fmt::format("entity {} (PCURVE) leads to no curve",
                                        model->StringLabel(model->Value(k))->ToCString()));
    if (!check->HasFailed() && !model->IsErrorEntity(k)) continue;
    const Handle(Standard_Transient)& entity = model->Value(k);
    throw FileError(path, fmt::format("entity {} ({}) is damaged: {}",
                                      model->StringLabel(entity)->ToCString(), model->TypeName(entity, false),
                                      check->NbFails() > 0 ? check->CFail(1) : "it could not be read"));
  }
}

/// Reader::ReadFile with the check in its middle: the graph of references that it makes at once crashes on lists that
/// could not be loaded.
template <class Reader>
void load(Reader& reader, const std::string& file, const std::string& path, const char* name) {
  const Handle(XSControl_WorkSession) session = reader.WS();
  Handle(Interface_InterfaceModel) model;
  if (session->WorkLibrary()->ReadFile(file.c_str(), model, session->Protocol()) != 0 || model.IsNull())
    throw FileError(path, fmt::format("OpenCASCADE cannot read it as {}", name));
  check_loaded(model, path);
  session->SetModel(model);
  session->SetLoadedFile(file.c_str());
  session->InitTransferReader(4);
}

template <class Reader>
void read_with(const std::string& file, const std::string& path, const char* name, TopoDS_Shape& shape) {
  Reader reader;
  load(reader, file, path, name);
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

void with_shape_of(const std::string& path, CadUnit unit,
                   const std::function<void(const TopoDS_Shape&)>& take) {
  const FileBytes bytes = load_file(path);
  const FileKind kind = kind_of(bytes.view(), path);
  translating(path, [&] {
    const Session session(unit);
    TopoDS_Shape shape;
    read_shape(path, kind, path, shape);
    take(shape);
  });
}

}  // namespace knotfit::cad
