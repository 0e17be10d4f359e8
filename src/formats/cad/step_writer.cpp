#include <APIHeaderSection_MakeHeader.hxx>
#include <STEPControl_Writer.hxx>
#include <StepBasic_Product.hxx>
#include <StepData_Protocol.hxx>
#include <StepData_StepModel.hxx>
#include <StepData_StepWriter.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopoDS_Shape.hxx>
#include <sstream>
#include <stdexcept>

#include "formats/cad/occt.h"
#include "knotfit/version.h"
namespace knotfit::cad {
namespace {

Handle(TCollection_HAsciiString) text(const std::string& s) {
  return new TCollection_HAsciiString(s.c_str());
}

void write_header(const Handle(StepData_StepModel) & model, const CadOptions& options, bool curve) {
  APIHeaderSection_MakeHeader header(model);
  header.SetName(text(options.name));
  header.SetTimeStamp(text(options.time_stamp));
  header.SetAuthorValue(1, text(""));
  header.SetOrganizationValue(1, text(""));
  header.SetOriginatingSystem(text("knotfit " + std::string(version())));
  header.SetAuthorisation(text(""));
  header.SetDescriptionValue(1, text(curve ? "B-spline curve" : "B-spline surface"));
  header.Apply(model);
}

}  // namespace

std::string step_text(const TopoDS_Shape& shape, const CadOptions& options, Session& session) {
  session.set("write.step.schema", options.format == CadFormat::step_ap214 ? "AP214IS" : "AP242DIS");
  STEPControl_Writer writer;
  if (writer.Transfer(shape, STEPControl_AsIs) != IFSelect_RetDone)
    throw std::runtime_error("OpenCASCADE did not translate the surface to STEP");
  const Handle(StepData_StepModel) model = writer.Model();
  write_header(model, options, shape.ShapeType() == TopAbs_EDGE);
  for (int k = 1; k <= model->NbEntities(); ++k) {
    const auto product = Handle(StepBasic_Product)::DownCast(model->Entity(k));
    if (product.IsNull()) continue;
    product->SetId(text(options.name));
    product->SetName(text(options.name));
  }
  StepData_StepWriter lines(model);
  // 17 digits read back exactly. OpenCASCADE's own removal of zeros loses the exponent of so many.
  lines.FloatWriter().SetFormat("%.16E");
  lines.FloatWriter().SetZeroSuppress(false);
  lines.SendModel(Handle(StepData_Protocol)::DownCast(model->Protocol()));
  std::ostringstream out;
  if (!lines.Print(out)) throw std::runtime_error("OpenCASCADE did not write the STEP file");
  return tidy_step(out.str());
}

}  // namespace knotfit::cad
