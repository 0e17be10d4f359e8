#include <fmt/format.h>

#include <IGESControl_Controller.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <STEPControl_Controller.hxx>
#include <Standard_Failure.hxx>
#include <UnitsMethods.hxx>
#include <mutex>
#include <new>
#include <utility>

#include "formats/cad/occt.h"
#include "knotfit/exceptions.h"
namespace knotfit::cad {

struct Session::State {
  std::unique_lock<std::mutex> lock;
  Message_SequenceOfPrinters printers;
  double unit = 1;
  std::vector<std::pair<std::string, std::string>> settings{};  ///< as they were, first changed first
};

namespace {

std::mutex& global_lock() {
  static std::mutex mutex;
  return mutex;
}

}  // namespace

const char* unit_name(CadUnit unit) {
  switch (unit) {
    case CadUnit::metre:
      return "M";
    case CadUnit::inch:
      return "INCH";
    case CadUnit::millimetre:
      break;
  }
  return "MM";
}

Session::Session(CadUnit unit) : state_(new State{.lock = std::unique_lock(global_lock()), .printers = {}}) {
  STEPControl_Controller::Init();
  IGESControl_Controller::Init();
  state_->printers = Message::DefaultMessenger()->Printers();
  Message::DefaultMessenger()->ChangePrinters().Clear();
  state_->unit = UnitsMethods::GetCasCadeLengthUnit();
  use_unit(unit);
  // Surfaces are to come back as they are, not cut where they are only C0.
  set("read.iges.bspline.continuity", "0");
  set("write.step.assembly", "0");
  set("write.surfacecurve.mode", "1");
  set("write.iges.brep.mode", "0");
}

Session::~Session() {
  for (auto setting = state_->settings.rbegin(); setting != state_->settings.rend(); ++setting)
    Interface_Static::SetCVal(setting->first.c_str(), setting->second.c_str());
  UnitsMethods::SetCasCadeLengthUnit(state_->unit);
  Message::DefaultMessenger()->ChangePrinters() = state_->printers;
}

void Session::use_unit(CadUnit unit) {
  // Coordinates in memory, and in files. One of them alone scales by 25.4 or 1000.
  set("xstep.cascade.unit", unit_name(unit));
  set("write.step.unit", unit_name(unit));
  set("write.iges.unit", unit_name(unit));
  UnitsMethods::SetCasCadeLengthUnit(
      UnitsMethods::GetLengthFactorValue(UnitsMethods::LengthUnitFromString(unit_name(unit), false)));
}

void Session::set(const char* name, const std::string& value) {
  state_->settings.emplace_back(name, Interface_Static::CVal(name));
  Interface_Static::SetCVal(name, value.c_str());
}

void translating(const std::string& path, const std::function<void()>& action) {
  try {
    action();
  } catch (const Standard_Failure& failure) {
    throw FileError(path, fmt::format("OpenCASCADE gave up: {} {}", failure.DynamicType()->Name(),
                                      failure.GetMessageString()));
  } catch (const std::bad_alloc&) {
    throw FileError(path, "needs more memory than there is");
  }
}

std::string file_text(const TopoDS_Shape& shape, const CadOptions& options, Session& session) {
  return options.format == CadFormat::iges ? iges_text(shape, options, session)
                                           : step_text(shape, options, session);
}

}  // namespace knotfit::cad
