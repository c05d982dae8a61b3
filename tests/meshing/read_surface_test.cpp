#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <iterator>
#include <sstream>

#include "sim/core/error.h"
#include "sim/geometry/polygon.h"
#include "sim/meshing/surface.h"
#include "sim/meshing/surface_objects.h"
#include "surfaces.h"
#include "tests/input_error_of.h"

namespace griffith {
namespace {

using ::testing::HasSubstr;
using namespace griffith::testing;

std::string obj_of(const TriangleSurface& s) {
  std::ostringstream text;
  for (const Vec3& p : s.points) text << "v " << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
  for (const auto& [a, b, c] : s.triangles) text << "f " << a + 1 << ' ' << b + 1 << ' ' << c + 1 << '\n';
  return text.str();
}

std::string ply_of(const TriangleSurface& s) {
  std::ostringstream text;
  text << "ply\nformat ascii 1.0\nelement vertex " << s.points.size()
       << "\nproperty float x\nproperty float y\nproperty float z\nelement face " << s.triangles.size()
       << "\nproperty list uchar int vertex_indices\nend_header\n";
  for (const Vec3& p : s.points) text << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
  for (const auto& [a, b, c] : s.triangles) text << "3 " << a << ' ' << b << ' ' << c << '\n';
  return text.str();
}

std::string ascii_stl_of(const TriangleSurface& s) {
  std::ostringstream text;
  text << "solid box\n";
  for (std::size_t i = 0; i < s.triangles.size(); ++i) {
    text << "facet normal 0 0 0\nouter loop\n";
    for (const Vec3& p : corners_of(s, static_cast<int>(i)))
      text << "vertex " << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
    text << "endloop\nendfacet\n";
  }
  text << "endsolid box\n";
  return text.str();
}

template <class T>
void append_bytes(std::string& bytes, T value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

std::string binary_stl_of(const TriangleSurface& s) {
  std::string bytes(80, ' ');
  append_bytes(bytes, static_cast<std::uint32_t>(s.triangles.size()));
  for (std::size_t i = 0; i < s.triangles.size(); ++i) {
    for (int zero = 0; zero < 3; ++zero) append_bytes(bytes, 0.0f);
    for (const Vec3& p : corners_of(s, static_cast<int>(i)))
      for (const double x : p) append_bytes(bytes, static_cast<float>(x));
    append_bytes(bytes, std::uint16_t{0});
  }
  return bytes;
}

/// Returns a glTF file with its numbers in a .bin next to it, moved by a node's translation.
std::string gltf_of(const TriangleSurface& s, const std::filesystem::path& folder, const Vec3& translation) {
  std::string bytes;
  for (const Vec3& p : s.points)
    for (const double x : p) append_bytes(bytes, static_cast<float>(x));
  const std::size_t positions = bytes.size();
  for (const auto& triangle : s.triangles)
    for (const int i : triangle) append_bytes(bytes, static_cast<std::uint32_t>(i));
  std::ofstream(folder / "box.bin", std::ios::binary) << bytes;
  std::ostringstream text;
  text
      << R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0,"translation":[)"
      << translation.x() << ',' << translation.y() << ',' << translation.z()
      << R"(]}],"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],"buffers":[{"uri":"box.bin","byteLength":)"
      << bytes.size() << R"(}],"bufferViews":[{"buffer":0,"byteLength":)" << positions
      << R"(},{"buffer":0,"byteOffset":)" << positions << R"(,"byteLength":)" << bytes.size() - positions
      << R"(}],"accessors":[{"bufferView":0,"componentType":5126,"count":)" << s.points.size()
      << R"(,"type":"VEC3","min":[0,0,0],"max":[1,2,3]},{"bufferView":1,"componentType":5125,"count":)"
      << 3 * s.triangles.size() << R"(,"type":"SCALAR"}]})";
  return text.str();
}

std::filesystem::path written(const std::filesystem::path& path, const std::string& content) {
  std::ofstream(path, std::ios::binary) << content;
  return path;
}

/// Returns the message of the InputError that reading throws, or "".
std::string message_of(const std::filesystem::path& path) {
  return input_error_of([&] { read_surface(path); });
}

TEST(ReadSurface, EveryFormatGivesTheSameBox) {
  const TriangleSurface box = box_surface(Vec3::Zero(), Vec3(1, 2, 3));
  const auto folder = test_folder();
  write_off(box, folder / "box.off");
  const std::vector<std::filesystem::path> files = {written(folder / "box.obj", obj_of(box)),
                                                    written(folder / "box.ply", ply_of(box)),
                                                    written(folder / "ascii.stl", ascii_stl_of(box)),
                                                    written(folder / "binary.STL", binary_stl_of(box)),
                                                    folder / "box.off",
                                                    written(folder / "box.gltf", gltf_of(box, folder, Vec3(0, 0, 0)))};
  for (const auto& file : files) {
    const TriangleSurface read = read_surface(file);
    EXPECT_EQ(read.points.size(), 8u) << file;  // points are merged
    EXPECT_EQ(read.triangles.size(), 12u) << file;
    EXPECT_NEAR(enclosed_volume(read), 6, 1e-6) << file;
    EXPECT_NEAR(surface_area(read), 22, 1e-6) << file;
    EXPECT_NEAR(enclosed_volume(read_surface(file, 0.01)), 6e-6, 1e-12) << file;
  }
}

TEST(ReadSurface, NodesOfAGltfFilePlaceTheirMeshes) {
  const auto folder = test_folder();
  const TriangleSurface box = box_surface(Vec3::Zero(), Vec3(1, 2, 3));
  const auto file = written(folder / "box.gltf", gltf_of(box, folder, Vec3(5, 6, 7)));
  EXPECT_LT((bounds(read_surface(file)).min() - Vec3(5, 6, 7)).norm(), 1e-6);
}

TEST(ReadSurface, PolygonsBecomeTrianglesAndTextureCoordinatesStay) {
  const auto file = written(test_folder() / "square.obj",
                            "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1 2/2 3/3 4/4\n");
  const TriangleSurface square = read_surface(file);
  ASSERT_EQ(square.triangles.size(), 2u);
  ASSERT_EQ(square.uvs.size(), 2u);
  EXPECT_TRUE(square.normals.empty());
  EXPECT_NEAR(surface_area(square), 1, 1e-12);
  for (int i = 0; i < 2; ++i)
    for (int corner = 0; corner < 3; ++corner)
      EXPECT_EQ(square.uvs[i][corner], square.points[square.triangles[i][corner]].head<2>());
}

TEST(Polygon, EarsCoverExactlyThePolygon) {
  unsigned state = 9;
  const auto next = [&] { return (state = state * 1664525 + 1013904223) / 4294967296.0; };
  for (int sample = 0; sample < 100; ++sample) {
    const int count = 3 + sample % 12;  // a star: random radii around the center
    std::vector<Vec3> corners;
    double area = 0, covered = 0;
    for (int i = 0; i < count; ++i) {
      const double angle = 2 * std::numbers::pi * i / count, radius = 0.2 + next();
      corners.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0.5);
    }
    for (int i = 0; i < count; ++i) area += corners[i].cross(corners[(i + 1) % count]).z() / 2;
    const auto triangles = triangulate(corners);
    EXPECT_EQ(triangles.size(), corners.size() - 2);
    for (const auto& [a, b, c] : triangles) {
      const double part = area_vector({corners[a], corners[b], corners[c]}).z();
      EXPECT_GE(part, -1e-12);  // all have one orientation, so an equal sum means that nothing is covered twice
      covered += part;
    }
    EXPECT_NEAR(covered, area, 1e-12);
  }
  EXPECT_TRUE(triangulate(std::vector<Vec3>(2, Vec3::Zero())).empty());
  EXPECT_EQ(triangulate(std::vector<Vec3>(5, Vec3::Zero())).size(), 3u);
}

TEST(ReadSurface, EachUnusableFileHasItsOwnMessage) {
  const auto folder = test_folder();
  EXPECT_THAT(message_of(folder / "none.obj"), HasSubstr("none.obj: no such file"));
  EXPECT_THAT(message_of(folder), HasSubstr("is a folder"));
  EXPECT_THAT(message_of(written(folder / "box.fbx", "x")), HasSubstr("not a known surface format (.obj, .stl"));
  EXPECT_THAT(message_of(written(folder / "empty.ply", "")), HasSubstr("empty.ply: is empty"));
  EXPECT_THAT(message_of(written(folder / "words.ply", "These are words.")), HasSubstr("cannot be read"));
  EXPECT_THAT(message_of(written(folder / "points.obj", "v 0 0 0\nv 1 0 0\np 1 2\n")), HasSubstr("triangles"));
  EXPECT_THAT(message_of(written(folder / "lines.obj", "v 0 0 0\nv 1 0 0\nl 1 2\n")), HasSubstr("holds no triangles"));
  EXPECT_THAT(message_of(written(folder / "nan.obj", "v 0 0 0\nv nan 0 0\nv 0 1 0\nv 1 1 1\nf 1 3 4\nf 1 2 3\n")),
              HasSubstr("not finite"));
  std::string cut = binary_stl_of(box_surface(Vec3::Zero(), Vec3::Ones()));
  cut.resize(200);
  EXPECT_NE(message_of(written(folder / "cut.stl", cut)), "no error");
}

/// Returns one file of each kind, with its companions, all of the same box.
std::vector<std::pair<std::string, std::string>> good_files(const std::filesystem::path& folder) {
  const TriangleSurface box = box_surface(Vec3::Zero(), Vec3::Ones());
  write_off(box, folder / "box.off");
  std::ifstream off(folder / "box.off", std::ios::binary);
  return {{"a.stl", binary_stl_of(box)},
          {"a.ply", ply_of(box)},
          {"b.stl", ascii_stl_of(box)},
          {"a.obj", obj_of(box)},
          {"a.off", std::string{std::istreambuf_iterator<char>(off), {}}},
          {"a.gltf", gltf_of(box, folder, Vec3::Zero())}};
}

/// True if a file is read, with valid corners, or rejected with a problem and a remedy. Nothing else may happen.
bool read_or_refused(const std::filesystem::path& file) {
  try {
    const TriangleSurface surface = read_surface(file);
    for (const auto& triangle : surface.triangles)
      for (const int corner : triangle)
        if (static_cast<std::size_t>(corner) >= surface.points.size()) return false;
    return true;
  } catch (const InputError& error) {
    return !error.problem().empty() && !error.remedy().empty();
  }
}

TEST(ReadSurface, DamagedFilesAreReadOrRefusedButNeverCrash) {
  const auto folder = test_folder();
  const auto good = good_files(folder);
  unsigned state = 1;
  const auto next = [&](std::size_t count) { return (state = state * 1664525 + 1013904223) / 7 % count; };
  for (std::size_t i = 0; i < 60 * good.size(); ++i) {
    auto [name, bytes] = good[i % good.size()];
    const auto kind = i / good.size() % 4;
    if (kind == 0) bytes.resize(next(bytes.size()));
    if (kind == 1) bytes.erase(next(bytes.size()), 1 + next(40));
    if (kind >= 2)
      for (std::size_t j = 0; j < (kind == 2 ? 3u : 30u); ++j) bytes[next(bytes.size())] = static_cast<char>(next(256));
    EXPECT_TRUE(read_or_refused(written(folder / name, bytes))) << name << " number " << i;
  }
}

/// Takes about a second to read.
std::filesystem::path large_file() {
  return written(test_folder() / "large.obj", obj_of(torus_surface(1, 0.3, 600, 300)));
}

TEST(ReadSurface, AReaderThatTakesTooLongIsEnded) {
  try {
    read_surface_objects(large_file(), {}, ProcessLimits{0.02, std::int64_t{1} << 30});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.problem(), HasSubstr("did not finish"));
    EXPECT_THAT(error.remedy(), HasSubstr("export the surface again"));
  }
}

TEST(ReadSurface, AReaderThatNeedsTooMuchMemoryIsReported) {
  try {
    read_surface_objects(large_file(), {}, ProcessLimits{60, std::int64_t{160} << 20});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.problem(), HasSubstr("160 MB of memory"));
  }
}

/// Otherwise the reader would wait for the pipe's writer.
TEST(ReadSurface, APipeThatASurfaceNamesForItsMaterialsIsPassedOver) {
  const auto folder = test_folder();
  std::filesystem::remove(folder / "pipe.mtl");
  ASSERT_EQ(mkfifo((folder / "pipe.mtl").c_str(), 0600), 0);
  const auto path = written(folder / "a.obj", "mtllib pipe.mtl\n" + obj_of(box_surface(Vec3::Zero(), Vec3::Ones())));
  EXPECT_EQ(read_surface_objects(path, {}, ProcessLimits{5, std::int64_t{2} << 30}).size(), 1u);
}

TEST(ReadSurface, BuffersOutsideTheSurfacesFolderAreRefused) {
  const auto root = test_folder() / "elsewhere", folder = root / "scene";
  std::filesystem::remove_all(root);
  std::filesystem::create_directories(folder);
  std::string text = gltf_of(box_surface(Vec3::Zero(), Vec3(1, 2, 3)), root, Vec3::Zero());
  const auto named = [&](const std::string& uri) {
    std::string changed = text;
    return written(folder / "box.gltf", changed.replace(changed.find("box.bin"), 7, uri));
  };
  EXPECT_THAT(message_of(named("../box.bin")), HasSubstr("outside its folder (put it beside the surface"));
  std::filesystem::create_symlink("../box.bin", folder / "link.bin");
  EXPECT_THAT(message_of(named("link.bin")), HasSubstr("outside its folder"));
  std::filesystem::create_directories(folder / "below");
  std::filesystem::rename(root / "box.bin", folder / "below/box.bin");
  EXPECT_EQ(message_of(named("below/box.bin")), "no error");
}

TEST(ReadSurface, CanBeCancelled) {
  Monitor monitor;
  monitor.cancelled = [] { return true; };
  EXPECT_THROW(read_surface(large_file(), 1, monitor), Cancelled);
}

TEST(ReadSurface, ObjectsKeepTheirNamesAndTheirTriangles) {
  const auto file =
      written(test_folder() / "two.obj",
              "o first\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\no second\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
              "f 4 5 6 7\n");
  const std::vector<SurfaceObject> objects = read_surface_objects(file);
  ASSERT_EQ(objects.size(), 2u);
  EXPECT_EQ(objects[0].name, "first");
  EXPECT_EQ(objects[1].name, "second");
  EXPECT_EQ(objects[0].surface.triangles.size(), 1u);
  EXPECT_EQ(objects[1].surface.triangles.size(), 2u);
}

TEST(SurfaceObjects, BytesGiveThemBackAndCutBytesGiveNothing) {
  const std::vector<SurfaceObject> objects = {{"box", box_surface(Vec3::Zero(), Vec3::Ones())}, {"", {}}};
  const std::string bytes = encode(objects);
  const auto decoded = decode_objects(bytes);
  ASSERT_TRUE(decoded);
  ASSERT_EQ(decoded->size(), 2u);
  EXPECT_EQ((*decoded)[0].name, "box");
  EXPECT_EQ((*decoded)[0].surface.points, objects[0].surface.points);
  EXPECT_EQ((*decoded)[0].surface.triangles, objects[0].surface.triangles);
  for (std::size_t length = 1; length < bytes.size(); length += 7)
    if (const auto cut = decode_objects(bytes.substr(0, length))) {
      EXPECT_LE(cut->size(), 1u) << length;  // it may end where the first object does
    }
}

}  // namespace
}  // namespace griffith
