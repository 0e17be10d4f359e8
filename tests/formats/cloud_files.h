// LAS and PCD files in memory.
#pragma once
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include "support.h"
namespace knotfit::test {

template <class T>
void put(std::string& bytes, std::size_t at, T value) {
  std::memcpy(bytes.data() + at, &value, sizeof value);
}

struct LasPoint {
  std::int32_t x = 0, y = 0, z = 0;
  int number = 1, returns = 1, of_class = 1;
  bool withheld = false;
};

struct LasFile {
  int minor = 2, format = 0;
  std::vector<LasPoint> points{};
  double scale = 0.01, origin[3] = {0, 0, 0};
  std::uint16_t extra = 0;  ///< bytes of the user's own in each record
};

inline std::string las(const LasFile& f) {
  constexpr std::uint16_t record[] = {20, 28, 26, 34, 57, 63, 30, 36, 38, 59, 67};
  const std::size_t header = f.minor == 4 ? 375 : f.minor == 3 ? 235 : 227, gap = 10;
  std::string out(header + gap, '\0');
  out.replace(0, 4, "LASF");
  out[24] = 1;
  out[25] = static_cast<char>(f.minor);
  put(out, 94, static_cast<std::uint16_t>(header));
  put(out, 96, static_cast<std::uint32_t>(header + gap));
  out[104] = static_cast<char>(f.format);
  const auto length = static_cast<std::uint16_t>(record[f.format] + f.extra);
  put(out, 105, length);
  if (f.format < 6) put(out, 107, static_cast<std::uint32_t>(f.points.size()));
  if (f.minor == 4) put(out, 247, static_cast<std::uint64_t>(f.points.size()));
  for (std::size_t c = 0; c < 3; ++c) {
    put(out, 131 + 8 * c, f.scale);
    put(out, 155 + 8 * c, f.origin[c]);
  }
  for (const LasPoint& p : f.points) {
    std::string r(length, '\x55');
    put(r, 0, p.x), put(r, 4, p.y), put(r, 8, p.z);
    if (f.format < 6) {
      r[14] = static_cast<char>(p.number | p.returns << 3);
      r[15] = static_cast<char>(p.of_class | (p.withheld ? 128 : 0));
    } else {
      r[14] = static_cast<char>(p.number | p.returns << 4);
      r[15] = static_cast<char>(p.withheld ? 4 : 0);
      r[16] = static_cast<char>(p.of_class);
    }
    out += r;
  }
  return out;
}

inline std::string pcd_header(const std::string& fields, const std::string& sizes, const std::string& types,
                              const std::string& counts, int width, int height, const std::string& data) {
  return "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS " + fields + "\nSIZE " + sizes +
         "\nTYPE " + types + "\nCOUNT " + counts + "\nWIDTH " + std::to_string(width) + "\nHEIGHT " +
         std::to_string(height) + "\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " + std::to_string(width * height) +
         "\nDATA " + data + "\n";
}

/// Compressed by runs of bytes as they are, and copies where `back` bytes repeat.
inline std::string lzf_literal(const std::string& bytes) {
  std::string out;
  for (std::size_t at = 0; at < bytes.size(); at += 32) {
    const std::string run = bytes.substr(at, 32);
    out += static_cast<char>(run.size() - 1) + run;
  }
  return out;
}

inline std::string pcd_compressed(const std::string& packed, std::size_t size) {
  std::string out(8, '\0');
  put(out, 0, static_cast<std::uint32_t>(packed.size()));
  put(out, 4, static_cast<std::uint32_t>(size));
  return out + packed;
}

}  // namespace knotfit::test
