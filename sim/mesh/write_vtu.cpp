#include <array>
#include <bit>
#include <cassert>
#include <type_traits>

#include "sim/core/replace_file.h"
#include "sim/mesh/write_mesh.h"

namespace griffith {
namespace {

static_assert(std::endian::native == std::endian::little, "the file says little-endian");

std::string escaped(std::string_view text) {
  std::string result;
  for (char c : text) {
    if (c == '<')
      result += "&lt;";
    else if (c == '&')
      result += "&amp;";
    else if (c == '"')
      result += "&quot;";
    else
      result += c;
  }
  return result;
}

/// Parts of the file: XML that describes arrays, followed by their bytes.
class VtuFile {
 public:
  void line(const std::string& text) { xml_ += text + "\n"; }

  /// Describes an array of `components` numbers each and appends its length and bytes.
  template <class T>
  void add_array(const std::string& name, int components, std::span<const T> values) {
    const char* type = std::is_same_v<T, double> ? "Float64" : std::is_same_v<T, std::int32_t> ? "Int32" : "UInt8";
    line("<DataArray type=\"" + std::string(type) + "\" Name=\"" + escaped(name) + "\" NumberOfComponents=\"" +
         std::to_string(components) + "\" format=\"appended\" offset=\"" + std::to_string(data_.size()) + "\"/>");
    const std::uint64_t length = values.size_bytes();
    data_.append(reinterpret_cast<const char*>(&length), sizeof length);
    data_.append(reinterpret_cast<const char*>(values.data()), length);
  }

  void add_field(const MeshField& field, [[maybe_unused]] std::size_t expected_count) {
    std::visit(
        [&](auto values) {
          assert(values.size() == expected_count && "one value a node or tet");
          using Value = typename decltype(values)::value_type;
          if constexpr (std::is_arithmetic_v<Value>)
            add_array<Value>(field.name, 1, values);
          else if constexpr (std::is_same_v<Value, Vec3>)
            add_array<double>(field.name, 3, {values.empty() ? nullptr : values[0].data(), 3 * values.size()});
          else
            add_array<double>(field.name, 9, by_rows(values));
        },
        field.values);
  }

  std::string take() && {
    return std::move(xml_) + "<AppendedData encoding=\"raw\">\n_" + data_ + "\n</AppendedData>\n</VTKFile>\n";
  }

 private:
  static std::vector<double> by_rows(std::span<const Mat3> tensors) {
    std::vector<double> values;
    values.reserve(9 * tensors.size());
    for (const Mat3& tensor : tensors)
      for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column) values.push_back(tensor(row, column));
    return values;
  }

  std::string xml_, data_;
};

void add_cells(VtuFile& file, std::span<const std::array<NodeId, 4>> tets,
               std::span<const std::array<std::int32_t, 6>> middles) {
  constexpr std::uint8_t kTetra = 10, kQuadraticTetra = 24;
  constexpr std::array<int, 6> kOrder = {0, 3, 1, 2, 4, 5};  // order of the edges, after the corners
  std::vector<std::int32_t> connectivity, offsets;
  std::vector<std::uint8_t> types(tets.size(), kTetra);
  connectivity.reserve(4 * tets.size());
  for (std::size_t i = 0; i < tets.size(); ++i) {
    for (const NodeId corner : tets[i]) connectivity.push_back(corner.index());
    if (!middles.empty() && middles[i][0] >= 0) {
      for (const int edge : kOrder) connectivity.push_back(middles[i][edge]);
      types[i] = kQuadraticTetra;
    }
    offsets.push_back(static_cast<std::int32_t>(connectivity.size()));
  }
  file.line("<Cells>");
  file.add_array<std::int32_t>("connectivity", 1, connectivity);
  file.add_array<std::int32_t>("offsets", 1, offsets);
  file.add_array<std::uint8_t>("types", 1, types);
  file.line("</Cells>");
}

}  // namespace

void write_vtu(const std::filesystem::path& path, std::span<const Vec3> positions,
               std::span<const std::array<NodeId, 4>> tets, const VtuFields& fields,
               std::span<const std::array<std::int32_t, 6>> middles) {
  VtuFile file;
  file.line("<?xml version=\"1.0\"?>");
  file.line("<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">");
  file.line("<UnstructuredGrid>");
  file.line("<Piece NumberOfPoints=\"" + std::to_string(positions.size()) + "\" NumberOfCells=\"" +
            std::to_string(tets.size()) + "\">");
  file.line("<PointData>");
  for (const MeshField& field : fields.per_node) file.add_field(field, positions.size());
  file.line("</PointData>\n<CellData>");
  for (const MeshField& field : fields.per_tet) file.add_field(field, tets.size());
  file.line("</CellData>\n<Points>");
  file.add_array<double>("Points", 3, {positions.empty() ? nullptr : positions[0].data(), 3 * positions.size()});
  file.line("</Points>");
  add_cells(file, tets, middles);
  file.line("</Piece>\n</UnstructuredGrid>");
  replace_file(path, std::move(file).take());
}

}  // namespace griffith
