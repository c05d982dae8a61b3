#include "sim/mesh/file_cursor.h"
#include "sim/mesh/mesh_formats.h"
#include "sim/mesh/vtk_cells.h"

namespace griffith {
namespace {

class VtkReader {
 public:
  explicit VtkReader(const std::filesystem::path& path) : cursor_(path) {}

  MeshFile read() {
    read_head();
    bool more = true;
    while (more && !cursor_.at_end()) more = read_section(std::string(cursor_.word("a section")));
    const std::string problem =
        add_vtk_cells({types_, offsets_, connectivity_}, 0, static_cast<std::int64_t>(file_.soup.points.size()), file_);
    if (!problem.empty())
      cursor_.fail(problem,
                   "POINTS, CELLS and CELL_TYPES that fit together; ParaView's filter Tetrahedralize splits any cell");
    return std::move(file_);
  }

 private:
  void read_head() {
    const std::string_view head = cursor_.rest_of_line();
    constexpr std::string_view kStart = "# vtk DataFile Version ";
    if (!head.starts_with(kStart)) cursor_.fail_expecting("# vtk DataFile Version", head);
    version_ = head.substr(kStart.size()).starts_with("5") ? 5 : 4;
    cursor_.rest_of_line();  // title
    const std::string_view kind = cursor_.word("ASCII or BINARY");
    if (kind != "ASCII" && kind != "BINARY") cursor_.fail_expecting("ASCII or BINARY", kind);
    if (kind == "BINARY") data_encoding_ = Encoding::big_endian;
    cursor_.expect("DATASET");
    const std::string_view set = cursor_.word("UNSTRUCTURED_GRID");
    if (set != "UNSTRUCTURED_GRID") cursor_.fail_expecting("UNSTRUCTURED_GRID", set);
  }

  /// Returns false at the section where the grid ends and its data begin.
  bool read_section(const std::string& section) {
    if (section == "CELL_DATA" || section == "POINT_DATA") return false;
    if (section == "POINTS")
      read_points();
    else if (section == "CELLS")
      version_ == 5 ? read_cells_5() : read_cells();
    else if (section == "CELL_TYPES")
      types_ = read_integers("int", cursor_.number<std::int64_t>("the number of cells"), "cell types");
    else if (section == "FIELD")
      skip_fields();
    else if (section == "METADATA")
      skip_metadata();
    else
      cursor_.fail_expecting("POINTS, CELLS, CELL_TYPES, FIELD, CELL_DATA or POINT_DATA", section);
    return true;
  }

  template <class Stored, class T>
  std::vector<T> read_stored(std::int64_t count, const char* what) {
    if (data_encoding_ != Encoding::text) cursor_.rest_of_line();
    cursor_.encoding = data_encoding_;
    cursor_.require_room(count, 1, sizeof(Stored), what);
    std::vector<T> values(count);
    for (T& value : values) value = static_cast<T>(cursor_.number<Stored>(what));
    cursor_.encoding = Encoding::text;
    return values;
  }

  std::vector<std::int64_t> read_integers(std::string_view type, std::int64_t count, const char* what) {
    if (type == "int" || type == "vtktypeint32") return read_stored<std::int32_t, std::int64_t>(count, what);
    if (type == "long" || type == "vtktypeint64" || type == "vtkIdType")
      return read_stored<std::int64_t, std::int64_t>(count, what);
    cursor_.fail("data type " + std::string(type), "expected int, vtktypeint32 or vtktypeint64");
  }

  void read_points() {
    const auto count = cursor_.number<std::int32_t>("the number of points");
    const std::string type(cursor_.word("float or double"));
    std::vector<double> values;
    if (type == "float")
      values = read_stored<float, double>(3 * std::int64_t(count), "coordinates");
    else if (type == "double")
      values = read_stored<double, double>(3 * std::int64_t(count), "coordinates");
    else
      cursor_.fail_expecting("float or double", type);
    file_.soup.points.resize(count);
    for (std::int64_t i = 0; i < count; ++i) file_.soup.points[i] = Vec3(&values[3 * i]);
  }

  /// Reads cells up to version 4: each is the number of its points, then these.
  void read_cells() {
    const auto cells = cursor_.number<std::int64_t>("the number of cells");
    const auto size = cursor_.number<std::int64_t>("the number of integers");
    const auto values = read_integers("int", size, "cells");
    connectivity_.clear();
    offsets_.clear();
    for (std::size_t i = 0; i < values.size();) {
      const std::int64_t points = values[i++];
      if (points < 0 || points > static_cast<std::int64_t>(values.size() - i))
        cursor_.fail("cell " + std::to_string(offsets_.size()) + " reaches beyond the list",
                     "a right number of points");
      connectivity_.insert(connectivity_.end(), values.begin() + i, values.begin() + i + points);
      offsets_.push_back(static_cast<std::int64_t>(connectivity_.size()));
      i += points;
    }
    if (static_cast<std::int64_t>(offsets_.size()) != cells)
      cursor_.fail(std::to_string(offsets_.size()) + " cells", "CELLS announces " + std::to_string(cells));
  }

  /// Reads cells from version 5 on: a list of cell ends, beginning with 0, and a list of points.
  void read_cells_5() {
    const auto offset_count = cursor_.number<std::int64_t>("the number of offsets");
    const auto size = cursor_.number<std::int64_t>("the length of the connectivity");
    cursor_.expect("OFFSETS");
    offsets_ = read_integers(std::string(cursor_.word("a data type")), offset_count, "offsets");
    if (!offsets_.empty()) offsets_.erase(offsets_.begin());
    cursor_.expect("CONNECTIVITY");
    connectivity_ = read_integers(std::string(cursor_.word("a data type")), size, "connectivity");
  }

  void skip_fields() {
    cursor_.word("the field's name");
    const int arrays = cursor_.number<int>("the number of arrays");
    for (int i = 0; i < arrays; ++i) {
      cursor_.word("the array's name");
      const auto components = cursor_.number<std::int32_t>("the number of components");
      const auto tuples = cursor_.number<std::int32_t>("the number of tuples");
      const std::string type(cursor_.word("a data type"));
      const std::int64_t count = std::int64_t(components) * tuples;
      if (type == "float")
        read_stored<float, double>(count, "values");
      else if (type == "double")
        read_stored<double, double>(count, "values");
      else
        read_integers(type, count, "values");
    }
  }

  /// Skips metadata, which end with an empty line.
  void skip_metadata() {
    cursor_.rest_of_line();
    while (cursor_.offset() < cursor_.text().size() && !cursor_.rest_of_line().empty()) continue;
  }

  FileCursor cursor_;
  MeshFile file_;
  int version_ = 4;  ///< 5: cells as offsets and connectivity; 4: anything older
  Encoding data_encoding_ = Encoding::text;
  std::vector<std::int64_t> types_, offsets_, connectivity_;
};

}  // namespace

MeshFile read_vtk(const std::filesystem::path& path) { return VtkReader(path).read(); }

}  // namespace griffith
