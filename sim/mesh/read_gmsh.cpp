#include <unordered_map>

#include "sim/mesh/file_cursor.h"
#include "sim/mesh/mesh_formats.h"

namespace griffith {
namespace {

/// Nodes of an element of Gmsh's type number, 0 for a type not known here (Gmsh reference manual, "MSH file format").
int nodes_of_type(int type) {
  constexpr int kNodes[] = {0, 2,  3,  4,  4, 8,  6,  5,  3,  6,  9, 10, 27, 18, 14, 1,
                            8, 20, 15, 13, 9, 10, 12, 15, 15, 21, 4, 5,  6,  20, 35, 56};
  if (type == 92) return 64;
  if (type == 93) return 125;
  return type > 0 && type < static_cast<int>(std::size(kNodes)) ? kNodes[type] : 0;
}

/// Tets of first to fourth order; their corners come first.
bool is_tet(int type) { return type == 4 || type == 11 || type == 29 || type == 30 || type == 31; }

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
    const double version = cursor_.number<double>("the format's version");
    const bool known = (version >= 2 && version < 3) || version == 4.1;
    if (!known) cursor_.fail("MSH version " + std::to_string(version), "export as version 2.2 or 4.1");
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

  /// Binary numbers, if the file has such, start on the line after the section's name.
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

  /// Version 2 writes the counts as text in binary files, too.
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

  int nodes_of_known_type(int type) {
    const int nodes = nodes_of_type(type);
    if (nodes == 0) cursor_.fail("element type " + std::to_string(type), "expected a type of Gmsh's manual");
    return nodes;
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
  void read_element_nodes(int type, int nodes) {
    if (!is_tet(type)) {
      for (int i = 0; i < nodes; ++i) cursor_.number<Tag>("a node's tag");
      ++file_.skipped_elements;
      return;
    }
    std::array<int, 4> tet;
    for (int& corner : tet) corner = read_node_reference<Tag>();
    for (int i = 4; i < nodes; ++i) cursor_.number<Tag>("a node's tag");
    file_.soup.tets.push_back(tet);
  }

  /// Elements come in blocks with a common head in binary files; in text files each has its head after its number.
  void read_elements_2() {
    const std::int64_t count = read_count_2();
    cursor_.require_room(count, 2, 4, "elements");
    for (std::int64_t read = 0; read < count;) {
      if (!is_binary()) small();  // the element's number
      const int type = small(), block = is_binary() ? small() : 1, tags = small();
      if (block < 1 || tags < 0 || block > count - read) cursor_.fail("a wrong element head", "type, elements, tags");
      const int nodes = nodes_of_known_type(type);
      for (int i = 0; i < block; ++i, ++read) {
        if (is_binary()) small();
        for (int tag = 0; tag < tags; ++tag) small();
        read_element_nodes<std::int32_t>(type, nodes);
      }
    }
  }

  void read_elements_4() {
    const std::int64_t blocks = big();
    big(), big(), big();  // elements, smallest and largest tag
    cursor_.require_room(blocks, 4, 4, "blocks of elements");
    for (std::int64_t block = 0; block < blocks; ++block) {
      small(), small();  // entity's dimension and tag
      const int type = small(), nodes = nodes_of_known_type(type);
      const std::int64_t elements = big();
      cursor_.require_room(elements, nodes + 1, 8, "elements in a block");
      for (std::int64_t i = 0; i < elements; ++i) {
        big();  // the element's tag
        read_element_nodes<std::int64_t>(type, nodes);
      }
    }
  }

  FileCursor cursor_;
  MeshFile file_;
  int version_ = 2;
  Encoding binary_ = Encoding::text;  ///< of the sections' numbers; text in a text file
  std::unordered_map<std::int64_t, int> node_of_tag_;
};

}  // namespace

MeshFile read_gmsh(const std::filesystem::path& path) { return GmshReader(path).read(); }

}  // namespace griffith
