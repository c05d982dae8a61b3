#include "sim/mesh/read_mesh.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numeric>
#include <ostream>

#include "sim/core/error.h"
#include "sim/mesh/box_mesh.h"
#include "sim/mesh/mesh_report.h"
#include "sim/mesh/topology.h"
#include "sim/mesh/write_mesh.h"
#include "tests/input_error_of.h"
#include "tests/mesh/cell_files.h"
#include "tests/mesh/mesh_invariants.h"
#include "tests/mesh/sample_files.h"
#include "tests/random_values.h"

namespace griffith {
namespace {

using ::testing::HasSubstr;
using testing::RandomValues;
using testing::sample_files;
using testing::TemporaryFolder;

/// A box with coordinates that use all their digits.
TetSoup random_soup(int cells) {
  RandomValues random(4);
  TetSoup soup = make_box(Vec3(1, 1, 1), Vec3::Constant(1.0 / cells), BoxPattern::five_tet);
  for (Vec3& point : soup.points) point += random.vector(0.1 / cells);
  return soup;
}

std::string error_of(const std::filesystem::path& path) {
  return input_error_of([&] { read_mesh(path); });
}

TEST(ReadMeshTest, EveryFormatGivesTheSameMeshToTheLastBit) {
  const TetSoup soup = random_soup(2);
  for (const auto& sample : sample_files(soup)) {
    TemporaryFolder folder;
    folder.write(sample);
    CellReport report;
    const TetSoup read = read_mesh(folder.path() / sample.path, &report);
    const std::int64_t skipped = std::accumulate(report.skipped.begin(), report.skipped.end(), std::int64_t{0});
    EXPECT_EQ(read.points, soup.points) << sample.format;
    EXPECT_EQ(read.tets, soup.tets) << sample.format;
    EXPECT_EQ(skipped, sample.skipped_elements) << sample.format;
  }
}

TEST(ReadMeshTest, WindowsLineEndsChangeNothing) {
  const TetSoup soup = random_soup(1);
  for (auto sample : sample_files(soup)) {
    if (sample.format.find("text") == std::string::npos && sample.format != "medit" && sample.format != "csv") continue;
    TemporaryFolder folder;
    for (const auto& [name, content] : sample.files) {
      std::string changed;
      for (char c : content) changed += c == '\n' ? "\r\n" : std::string(1, c);
      folder.write(name, changed);
    }
    EXPECT_EQ(read_mesh(folder.path() / sample.path).points, soup.points) << sample.format;
  }
}

TEST(WriteMeshTest, RoundTripsAreExact) {
  const TetSoup soup = random_soup(3);
  const TetMesh mesh = build_mesh(soup);
  TemporaryFolder folder;
  write_gmsh(folder.path() / "a.msh", soup);
  std::vector<double> numbers(soup.points.size(), 1 / 3.0);
  std::vector<std::int32_t> bodies(soup.tets.size(), 3);
  const std::vector<Mat3> tensors(soup.tets.size(), Mat3::Random());
  write_vtu(
      folder.path() / "a.vtu", mesh.rest_positions, mesh.tets,
      {.per_node = {{"a < \"b\" & c", std::span<const double>(numbers)}, {"x", std::span<const Vec3>(soup.points)}},
       .per_tet = {{"body", std::span<const std::int32_t>(bodies)}, {"stress", std::span<const Mat3>(tensors)}}});
  for (const char* name : {"a.msh", "a.vtu"}) {
    const TetSoup read = read_mesh(folder.path() / name);
    EXPECT_EQ(read.points, soup.points) << name;
    EXPECT_EQ(read.tets, soup.tets) << name;
  }
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 2) << "nothing else is left";
}

TEST(WriteMeshTest, NamesAFolderThatDoesNotExist) {
  EXPECT_THROW(write_gmsh("/no/such/folder/a.msh", random_soup(1)), InputError);
}

/// A sample with part of a file replaced, and what the message must say.
struct Mistake {
  std::string format, file, find, replace, message;
};

void PrintTo(const Mistake& mistake, std::ostream* stream) { *stream << mistake.format << ", " << mistake.message; }

class MistakeTest : public ::testing::TestWithParam<Mistake> {};

TEST_P(MistakeTest, IsAnsweredWithPlaceAndExpectation) {
  const auto& [format, file, find, replace, message] = GetParam();
  for (auto sample : sample_files(make_box(Vec3::Ones(), Vec3::Ones(), BoxPattern::five_tet))) {
    if (sample.format != format) continue;
    std::string& content = sample.files.at(file);
    const std::size_t place = content.find(find);
    ASSERT_NE(place, std::string::npos);
    content.replace(place, find.size(), replace);
    TemporaryFolder folder;
    folder.write(sample);
    EXPECT_THAT(error_of(folder.path() / sample.path), HasSubstr(message));
    return;
  }
  FAIL() << "no format " << format;
}

INSTANTIATE_TEST_SUITE_P(
    Files, MistakeTest,
    ::testing::Values(
        Mistake{"csv", "folder/tets.csv", "0,", "8,", "tets.csv:1: no point 8 (points are 0 to 7)"},
        Mistake{"csv", "folder/verts.csv", "\n0.5,-0.5,-0.5\n", "\n0.5,-0.5\n",
                "verts.csv:3: a row with too few numbers"},
        Mistake{"csv", "folder/verts.csv", "\n0.5,-0.5,-0.5\n", "\n0.5,-0.5,-0.5,7\n",
                "verts.csv:2: found 7 (expected the end of the row)"},
        Mistake{"tetgen from 0", "a.1.node", " 3 1 1", " 2 1 1", "a.1.node:2: dimension 2 (expected 3)"},
        Mistake{"tetgen from 1", "a.1.node", "\n2 ", "\n5 ", "a.1.node:4: point number 5"},
        Mistake{"tetgen from 1", "a.1.node", "-0.5", "north", "a.1.node:3: found north (expected x, y, z)"},
        Mistake{"tetgen from 1", "a.1.node", "-0.5", "1e999", "a.1.node:3: found 1e999"},
        Mistake{"tetgen from 1", "a.1.ele", "5 4 1", "2000000000 4 1", "a.1.ele:1: announces 2000000000 tetrahedra"},
        Mistake{"medit", "a.mesh", "3\n# comment", "2\n# comment", "a.mesh:3: dimension 2"},
        Mistake{"medit", "a.mesh", "Tetrahedra 5\n", "Tetrahedra 5\n99 ", "no vertex 99 (vertices are 1 to 8)"},
        Mistake{
            "gmsh 2 text", "a.msh", "2.2 0 8", "4.0 0 8",
            "a.msh:2: version 4.0 of MSH is not read (convert it to version 4.1: gmsh OLD.msh -save -format msh41 -o "},
        Mistake{"gmsh 2 text", "a.msh", "$EndNodes", "", "expected $EndNodes"},
        Mistake{"gmsh 2 binary", "a.msh", "$EndElements", "", "a.msh:"},
        Mistake{"gmsh 4 binary", "a.msh", "$Elements\n", "$Elements\n\xff\xff\xff\xff\xff\xff\xff\x7f", ", byte "},
        Mistake{"vtk text", "a.vtk", "UNSTRUCTURED_GRID", "POLYDATA",
                "a.vtk:4: found POLYDATA (expected UNSTRUCTURED_GRID)"},
        Mistake{"vtk text", "a.vtk", "CELL_TYPES 6\n5\n", "CELL_TYPES 5\n", "5 cell types for 6 cells"},
        Mistake{"vtu 0", "a.vtu", "version=\"0.1\"", "compressor=\"vtkZLibDataCompressor\"",
                "save the file without compression"},
        Mistake{"vtu 0", "a.vtu", "NumberOfPoints=\"8\"", "NumberOfPoints=\"9\"", "Points has 24 values (expected 27)"},
        Mistake{"vtu 0", "a.vtu", "Name=\"types\"", "Name=\"kinds\"", "no DataArray types"},
        Mistake{"vtu 3", "a.vtu", "<AppendedData", "<OtherData", "appended data are missing"}));

/// Numbers near the ends of their types; none may be believed before memory is taken for it, nor overflow.
INSTANTIATE_TEST_SUITE_P(
    HugeNumbers, MistakeTest,
    ::testing::Values(
        Mistake{"csv", "folder/tets.csv", "0,", "-2147483648,", "tets.csv:1: no point -2147483648"},
        Mistake{"csv", "folder/tets.csv", "0,", "2147483648,", "tets.csv:1: found 2147483648"},
        Mistake{"tetgen from 1", "a.1.ele", "\n1 ", "\n1 -2147483648 ",
                "a.1.ele:2: no point -2147483648 (points are 1"},
        Mistake{"tetgen from 1", "a.1.ele", "\n1 ", "\n1 2147483647 ", "a.1.ele:2: no point 2147483647"},
        Mistake{"tetgen from 1", "a.1.node", "\n2 ", "\n-2147483648 ", "a.1.node:4: point number -2147483648"},
        Mistake{"tetgen from 1", "a.1.node", "8 3", "2147483647 3", "a.1.node:2: announces 2147483647 points"},
        Mistake{"tetgen from 1", "a.1.node", "8 3", "2147483648 3", "a.1.node:2: found 2147483648"},
        Mistake{"medit", "a.mesh", "Vertices", "Vertices 2147483647 ", "announces 2147483647 vertices"},
        Mistake{"medit", "a.mesh", "Tetrahedra 5\n", "Tetrahedra 5\n-2147483648 ", "no vertex -2147483648"},
        Mistake{"medit", "a.mesh", "Tetrahedra 5\n", "Triangles -2147483648\nTetrahedra 5\n",
                "announces -2147483648 elements"},
        Mistake{"gmsh 2 text", "a.msh", "$Nodes\n", "$Nodes\n2147483648 ", "announces 2147483648 nodes"},
        Mistake{"gmsh 2 text", "a.msh", "$Elements\n", "$Elements\n9223372036854775807 ",
                "announces 9223372036854775807 elements"},
        Mistake{"gmsh 4 text", "a.msh", "$Nodes\n", "$Nodes\n9223372036854775807 ",
                "announces 9223372036854775807 blocks of nodes"},
        Mistake{"vtk text", "a.vtk", "POINTS 8", "POINTS 2147483647", "announces 6442450941 coordinates"},
        Mistake{"vtk text", "a.vtk", "POINTS 8", "POINTS -2147483648", "announces -6442450944 coordinates"},
        Mistake{"vtk text", "a.vtk", "CELL_TYPES 6", "CELL_TYPES 2147483648", "announces 2147483648 cell types"},
        Mistake{"vtk text", "a.vtk", "TIME 1 1", "TIME 2147483647 2147483647", "announces 4611686014132420609 values"},
        Mistake{"vtk 5 binary", "a.vtk", "CELLS 6 ", "CELLS 9223372036854775807 ",
                "announces 9223372036854775807 offsets"},
        Mistake{"vtu 0", "a.vtu", "NumberOfPoints=\"8\"", "NumberOfPoints=\"9223372036854775807\"",
                "a.vtu:5: <Piece> has the NumberOfPoints \"9223372036854775807\" (the file cannot hold so many)"},
        Mistake{"vtu 0", "a.vtu", "NumberOfCells='5'", "NumberOfCells='-9223372036854775808'", "expected a count"},
        Mistake{"vtu 3", "a.vtu", "offset=\"", "offset=\"9223372036854775", "the file cannot hold so many"}));

/// Small files must not stand for large meshes.
TEST(ReadMeshTest, PiecesThatShareTheirDataAreRefused) {
  for (auto sample : sample_files(random_soup(5))) {
    if (sample.format != "vtu 3") continue;
    std::string& text = sample.files.at("a.vtu");
    const std::size_t begin = text.find("<Piece Number"), end = text.find("</UnstructuredGrid>");
    const std::string piece = text.substr(begin, end - begin);
    for (int copies = 0; copies < 50; ++copies) text.insert(end, piece);
    TemporaryFolder folder;
    folder.write(sample);
    EXPECT_THAT(error_of(folder.path() / sample.path), HasSubstr("the arrays of all pieces are longer than the file"));
  }
}

TEST(ReadMeshTest, AFileThatIsTooLargeIsRefusedUnread) {
  TemporaryFolder folder;
  folder.write("a.mesh", "MeshVersionFormatted 2\n");
  std::filesystem::resize_file(folder.path() / "a.mesh", std::uintmax_t(1) << 40);
  EXPECT_THAT(error_of(folder.path() / "a.mesh"), HasSubstr("a.mesh: is larger than 2047 MB"));
}

TEST(ReadMeshTest, ManyOpenArraysAreAnsweredAtOnce) {
  std::string text = "<VTKFile type=\"UnstructuredGrid\"><Piece NumberOfPoints=\"0\" NumberOfCells=\"0\">";
  for (int i = 0; i < 300000; ++i) text += "<DataArray>";
  TemporaryFolder folder;
  folder.write("a.vtu", text);
  EXPECT_THAT(error_of(folder.path() / "a.vtu"), HasSubstr("a <DataArray> has no end"));
  folder.write("a.vtu", text + "</DataArray>");
  EXPECT_THAT(error_of(folder.path() / "a.vtu"), HasSubstr("no error"));
}

TEST(ReadMeshTest, ReportsMissingAndUnknownFiles) {
  TemporaryFolder folder;
  EXPECT_THAT(error_of(folder.path() / "none.msh"), HasSubstr("none.msh: no such file"));
  EXPECT_THAT(error_of(folder.path() / "none"), HasSubstr("no such file or folder"));
  EXPECT_THAT(error_of(folder.path()), HasSubstr("verts.csv: no such file"));
  folder.write("a.stl", "solid");
  EXPECT_THAT(error_of(folder.path() / "a.stl"), HasSubstr("not a known mesh format (.node, .ele, .msh"));
}

/// Whatever the bytes, reading ends with a mesh that holds its invariants or with an InputError.
void read_and_check(const std::filesystem::path& path, int& readable) {
  try {
    TetSoup soup = read_mesh(path);
    TetMesh mesh;
    prepare(soup, "mesh", &mesh);
    EXPECT_THAT(testing::check_invariants(mesh), ::testing::IsEmpty());
    ++readable;
  } catch (const InputError& error) {
    EXPECT_FALSE(error.where().empty() || error.problem().empty()) << error.what();
  }
}

TEST(ReadMeshTest, SurvivesTruncatedAndSpoiltFiles) {
  RandomValues random(5);
  auto samples = sample_files(make_box(Vec3::Ones(), Vec3::Ones(), BoxPattern::five_tet));
  for (auto& sample : testing::cell_files(testing::mixed_block(2, 0.2, 1))) samples.push_back(std::move(sample));
  TemporaryFolder folder;
  int readable = 0, rounds = 0;
  for (const auto& sample : samples) {
    folder.write(sample);
    for (const auto& [name, content] : sample.files) {
      for (int round = 0; round < 150; ++round, ++rounds) {
        std::string spoilt = content;
        if (round % 3 == 0) spoilt.resize(random.index(static_cast<int>(content.size())));
        for (int flips = round % 3 == 0 ? 0 : 1 + random.index(4); flips > 0; --flips)
          spoilt[random.index(static_cast<int>(spoilt.size()))] =
              round % 3 == 1 ? static_cast<char>(random.index(256)) : '9';
        folder.write(name, spoilt);
        SCOPED_TRACE(sample.format + ", round " + std::to_string(round));
        read_and_check(folder.path() / sample.path, readable);
      }
      folder.write(name, content);
    }
  }
  EXPECT_GT(readable, 0);
  EXPECT_LT(readable, rounds);
}

}  // namespace
}  // namespace griffith
