#include <algorithm>
#include <iterator>
#include <unordered_map>

#include "sim/mesh/file_cursor.h"
#include "sim/mesh/mesh_formats.h"

namespace griffith {
namespace {

/// Type of elements (Gmsh reference manual, "MSH file format"; GmshDefines.h). All begin with their corners.
struct GmshType {
  int type;
  CellShape shape;
  int nodes;
};

constexpr GmshType kGmshTypes[] = {{1, CellShape::line, 2},
                                   {2, CellShape::triangle, 3},
                                   {3, CellShape::quadrilateral, 4},
                                   {4, CellShape::tetrahedron, 4},
                                   {5, CellShape::hexahedron, 8},
                                   {6, CellShape::prism, 6},
                                   {7, CellShape::pyramid, 5},
                                   {8, CellShape::line, 3},
                                   {9, CellShape::triangle, 6},
                                   {10, CellShape::quadrilateral, 9},
                                   {11, CellShape::tetrahedron, 10},
                                   {12, CellShape::hexahedron, 27},
                                   {13, CellShape::prism, 18},
                                   {14, CellShape::pyramid, 14},
                                   {15, CellShape::point, 1},
                                   {16, CellShape::quadrilateral, 8},
                                   {17, CellShape::hexahedron, 20},
                                   {18, CellShape::prism, 15},
                                   {19, CellShape::pyramid, 13},
                                   {20, CellShape::triangle, 9},
                                   {21, CellShape::triangle, 10},
                                   {22, CellShape::triangle, 12},
                                   {23, CellShape::triangle, 15},
                                   {24, CellShape::triangle, 15},
                                   {25, CellShape::triangle, 21},
                                   {26, CellShape::line, 4},
                                   {27, CellShape::line, 5},
                                   {28, CellShape::line, 6},
                                   {29, CellShape::tetrahedron, 20},
                                   {30, CellShape::tetrahedron, 35},
                                   {31, CellShape::tetrahedron, 56},
                                   {32, CellShape::tetrahedron, 22},
                                   {33, CellShape::tetrahedron, 28},
                                   {36, CellShape::quadrilateral, 16},
                                   {37, CellShape::quadrilateral, 25},
                                   {38, CellShape::quadrilateral, 36},
                                   {39, CellShape::quadrilateral, 12},
                                   {40, CellShape::quadrilateral, 16},
                                   {41, CellShape::quadrilateral, 20},
                                   {90, CellShape::prism, 40},
                                   {91, CellShape::prism, 75},
                                   {92, CellShape::hexahedron, 64},
                                   {93, CellShape::hexahedron, 125},
                                   {94, CellShape::hexahedron, 216},
                                   {106, CellShape::prism, 126},
                                   {118, CellShape::pyramid, 30},
                                   {119, CellShape::pyramid, 55},
                                   {120, CellShape::pyramid, 91}};

/// Returns null for an unknown type.
const GmshType* gmsh_type(int type) {
  const auto* found = std::ranges::find(kGmshTypes, type, &GmshType::type);
  return found == std::end(kGmshTypes) ? nullptr : found;
}

class GmshReader {
 public:
  explicit GmshReader(const std::filesystem::path& path) : cursor_(path) {}

  MeshFile read() {
    read_format();
    while (!cursor_.at_end()) {
      const std::string section(cursor_.word("a section, $..."));
      if (section == "$Nodes")
        read_section([this] { version_ == 4 ? read_nodes_4() : read_nodes_2(); });
      else if (section == "$Elements")
        read_section([this] { version_ == 4 ? read_elements_4() : read_elements_2(); });
      else if (section.size() < 2 || section[0] != '$')
        cursor_.fail_expecting("a section, $...", section);
      else if (!cursor_.skip_past("$End" + section.substr(1)))
        cursor_.fail("section " + section + " has no end", "expected $End" + section.substr(1));
      else
        continue;
      cursor_.expect("$End" + section.substr(1));
    }
    return std::move(file_);
  }

 private:
  void read_format() {
    cursor_.expect("$MeshFormat");
    const std::string text(cursor_.word("the format's version"));
    double version = 0;
    if (!parse_number(text, version)) cursor_.fail_expecting("the format's version", text);
    if ((version < 2 || version >= 3) && version != 4.1)
      cursor_.fail("version " + text + " of MSH is not read",
                   "convert it to version 4.1: gmsh OLD.msh -save -format msh41 -o NEW.msh");
    version_ = static_cast<int>(version);
    const int kind = cursor_.number<int>("0 for text or 1 for binary");
    if (cursor_.number<int>("the data size") != 8) cursor_.fail("another data size than 8", "expected 8");
    if (kind != 0) find_byte_order();
    cursor_.expect("$EndMeshFormat");
  }

  void find_byte_order() {
    cursor_.rest_of_line();
    const std::string_view one = cursor_.bytes(4, "the number 1 in binary");
    for (Encoding order : {Encoding::little_endian, Encoding::big_endian})
      if (decode_number<std::int32_t>(one.data(), order) == 1) binary_ = order;
    if (binary_ == Encoding::text) cursor_.fail_expecting("the number 1 in binary", "something else");
  }

  /// Binary numbers start on the line after the section's name.
  template <class ReadBody>
  void read_section(ReadBody read_body) {
    cursor_.rest_of_line();
    if (version_ == 4) cursor_.encoding = binary_;
    read_body();
    cursor_.encoding = Encoding::text;
  }

  bool is_binary() const { return binary_ != Encoding::text; }
  std::int64_t big() { return cursor_.number<std::int64_t>("a count or tag"); }
  int small() { return cursor_.number<std::int32_t>("an integer"); }

  void add_node(std::int64_t tag) {
    Vec3 point;
    for (double& coordinate : point) coordinate = cursor_.number<double>("x, y, z");
    if (!node_of_tag_.emplace(tag, static_cast<int>(file_.soup.points.size())).second)
      cursor_.fail("node " + std::to_string(tag) + " appears twice", "every node once");
    file_.soup.points.push_back(point);
  }

  /// Version 2 writes counts as text in binary files too.
  std::int64_t read_count_2() {
    const std::int64_t count = big();
    if (is_binary()) cursor_.rest_of_line();
    cursor_.encoding = binary_;
    return count;
  }

  void read_nodes_2() {
    const std::int64_t count = read_count_2();
    cursor_.require_room(count, 4, 4, "nodes");
    for (std::int64_t i = 0; i < count; ++i) add_node(small());
  }

  void read_nodes_4() {
    const std::int64_t blocks = big(), count = big();
    big(), big();  // smallest and largest tag
    cursor_.require_room(blocks, 4, 4, "blocks of nodes");
    cursor_.require_room(count, 4, 8, "nodes");
    for (std::int64_t block = 0; block < blocks; ++block) {
      const int dimension = small();
      small();  // entity
      const int parameters = small() != 0 ? dimension : 0;
      const std::int64_t nodes = big();
      cursor_.require_room(nodes, 4, 8, "nodes in a block");
      std::vector<std::int64_t> tags(nodes);
      for (auto& tag : tags) tag = big();
      for (auto tag : tags) {
        add_node(tag);
        for (int i = 0; i < parameters; ++i) cursor_.number<double>("a parameter of the node");
      }
    }
  }

  const GmshType& known_type(int type) {
    const GmshType* known = gmsh_type(type);
    if (known == nullptr)
      cursor_.fail("element type " + std::to_string(type),
                   "expected points, lines, triangles, quadrilaterals, "
                   "tetrahedra, pyramids, prisms or hexahedra, up to fifth order");
    return *known;
  }

  template <class Tag>
  int read_node_reference() {
    const std::int64_t tag = cursor_.number<Tag>("a node's tag");
    const auto found = node_of_tag_.find(tag);
    if (found == node_of_tag_.end())
      cursor_.fail("no node " + std::to_string(tag), "elements name nodes that $Nodes has defined");
    return found->second;
  }

  template <class Tag>
  void read_element_nodes(const GmshType& type) {
    const int corners = has_volume(type.shape) ? corner_count(type.shape) : 0;
    std::array<int, 8> cell = {};
    for (int i = 0; i < corners; ++i) cell[i] = read_node_reference<Tag>();
    for (int i = corners; i < type.nodes; ++i) cursor_.number<Tag>("a node's tag");
    if (corners == 0) return file_.skip(type.shape);
    file_.add(type.shape, cell, type.nodes);
  }

  /// Elements come in blocks with a common head in binary files. In text files each has its head after its number.
  void read_elements_2() {
    const std::int64_t count = read_count_2();
    cursor_.require_room(count, 2, 4, "elements");
    for (std::int64_t read = 0; read < count;) {
      if (!is_binary()) small();  // the element's number
      const int type = small(), block = is_binary() ? small() : 1, tags = small();
      if (block < 1 || tags < 0 || block > count - read) cursor_.fail("a wrong element head", "type, elements, tags");
      const GmshType& known = known_type(type);
      for (int i = 0; i < block; ++i, ++read) {
        if (is_binary()) small();
        for (int tag = 0; tag < tags; ++tag) small();
        read_element_nodes<std::int32_t>(known);
      }
    }
  }

  void read_elements_4() {
    const std::int64_t blocks = big();
    big(), big(), big();  // elements, smallest and largest tag
    cursor_.require_room(blocks, 4, 4, "blocks of elements");
    for (std::int64_t block = 0; block < blocks; ++block) {
      small(), small();  // entity's dimension and tag
      const GmshType& known = known_type(small());
      const std::int64_t elements = big();
      cursor_.require_room(elements, known.nodes + 1, 8, "elements in a block");
      for (std::int64_t i = 0; i < elements; ++i) {
        big();  // the element's tag
        read_element_nodes<std::int64_t>(known);
      }
    }
  }

  FileCursor cursor_;
  MeshFile file_;
  int version_ = 2;
  Encoding binary_ = Encoding::text;  ///< encoding of numbers in sections; text in a text file
  std::unordered_map<std::int64_t, int> node_of_tag_;
};

}  // namespace

MeshFile read_gmsh(const std::filesystem::path& path) { return GmshReader(path).read(); }

}  // namespace griffith
