// Damaged meshes: an error or a right result, and never more memory than the file's size allows.
#include <fmt/format.h>

#include "allocation_watch.h"
#include "knotfit/mesh_io.h"
#include "support.h"
namespace knotfit::test {
namespace {

struct Sample {
  std::string name, bytes;
};

std::vector<Sample> samples() {
  Mesh m;
  for (int j = 0; j < 5; ++j)
    for (int i = 0; i < 5; ++i) {
      m.vertices.insert(m.vertices.end(), {i * 0.25, j * 0.25, std::sin(i + j)});
      m.uv.insert(m.uv.end(), {i * 0.25, j * 0.25});
    }
  for (std::int32_t j = 0; j < 4; ++j)
    for (std::int32_t i = 0; i < 4; ++i) {
      const std::int32_t a = 5 * j + i;
      m.faces.push_back({a, a + 1, a + 6});
      m.faces.push_back({a, a + 6, a + 5});
    }
  std::ostringstream ply, obj;
  write_ply(ply, m);
  write_obj(obj, m);
  std::string
      text =
          "ply\nformat ascii 1.0\nelement vertex 25\nproperty float x\nproperty float y\nproperty float z\n"
          "element face 16\nproperty list uchar int vertex_indices\nend_header\n",
      off = "OFF\n25 16 0\n", stl = "solid a\n", faces, binary(80, 'b');
  std::string big =
      "ply\nformat binary_big_endian 1.0\nelement vertex 25\nproperty short z\nproperty uchar x\n"
      "property float y\nelement face 16\nproperty uchar kind\nproperty list uchar uchar vertex_indices\n"
      "end_header\n";
  for (Index k = 0; k < 25; ++k) {
    const double* p = m.vertex(k);
    const std::string line =
        std::to_string(p[0]) + " " + std::to_string(p[1]) + " " + std::to_string(p[2]) + "\n";
    text += line;
    off += line;
    big += items<std::int16_t>({p[2] * 100}, true) + items<std::uint8_t>({p[0] * 4}) +
           items<float>({p[1]}, true);
  }
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 4; ++i) {
      const int a = 5 * j + i;
      faces += "4 " + std::to_string(a) + " " + std::to_string(a + 1) + " " + std::to_string(a + 6) + " " +
               std::to_string(a + 5) + "\n";
      big += items<std::uint8_t>({7, 4, a * 1.0, a + 1.0, a + 6.0, a + 5.0});
    }
  binary += items<std::uint32_t>({static_cast<double>(m.faces.size())});
  for (const auto& c : m.faces) {
    stl += "facet normal 0 0 0\nouter loop\n";
    binary += items<float>({0, 0, 1});
    for (const std::int32_t v : c) {
      const double* p = m.vertex(v);
      stl +=
          "vertex " + std::to_string(p[0]) + " " + std::to_string(p[1]) + " " + std::to_string(p[2]) + "\n";
      binary += items<float>({p[0], p[1], p[2]});
    }
    stl += "endloop\nendfacet\n";
    binary += std::string(2, '\0');
  }
  return {{"a.ply", ply.str()},
          {"a.obj", obj.str()},
          {"text.ply", text + faces},
          {"a.off", off + faces},
          {"a.stl", stl + "endsolid a\n"},
          {"binary.stl", binary},
          {"big.ply", big}};
}

void expect_sound(const SourceData& data) {
  const auto* m = std::get_if<Mesh>(&data.content);
  if (m == nullptr) {
    const PointTable& t = std::get<PointTable>(data.content);
    EXPECT_GT(t.size(), 0);
    EXPECT_TRUE(t.x.size() == t.z.size() && t.y.size() == t.z.size() && t.u.size() == t.v.size());
    for (const auto* column : {&t.x, &t.y, &t.z, &t.u, &t.v})
      for (const double value : *column) EXPECT_TRUE(std::isfinite(value));
    return;
  }
  const std::size_t n = m->vertices.size() / 3;
  EXPECT_GT(m->face_count(), 0);
  EXPECT_TRUE(m->uv.empty() || m->uv.size() == 2 * n);
  EXPECT_TRUE(m->vertex_line.empty() || m->vertex_line.size() == n);
  EXPECT_TRUE(m->face_line.empty() || m->face_line.size() == m->faces.size());
  EXPECT_TRUE(m->face_source.empty() || m->face_source.size() == m->faces.size());
  for (const double value : m->uv) EXPECT_TRUE(std::isfinite(value));
  inspect(*m);  // refuses coordinates that are not finite and corners that are no vertices
  try {
    require_disk(
        repair(*m, {.largest_part = true, .fill_holes = true, .orient = true, .drop_degenerate = true}).mesh);
  } catch (const InvalidInput&) {
  }
}

/// Reads, and holds the file to an error or a sound result. \return whether it was read
bool read_soundly(const std::string& name, const std::string& bytes) {
  try {
    const SourceData data = read(name, bytes);
    if (const auto* m = std::get_if<Mesh>(&data.content)) inspect(*m);
    return true;
  } catch (const FileError& error) {
    EXPECT_EQ(std::string(error.what()).find(name), 0U) << error.what();
    return false;
  }
}

/// \return whether it was read
bool try_reading(const std::string& name, const std::string& bytes) {
  largest_request = 0;
  std::size_t peak = 0;
  bool good = true;
  try {
    const PeakMemory memory;
    const SourceData data = read(name, bytes);
    peak = memory.bytes();
    const std::size_t largest = largest_request.load();
    expect_sound(data);
    largest_request = largest;
  } catch (const FileError& error) {
    EXPECT_EQ(std::string(error.what()).find(name), 0U) << error.what();
    EXPECT_LT(std::string(error.what()).size(), 1000U);
    good = false;
  }
  // A byte is a corner at most (uchar lists), which is a triangle of 12 bytes, its face and a vector's growth.
  EXPECT_LE(largest_request.load(), 24 * bytes.size() + 8192) << name;
  EXPECT_LE(peak, 64 * bytes.size() + 65536) << name;
  return good;
}

TEST(DamagedMeshes, TheSamplesThemselvesAreSound) {
  for (const Sample& s : samples()) EXPECT_TRUE(try_reading(s.name, s.bytes)) << s.name;
}

TEST(DamagedMeshes, TruncatedAnywhere) {
  for (const Sample& s : samples())
    for (std::size_t size = 0; size < s.bytes.size(); ++size) {
      const bool good = try_reading(s.name, s.bytes.substr(0, size));
      // What says its own size may not end early; a text's last line may lack its end, or a digit.
      if (s.name != "a.obj" && size + 8 < s.bytes.size()) {
        EXPECT_FALSE(good) << s.name << " cut at " << size;
      }
    }
}

TEST(DamagedMeshes, FilesTruncatedAtEvery64thByte) {
  std::vector<std::pair<std::string, std::string>> files;
  files.emplace_back("mask.obj", bytes_of(test_data("mask.obj")));
  for (const auto& entry : std::filesystem::directory_iterator(test_data("bad")))
    for (const char* extension : {".ply", ".obj", ".off", ".stl"})
      if (entry.path().extension() == extension)
        files.emplace_back(entry.path().filename(), bytes_of(entry.path()));
  EXPECT_GT(files.size(), 10U);
  for (const auto& [name, bytes] : files)
    for (std::size_t size = 0; size < bytes.size(); size += 64) try_reading(name, bytes.substr(0, size));
}

TEST(DamagedMeshes, TenThousandRandomChangesOfEach) {
  Random random;
  for (const Sample& s : samples()) {
    int good = 0;
    for (int k = 0; k < 10000; ++k) {
      const std::string bytes = damaged(s.bytes, random, "0123456789eE+-. \n/#\\\tvfxyzlstOF", 4, 9);
      good += try_reading(s.name, bytes);
      if (HasFatalFailure() || HasNonfatalFailure()) FAIL() << s.name << ":\n" << bytes;
    }
    EXPECT_GT(good, 0) << s.name;
    EXPECT_LT(good, 10000) << s.name;
  }
}

// Files of 100 kB, as a scan comes in: every 64th truncation and 10 000 changed bytes of each.
std::vector<Sample> larger_samples() {
  Mesh m;
  const int n = 34;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) {
      m.vertices.insert(m.vertices.end(), {i / 3.0, j / 7.0, std::sin(i * 0.3) * std::cos(j * 0.2)});
      m.uv.insert(m.uv.end(), {i / double(n), j / double(n)});
    }
  for (std::int32_t j = 0; j < n; ++j)
    for (std::int32_t i = 0; i < n; ++i) {
      const std::int32_t a = (n + 1) * j + i;
      m.faces.push_back({a, a + 1, a + n + 2});
      m.faces.push_back({a, a + n + 2, a + n + 1});
    }
  std::ostringstream ply, obj;
  write_ply(ply, m);
  m.uv.clear();
  write_obj(obj, m);
  std::string off = fmt::format("OFF\n{} {} 0\n", m.vertex_count(), m.face_count()), text;
  std::string stl = "solid\n", binary(80, 'b');
  binary += items<std::uint32_t>({800});
  for (Index k = 0; k < m.vertex_count(); ++k)
    off += fmt::format("{:.6g} {:.6g} {:.6g}\n", m.vertex(k)[0], m.vertex(k)[1], m.vertex(k)[2]);
  text =
      fmt::format(
          "ply\nformat ascii 1.0\nelement vertex {}\nproperty float x\nproperty float y\nproperty float z\n"
          "element face {}\nproperty list uchar int vertex_indices\nend_header\n",
          m.vertex_count(), m.face_count()) +
      off.substr(off.find('\n', 4) + 1);
  for (std::size_t f = 0; f < m.faces.size(); ++f) {
    const auto& t = m.faces[f];
    const std::string line = fmt::format("3 {} {} {}\n", t[0], t[1], t[2]);
    off += line;
    text += line;
    if (f < 450) {
      stl += "facet normal 0 0 1\nouter loop\n";
      for (const std::int32_t v : t)
        stl += fmt::format("vertex {:.6g} {:.6g} {:.6g}\n", m.vertex(v)[0], m.vertex(v)[1], m.vertex(v)[2]);
      stl += "endloop\nendfacet\n";
    }
    if (f < 800) {
      binary += items<float>({0, 0, 1});
      for (const std::int32_t v : t) binary += items<float>({m.vertex(v)[0], m.vertex(v)[1], m.vertex(v)[2]});
      binary += std::string(2, '\0');
    }
  }
  return {{"scan.ply", ply.str()}, {"scan.obj", obj.str()},          {"text.ply", text},
          {"scan.off", off},       {"text.stl", stl + "endsolid\n"}, {"scan.stl", binary}};
}

constexpr double kShare = 10, kBesides = 64e6;  // memory allowed: 10 times the file and 64 MB

TEST(DamagedMeshes, OfTheSizeOfAScanTruncatedAtEvery64thByte) {
  for (const Sample& s : larger_samples()) {
    ASSERT_GT(s.bytes.size(), 30000U) << s.name;
    ASSERT_LE(s.bytes.size(), 100000U) << s.name;
    EXPECT_TRUE(try_reading(s.name, s.bytes)) << s.name;
    for (std::size_t size = 0; size < s.bytes.size(); size += 64)
      try_reading(s.name, s.bytes.substr(0, size));
  }
}

TEST(DamagedMeshes, OfTheSizeOfAScanWithTenThousandBytesChanged) {
  Random random;
  for (const Sample& s : larger_samples()) {
    std::string bytes = s.bytes;
    int good = 0;
    for (int k = 0; k < 10000; ++k) {
      // Four a reading, and started anew after twenty: damage adds up.
      if (k % 20 == 0) bytes = s.bytes;
      const auto at = static_cast<std::size_t>(random.integer(0, static_cast<int>(bytes.size()) - 1));
      bytes[at] = static_cast<char>(random.integer(0, 255));
      if (k % 4 == 3) good += read_soundly(s.name, bytes);
    }
    EXPECT_LT(good, 2500) << s.name;
  }
}

// Corners of one byte make triangles of sixteen: refused once there are more than any surface has; corners of two
// bytes are bounded by what they become.
TEST(DamagedMeshes, PolygonsTakeTenTimesTheFileAtMost) {
  const auto binary = [](int vertices, const char* type, int size, Index faces, int corners) {
    std::string bytes = fmt::format(
        "ply\nformat binary_little_endian 1.0\nelement vertex {}\nproperty uchar x\nproperty uchar y\n"
        "property uchar z\nelement face {}\nproperty list ushort {} vertex_indices\nend_header\n",
        vertices, faces, type);
    for (int k = 0; k < vertices; ++k) bytes += {static_cast<char>(k), static_cast<char>(k >> 8), '\0'};
    std::string face = items<std::uint16_t>({static_cast<double>(corners)});
    for (int k = 0; k < corners; ++k)
      face += size == 1 ? items<std::uint8_t>({static_cast<double>(k)})
                        : items<std::uint16_t>({static_cast<double>(k)});
    for (Index f = 0; f < faces; ++f) bytes += face;
    return bytes;
  };
  const auto text = [](bool off, int vertices, Index faces, int corners) {
    std::string bytes = off ? fmt::format("OFF\n{} {} 0\n", vertices, faces) : "";
    for (int k = 0; k < vertices; ++k) bytes += fmt::format("{}{} {} 0\n", off ? "" : "v ", k, k % 7);
    std::string face = off ? fmt::format("{}", corners) : "f";
    for (int k = 0; k < corners; ++k) face += fmt::format(" {}", k + !off);
    for (Index f = 0; f < faces; ++f) bytes += face + "\n";
    return bytes;
  };
  const std::string bytes = binary(200, "uchar", 1, 40000, 200);
  const auto limit = [](const std::string& b) { return kShare * static_cast<double>(b.size()) + kBesides; };
  {
    const PeakMemory memory;
    refuses("a.ply", bytes, "some edge has more than two faces");
    EXPECT_LE(static_cast<double>(memory.bytes()), limit(bytes));
  }
  const std::pair<const char*, std::string> readable[] = {{"a.ply", binary(3000, "ushort", 2, 900, 3000)},
                                                          {"a.off", text(true, 3000, 600, 3000)},
                                                          {"a.obj", text(false, 3000, 600, 3000)},
                                                          {"b.off", text(true, 1800, 90000, 10)}};
  for (const auto& [name, b] : readable) {
    const PeakMemory memory;
    const SourceData data = read(name, b);
    EXPECT_GT(std::get<Mesh>(data.content).face_count(), 500000) << name;
    EXPECT_LE(static_cast<double>(memory.bytes()), kShare * static_cast<double>(b.size())) << name;
  }
}

TEST(DamagedMeshes, AFaceOfMoreCornersThanVerticesTakesNoMemory) {
  const std::size_t corners = 4'000'000;
  std::string bytes =
      "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty uchar x\nproperty uchar y\n"
      "property uchar z\nelement face 1\nproperty list uint uchar vertex_indices\nend_header\n" +
      std::string(9, '\1') + items<std::uint32_t>({static_cast<double>(corners)}) +
      std::string(corners, '\1');
  const PeakMemory memory;
  refuses("a.ply", bytes, "face 0 (counted from 0) has 4000000 corners, but there are 3 vertices");
  EXPECT_LE(memory.bytes(), 2 * bytes.size());
}

}  // namespace
}  // namespace knotfit::test
