#include "help_text.h"

#include "knotfit/place.h"
namespace knotfit::tool {

std::string wrap(std::string_view text, std::size_t width) {
  std::string out;
  std::size_t column = 0;
  std::string_view rest = text;
  while (!rest.empty()) {
    const std::size_t end = rest.find_first_of(" \n");
    const std::string_view word = rest.substr(0, end);
    if (column > 0 && column + 1 + word.size() > width) {
      out += '\n';
      column = 0;
    }
    if (column > 0) {
      out += ' ';
      ++column;
    }
    out += word;
    column += word.size();
    if (end == std::string_view::npos) break;
    if (rest[end] == '\n') {
      out += '\n';
      column = 0;
    }
    rest.remove_prefix(end + 1);
  }
  return out;
}

std::string examples(std::string_view command) {
  const std::string face = "  knotfit fit samples/face.uv.csv --tol 5% -o face.json -o face.png\n";
  const std::string terrain =
      "  knotfit fit samples/jacksboro.asc --tol 5% --within 99.5% -o terrain.json -o terrain.asc\n";
  std::string text = "Examples (from the project's root, in this order):\n";
  if (command.empty())
    text += face + terrain + "  knotfit eval terrain.json --at -84.2,36.6 --derivatives 1\n" +
            "  knotfit info samples/face.uv.csv\n" + "  knotfit convert face.json -o face.svg\n";
  else if (command == "fit")
    text += face + terrain + "  knotfit fit samples/jacksboro.asc --control-points 40x30 -o fixed.json\n" +
            "  knotfit fit samples/face.uv.csv --options face.json -o again.json -o residuals.csv\n" +
            "  knotfit fit samples/face.uv.csv --knots-from face.json -o given.json --json\n";
  else if (command == "eval")
    text += face + terrain + "  knotfit eval face.json --at 0.25,0.5 --normals --curvature\n" +
            "  knotfit eval terrain.json --at -84.2,36.6 --derivatives 1\n" +
            "  knotfit eval face.json --grid 50x50 -o grid.csv\n" +
            "  knotfit eval face.json --points samples/face.uv.csv -o differences.csv\n";
  else if (command == "compare")
    text += std::string(
                "  knotfit compare samples/face.uv.csv --sizes 12x12,20x20 --methods "
                "nktp,dominant,error-model -o report\n") +
            "  knotfit compare samples/jacksboro.asc --tolerances 5% --within 99.5% --methods "
            "uniform,error-model --json\n";
  else if (command == "fit-curve")
    text += std::string(
                "  knotfit fit-curve samples/blade_profile.csv --closed --tol 0.1% -o blade.json -o "
                "blade.svg\n") +
            "  knotfit fit-curve samples/blade_profile.csv --closed --control-points 24 --compare all\n";
  else if (command == "parameterize")
    text += std::string("  knotfit parameterize samples/face.obj -o face.csv -o face.vt.obj\n") +
            "  knotfit parameterize samples/face.obj -o face.png --lines 30\n" +
            "  knotfit parameterize samples/face.obj --corners sharpest --omega 0 --json\n" +
            "  knotfit fit face.csv --tol 5% -o face.json\n";
  else if (command == "distance")
    text += face + "  knotfit distance face.json samples/face.obj -o distances.csv\n" +
            "  knotfit distance face.json samples/face.uv.csv --tol 10% --json\n";
  else if (command == "info")
    text += face + "  knotfit info face.json\n  knotfit info samples/jacksboro.asc --json\n";
  else if (command == "convert")
    text += face + terrain + "  knotfit convert face.json -o face.svg\n" +
            "  knotfit convert terrain.json --cell 0.005 -o coarse.asc\n" +
            "  knotfit convert face.json --grid 100x100 -o samples.csv\n" +
            "  knotfit convert samples/jacksboro.asc -o jacksboro.csv\n";
  return text;
}

std::string exit_statuses() {
  return "Exit status: 0 reached, or done where no tolerance was asked; 3 written, but below what was\n"
         "asked; 2 bad input or usage; 130 stopped (the best surface so far is written); 1 anything else.\n";
}

std::string method_names() {
  std::string names;
  for (const PlacementMethod& method : placement_methods()) {
    if (!names.empty()) names += ", ";
    names += method.name;
  }
  return names;
}

}  // namespace knotfit::tool
