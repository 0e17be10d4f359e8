// knotfit_pages TEMPLATE FOLDER: writes the man page and the completions of shells, as installed, into the folder.
#include "pages.h"

#include <cstdio>
#include <exception>
#include <fstream>
#include <iterator>

#include "knotfit/exceptions.h"
namespace {

void write(const std::string& path, const std::string& text) {
  std::ofstream out(path, std::ios::binary);
  out << text;
  if (!out.flush()) throw knotfit::WriteError(path, "writing failed");
}

std::string read(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) throw knotfit::FileError(path, "cannot be read");
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

int main(int argc, char** argv) {
  using namespace knotfit::tool;
  if (argc != 3) {
    std::fprintf(stderr, "knotfit_pages TEMPLATE FOLDER\n");
    return 2;
  }
  try {
    const std::string folder = std::string(argv[2]) + "/";
    write(folder + "knotfit.1", man_page(read(argv[1])));
    write(folder + "knotfit.bash", bash_completion());
    write(folder + "_knotfit", zsh_completion());
    write(folder + "knotfit.fish", fish_completion());
  } catch (const std::exception& e) {
    std::fprintf(stderr, "knotfit_pages: %s\n", e.what());
    return 1;
  }
  return 0;
}
