// What the files of this folder pass each other. OpenCASCADE's headers stay in the .cpp files.
#pragma once
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "knotfit/cad.h"
class TopoDS_Shape;
namespace knotfit::cad {

/// OpenCASCADE for one call: its settings, unit and messages are global. One at a time holds them, silences the
/// messages, sets what is needed and puts all of it back.
class Session {
 public:
  explicit Session(CadUnit unit);
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;
  /// Coordinates in memory and in files are in this unit from now on.
  void use_unit(CadUnit unit);
  /// A setting by OpenCASCADE's name, until the session ends.
  void set(const char* name, const std::string& value);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Does the action; what OpenCASCADE throws, which is no std::exception, becomes a FileError.
void translating(const std::string& path, const std::function<void()>& action);

/// "MM", "M", "INCH": OpenCASCADE's names.
const char* unit_name(CadUnit unit);

/// One face a surface, sewn where they meet.
/// \throws InvalidInput  not in R^3, a jump inside, or no valid face comes of it; names the surface
void build_shape(const std::vector<Surface>& surfaces, TopoDS_Shape& shape);

/// The faces, in their order.
std::vector<CadFace> faces_of(const TopoDS_Shape& shape);
/// The surfaces of the usable ones. \throws FileError  there is none: says why
std::vector<Surface> usable_surfaces(const std::vector<CadFace>& faces, const std::string& path);
std::vector<Surface> surfaces_of(const TopoDS_Shape& shape, const std::string& path);

/// Every face of the shape is valid. \param faces  how many there are
bool is_valid(const TopoDS_Shape& shape, Index& faces);

/// The file's whole text.
std::string step_text(const TopoDS_Shape& shape, const CadOptions& options, Session& session);
std::string iges_text(const TopoDS_Shape& shape, const CadOptions& options, Session& session);
/// In the format of the options.
std::string file_text(const TopoDS_Shape& shape, const CadOptions& options, Session& session);

/// Numbers as short as they read back exactly, letters beyond ASCII as ISO 10303-21 wants them.
std::string tidy_step(std::string_view text);

enum class FileKind { step, iges };
/// \throws FileError  neither, or cut off
FileKind kind_of(std::string_view bytes, const std::string& path);

/// The shapes of a file, in the session's unit. \param unit  the file's own
/// \throws FileError  unreadable, or without a shape
void read_shape(const std::string& file, FileKind kind, const std::string& path, TopoDS_Shape& shape);
/// Takes what it wants of the shapes of a file, in a session of this unit.
/// \throws FileError  see read_shape(), translating(), kind_of()
void with_shape_of(const std::string& path, CadUnit unit,
                   const std::function<void(const TopoDS_Shape&)>& take);
/// The unit a file says it is in.
/// \throws FileError  it names none of the three
CadUnit unit_of(std::string_view bytes, FileKind kind, const std::string& path);

}  // namespace knotfit::cad
