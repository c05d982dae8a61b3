#include "tests/mesh/sample_files.h"

#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <limits>
#include <sstream>

namespace griffith::testing {
namespace {

std::ostringstream exact_stream() {
  std::ostringstream stream;
  stream.precision(std::numeric_limits<double>::max_digits10);
  return stream;
}

/// Numbers of any types, one after the other.
template <class... T>
std::string binary(bool big_endian, T... values) {
  std::string bytes;
  const auto add = [&](auto value) {
    std::string one(reinterpret_cast<const char*>(&value), sizeof value);
    if (big_endian) std::reverse(one.begin(), one.end());
    bytes += one;
  };
  (add(values), ...);
  return bytes;
}

using I32 = std::int32_t;
using I64 = std::int64_t;

std::string points_text(const TetSoup& soup, const std::string& separator, const std::string& after, bool numbered,
                        int first) {
  auto out = exact_stream();
  for (std::size_t i = 0; i < soup.points.size(); ++i) {
    if (numbered) out << first + static_cast<int>(i) << separator;
    const Vec3& p = soup.points[i];
    out << p.x() << separator << p.y() << separator << p.z() << after << "\n";
  }
  return out.str();
}

std::string tets_text(const TetSoup& soup, const std::string& separator, const std::string& after,
                      const std::string& before, bool numbered, int first) {
  std::ostringstream out;
  for (std::size_t i = 0; i < soup.tets.size(); ++i) {
    if (numbered) out << first + static_cast<int>(i) << separator;
    out << before;
    for (int c = 0; c < 4; ++c) out << (c ? separator : "") << soup.tets[i][c] + first;
    out << after << "\n";
  }
  return out.str();
}

std::string points_binary(const TetSoup& soup, bool big_endian) {
  std::string bytes;
  for (const Vec3& p : soup.points) bytes += binary(big_endian, p.x(), p.y(), p.z());
  return bytes;
}

std::string count_text(std::size_t count) { return std::to_string(count); }

SampleFile csv(const TetSoup& soup, bool heading) {
  return {
      "csv",
      "folder",
      {{"folder/verts.csv", (heading ? "x,y,z\n" : "") + points_text(soup, ",", "", false, 0)},
       {"folder/tets.csv", (heading ? "a;b;c;d\r\n" : "") + tets_text(soup, heading ? ";" : ",", "", "", false, 0)}}};
}

SampleFile tetgen(const TetSoup& soup, int first, const std::string& read) {
  const std::string nodes = "# points\n" + count_text(soup.points.size()) + " 3 1 1\n" +
                            points_text(soup, "  ", " 0.5 1 # on the border", true, first);
  const std::string tets =
      count_text(soup.tets.size()) + " 4 1\n" + tets_text(soup, " ", " 7", "", true, first) + "# end\n";
  return {"tetgen from " + std::to_string(first), read, {{"a.1.node", nodes}, {"a.1.ele", tets}}};
}

SampleFile medit(const TetSoup& soup) {
  return {"medit",
          "a.mesh",
          {{"a.mesh", "MeshVersionFormatted 2\nDimension\n3\n# comment\nVertices\n" + count_text(soup.points.size()) +
                          "\n" + points_text(soup, " ", " 0", false, 0) +
                          "Triangles 1\n1 2 3 5\nCorners 1\n1\nTetrahedra " + count_text(soup.tets.size()) + "\n" +
                          tets_text(soup, " ", " 1", "", false, 1) + "End\n"}},
          1};
}

SampleFile gmsh_2_text(const TetSoup& soup) {
  return {
      "gmsh 2 text",
      "a.msh",
      {{"a.msh",
        "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n1\n3 1 \"all $ of it\"\n$EndPhysicalNames\n$Nodes\n" +
            count_text(soup.points.size()) + "\n" + points_text(soup, " ", "", true, 1) + "$EndNodes\n$Elements\n" +
            count_text(soup.tets.size() + 1) + "\n1 2 2 1 1 1 2 3\n" + tets_text(soup, " ", "", "4 2 1 1 ", true, 1) +
            "$EndElements\n"}},
      1};
}

SampleFile gmsh_2_binary(const TetSoup& soup, bool big) {
  std::string text = "$MeshFormat\n2.2 1 8\n" + binary(big, I32(1)) + "\n$EndMeshFormat\n$Nodes\n" +
                     count_text(soup.points.size()) + "\n";
  for (std::size_t i = 0; i < soup.points.size(); ++i) {
    const Vec3& p = soup.points[i];
    text += binary(big, I32(i + 1), p.x(), p.y(), p.z());
  }
  text += "\n$EndNodes\n$Elements\n" + count_text(soup.tets.size() + 1) + "\n";
  text += binary(big, I32(2), I32(1), I32(2), I32(1), I32(1), I32(1), I32(1), I32(2), I32(3));
  text += binary(big, I32(4), I32(soup.tets.size()), I32(2));
  for (std::size_t i = 0; i < soup.tets.size(); ++i) {
    text += binary(big, I32(i + 2), I32(1), I32(1));
    for (int corner : soup.tets[i]) text += binary(big, I32(corner + 1));
  }
  return {"gmsh 2 binary", "a.msh", {{"a.msh", text + "\n$EndElements\n"}}, 1};
}

SampleFile gmsh_4_text(const TetSoup& soup) {
  auto out = exact_stream();
  const std::size_t points = soup.points.size(), tets = soup.tets.size();
  out << "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Entities\n0 0 0 0\n$EndEntities\n$Nodes\n";
  // Two blocks, the second one with a parameter for each node; tags have gaps.
  out << "2 " << points << " 10 " << 10 * points << "\n3 1 0 " << points - 2 << "\n";
  for (std::size_t i = 0; i < points; ++i) {
    if (i == points - 2) out << "1 1 1 2\n" << 10 * (i + 1) << "\n" << 10 * (i + 2) << "\n";
    if (i == 0)
      for (std::size_t k = 0; k < points - 2; ++k) out << 10 * (k + 1) << "\n";
    const Vec3& p = soup.points[i];
    out << p.x() << " " << p.y() << " " << p.z() << (i >= points - 2 ? " 0.25" : "") << "\n";
  }
  out << "$EndNodes\n$Elements\n2 " << tets + 1 << " 1 " << tets + 1 << "\n1 1 1 1\n1 10 20\n3 1 4 " << tets << "\n";
  for (std::size_t i = 0; i < tets; ++i) {
    out << i + 2;
    for (int corner : soup.tets[i]) out << " " << 10 * (corner + 1);
    out << "\n";
  }
  out << "$EndElements\n";
  return {"gmsh 4 text", "a.msh", {{"a.msh", out.str()}}, 1};
}

SampleFile gmsh_4_binary(const TetSoup& soup, bool big) {
  const auto points = static_cast<I64>(soup.points.size()), tets = static_cast<I64>(soup.tets.size());
  std::string text = "$MeshFormat\n4.1 1 8\n" + binary(big, I32(1)) + "\n$EndMeshFormat\n$Nodes\n";
  text += binary(big, I64(1), points, I64(1), points, I32(3), I32(1), I32(0), points);
  for (I64 i = 0; i < points; ++i) text += binary(big, i + 1);
  text += points_binary(soup, big) + "\n$EndNodes\n$Elements\n" + binary(big, I64(1), tets, I64(1), tets);
  // Second-order tets whose middle nodes are not used.
  text += binary(big, I32(3), I32(1), I32(11), tets);
  for (I64 i = 0; i < tets; ++i) {
    text += binary(big, i + 1);
    for (int corner : soup.tets[i]) text += binary(big, I64(corner + 1));
    for (int middle = 0; middle < 6; ++middle) text += binary(big, I64(1));
  }
  return {"gmsh 4 binary", "a.msh", {{"a.msh", text + "\n$EndElements\n"}}};
}

SampleFile vtk_text(const TetSoup& soup) {
  const std::size_t tets = soup.tets.size();
  std::string text =
      "# vtk DataFile Version 3.0\ntitle\nASCII\nDATASET UNSTRUCTURED_GRID\nFIELD FieldData 1\nTIME 1 1 double\n0.5\n" +
      ("POINTS " + count_text(soup.points.size())) + " double\n" + points_text(soup, " ", "", false, 0) + "CELLS " +
      count_text(tets + 1) + " " + count_text(5 * tets + 4) + "\n3 0 1 2\n" + tets_text(soup, " ", "", "4 ", false, 0) +
      "CELL_TYPES " + count_text(tets + 1) + "\n5\n";
  for (std::size_t i = 0; i < tets; ++i) text += "10\n";
  return {"vtk text", "a.vtk", {{"a.vtk", text + "CELL_DATA 1\nSCALARS whatever follows\n"}}, 1};
}

SampleFile vtk_binary(const TetSoup& soup) {
  std::string text = "# vtk DataFile Version 2.0\ntitle\nBINARY\nDATASET UNSTRUCTURED_GRID\nPOINTS " +
                     count_text(soup.points.size()) + " double\n" + points_binary(soup, true) + "\nCELLS " +
                     count_text(soup.tets.size()) + " " + count_text(5 * soup.tets.size()) + "\n";
  for (const auto& [a, b, c, d] : soup.tets) text += binary(true, I32(4), I32(a), I32(b), I32(c), I32(d));
  text += "\nCELL_TYPES " + count_text(soup.tets.size()) + "\n";
  for (std::size_t i = 0; i < soup.tets.size(); ++i) text += binary(true, I32(10));
  return {"vtk binary", "a.vtk", {{"a.vtk", text + "\nPOINT_DATA 3\n"}}};
}

SampleFile vtk_5_binary(const TetSoup& soup) {
  std::string text = "# vtk DataFile Version 5.1\ntitle\nBINARY\nDATASET UNSTRUCTURED_GRID\nPOINTS " +
                     count_text(soup.points.size()) + " double\n" + points_binary(soup, true) +
                     "\nMETADATA\nINFORMATION 0\n\nCELLS " + count_text(soup.tets.size() + 1) + " " +
                     count_text(4 * soup.tets.size()) + "\nOFFSETS vtktypeint64\n";
  for (std::size_t i = 0; i <= soup.tets.size(); ++i) text += binary(true, I64(4 * i));
  text += "\nCONNECTIVITY vtktypeint64\n";
  for (const auto& [a, b, c, d] : soup.tets) text += binary(true, I64(a), I64(b), I64(c), I64(d));
  text += "\nCELL_TYPES " + count_text(soup.tets.size()) + "\n";
  for (std::size_t i = 0; i < soup.tets.size(); ++i) text += binary(true, I32(10));
  return {"vtk 5 binary", "a.vtk", {{"a.vtk", text + "\n"}}};
}

std::string base64(const std::string& bytes) {
  constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    unsigned bits = 0;
    for (std::size_t k = 0; k < 3; ++k)
      bits = bits << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0);
    for (std::size_t k = 0; k < 4; ++k) text += k <= bytes.size() - i ? kDigits[bits >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

enum class VtuKind { text, base64, base64_apart, appended_raw, appended_base64 };

/// Writes arrays in the way asked for.
class VtuArrays {
 public:
  VtuArrays(VtuKind kind, bool big_endian) : kind_(kind), big_endian_(big_endian) {}

  std::string array(const std::string& attributes, const std::string& text, const std::string& bytes) {
    const std::string start = "<DataArray " + attributes + " format=\"";
    const std::string header = binary(big_endian_, std::uint32_t(bytes.size()));
    if (kind_ == VtuKind::text) return start + "ascii\">" + text + "</DataArray>\n";
    if (kind_ == VtuKind::base64) return start + "binary\">\n  " + base64(header + bytes) + "\n</DataArray>\n";
    if (kind_ == VtuKind::base64_apart) return start + "binary\">" + base64(header) + base64(bytes) + "</DataArray>\n";
    const std::string tag = start + "appended\" offset=\"" + std::to_string(appended_.size()) + "\"/>\n";
    appended_ += kind_ == VtuKind::appended_raw ? header + bytes : base64(header + bytes);
    return tag;
  }

  std::string appended() const {
    if (appended_.empty()) return "";
    return std::string("<AppendedData encoding=\"") + (kind_ == VtuKind::appended_raw ? "raw" : "base64") + "\">\n_" +
           appended_ + "\n</AppendedData>\n";
  }

 private:
  VtuKind kind_;
  bool big_endian_;
  std::string appended_;
};

SampleFile vtu(const TetSoup& soup, VtuKind kind, bool big) {
  VtuArrays arrays(kind, big);
  std::string offsets_text, types_text, connectivity, offsets, types;
  for (std::size_t i = 0; i < soup.tets.size(); ++i) {
    for (int corner : soup.tets[i]) connectivity += binary(big, I32(corner));
    offsets += binary(big, I64(4 * (i + 1)));
    types += binary(big, std::uint8_t(10));
    offsets_text += std::to_string(4 * (i + 1)) + " ";
    types_text += "10 ";
  }
  std::string text =
      "<?xml version=\"1.0\"?>\n<!-- <Piece> a comment -->\n<VTKFile type=\"UnstructuredGrid\" version=\"0.1\"";
  text += std::string(" byte_order=\"") + (big ? "BigEndian" : "LittleEndian") + "\">\n<UnstructuredGrid>\n";
  text += "<Piece NumberOfPoints=\"" + count_text(soup.points.size()) + "\" NumberOfCells='" +
          count_text(soup.tets.size()) + "'>\n";
  text += "<PointData Scalars = \"s\">\n";
  text += arrays.array("type=\"Float32\" Name=\"s\"", "1 2 3", binary(big, 1.0f));
  text += "</PointData>\n<Points>\n";
  text += arrays.array("type=\"Float64\" NumberOfComponents=\"3\"", points_text(soup, " ", "", false, 0),
                       points_binary(soup, big));
  text += "</Points>\n<Cells>\n";
  text += arrays.array("type=\"Int32\" Name=\"connectivity\"", tets_text(soup, " ", "", "", false, 0), connectivity);
  text += arrays.array("type=\"Int64\" Name=\"offsets\"", offsets_text, offsets);
  text += arrays.array("type=\"UInt8\" Name=\"types\"", types_text, types);
  text += "</Cells>\n</Piece>\n</UnstructuredGrid>\n" + arrays.appended() + "</VTKFile>\n";
  return {"vtu " + std::to_string(static_cast<int>(kind)), "a.vtu", {{"a.vtu", text}}};
}

}  // namespace

std::vector<SampleFile> sample_files(const TetSoup& soup) {
  return {csv(soup, false),
          csv(soup, true),
          tetgen(soup, 0, "a.1.node"),
          tetgen(soup, 1, "a.1.ele"),
          medit(soup),
          gmsh_2_text(soup),
          gmsh_2_binary(soup, false),
          gmsh_2_binary(soup, true),
          gmsh_4_text(soup),
          gmsh_4_binary(soup, false),
          gmsh_4_binary(soup, true),
          vtk_text(soup),
          vtk_binary(soup),
          vtk_5_binary(soup),
          vtu(soup, VtuKind::text, false),
          vtu(soup, VtuKind::base64, false),
          vtu(soup, VtuKind::base64_apart, true),
          vtu(soup, VtuKind::appended_raw, false),
          vtu(soup, VtuKind::appended_raw, true),
          vtu(soup, VtuKind::appended_base64, false)};
}

void TemporaryFolder::write(const SampleFile& sample) const {
  for (const auto& [name, content] : sample.files) write(name, content);
}

void TemporaryFolder::write(const std::string& name, const std::string& content) const {
  std::filesystem::create_directories((path() / name).parent_path());
  std::filesystem::remove(path() / name);  // some file systems wait for the disk when a file is overwritten
  std::ofstream(path() / name, std::ios::binary) << content;
}

}  // namespace griffith::testing
