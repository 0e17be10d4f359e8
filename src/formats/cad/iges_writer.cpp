#include <IGESBasic_Name.hxx>
#include <IGESControl_Writer.hxx>
#include <IGESData_GlobalSection.hxx>
#include <IGESData_IGESEntity.hxx>
#include <IGESData_IGESModel.hxx>
#include <IGESData_IGESWriter.hxx>
#include <IGESData_Protocol.hxx>
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

/// IGES knows ASCII only; a character of more bytes is one '?'.
std::string ascii(const std::string& s) {
  std::string out;
  for (const char c : s) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x20 && byte < 0x7F)
      out += c;
    else if (byte < 0x80 || byte >= 0xC0)
      out += '?';
  }
  return out;
}

/// 15Hyyyymmdd.hhmmss from ISO 8601.
std::string iges_date(const std::string& time_stamp) {
  std::string digits;
  for (const char c : time_stamp)
    if (c >= '0' && c <= '9') digits += c;
  digits.resize(14, '0');
  return digits.substr(0, 8) + "." + digits.substr(8);
}

/// Flags 2, 6, 1 and their names [IGES 5.3, 2.2.4.3.14].
int unit_flag(CadUnit unit) {
  return unit == CadUnit::millimetre ? 2 : unit == CadUnit::metre ? 6 : 1;
}

}  // namespace

std::string iges_text(const TopoDS_Shape& shape, const CadOptions& options, Session& session) {
  // Translated as millimetres to millimetres, so that no coordinate is scaled; the unit is named afterwards.
  session.use_unit(CadUnit::millimetre);
  IGESControl_Writer writer("MM", 0);
  if (!writer.AddShape(shape)) throw std::runtime_error("OpenCASCADE did not translate the surface to IGES");
  const std::string name = ascii(options.name);
  const Handle(IGESData_IGESModel) model = writer.Model();
  const int entities = model->NbEntities();
  for (int k = 1; k <= entities; ++k) {
    const Handle(IGESData_IGESEntity) entity = model->Entity(k);
    if (entity->TypeNumber() != 144) continue;
    entity->SetLabel(text(name.substr(0, 8)));
    const Handle(IGESBasic_Name) property = new IGESBasic_Name;
    property->Init(1, text(name));
    model->AddEntity(property);
    entity->AddProperty(property);
  }
  writer.ComputeModel();
  IGESData_GlobalSection header = model->GlobalSection();
  header.SetUnitFlag(unit_flag(options.unit));
  header.SetUnitName(text(unit_name(options.unit)));
  header.SetSendName(text(name));
  header.SetReceiveName(text(name));
  header.SetFileName(text(name));
  header.SetSystemId(text("knotfit " + std::string(version())));
  header.SetAuthorName(text(""));
  header.SetCompanyName(text(""));
  header.SetDate(text(iges_date(options.time_stamp)));
  header.SetLastChangeDate(text(iges_date(options.time_stamp)));
  model->SetGlobalSection(header);
  IGESData_IGESWriter lines(model);
  lines.FloatWriter().SetFormat("%.16E");
  lines.FloatWriter().SetZeroSuppress(false);
  lines.SendModel(Handle(IGESData_Protocol)::DownCast(model->Protocol()));
  session.use_unit(options.unit);
  std::ostringstream out;
  if (!lines.Print(out)) throw std::runtime_error("OpenCASCADE did not write the IGES file");
  return out.str();
}

}  // namespace knotfit::cad
