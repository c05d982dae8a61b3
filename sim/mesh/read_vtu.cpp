#include <algorithm>
#include <optional>

#include "sim/mesh/file_cursor.h"
#include "sim/mesh/mesh_formats.h"
#include "sim/mesh/vtk_cells.h"
#include "sim/mesh/xml_tags.h"

namespace griffith {
namespace {

/// DataArray with the place of its values, not yet decoded.
struct DataArray {
  std::string type, format;
  std::size_t begin = 0, end = 0;  ///< range of its text in the file
  std::int64_t offset = 0;         ///< offset in the appended data
};

struct Piece {
  std::int64_t points = 0, cells = 0;
  std::optional<DataArray> positions, connectivity, offsets, types;
};

int base64_digit(char c) {
  if (c >= 'A' && c <= 'Z') return c - 'A';
  if (c >= 'a' && c <= 'z') return c - 'a' + 26;
  if (c >= '0' && c <= '9') return c - '0' + 52;
  return c == '+' ? 62 : c == '/' ? 63 : -1;
}

/// Decodes up to `wanted` bytes, skipping blanks. Padding may be in the middle, since writers differ in whether they
/// encode the leading length together with the data.
std::string decode_base64(std::string_view text, std::size_t wanted) {
  std::string bytes;
  unsigned bits = 0;
  int digits = 0, padding = 0;
  for (char c : text) {
    if (bytes.size() >= wanted) break;
    const int digit = base64_digit(c);
    if (digit < 0 && c != '=') continue;
    padding += c == '=';
    bits = bits << 6 | static_cast<unsigned>(std::max(digit, 0));
    if (++digits < 4) continue;
    for (int i = 0; i < 3 - padding; ++i) bytes += static_cast<char>(bits >> (16 - 8 * i) & 0xff);
    bits = 0, digits = 0, padding = 0;
  }
  bytes.resize(std::min(bytes.size(), wanted));
  return bytes;
}

class VtuReader {
 public:
  explicit VtuReader(const std::filesystem::path& path) : cursor_(path) {}

  MeshFile read() {
    collect_tags();
    for (const Piece& piece : pieces_) read_piece(piece);
    return std::move(file_);
  }

 private:
  void collect_tags() {
    XmlTag tag;
    std::string section;  // Points, Cells, PointData ...
    while (next_xml_tag(cursor_, tag)) {
      if (tag.name == "VTKFile" && !tag.closes) read_head(tag);
      if (tag.name == "Piece" && !tag.closes) pieces_.push_back(read_piece_head(tag));
      if (tag.name == "Points" || tag.name == "Cells") section = tag.closes ? "" : tag.name;
      if (tag.name == "DataArray" && !tag.closes) record_array(tag, section);
      if (tag.name == "AppendedData" && !tag.closes) {
        record_appended_data(tag);
        break;
      }
    }
    if (!found_head_) cursor_.fail("no <VTKFile> tag", "expected <VTKFile type=\"UnstructuredGrid\">");
  }

  void read_head(const XmlTag& tag) {
    found_head_ = true;
    if (tag.attribute("type") != "UnstructuredGrid")
      cursor_.fail("a VTK file of type " + tag.attribute("type"), "expected UnstructuredGrid");
    if (!tag.attribute("compressor").empty())
      cursor_.fail("compressed data (" + tag.attribute("compressor") + ")", "save the file without compression");
    big_endian_ = tag.attribute("byte_order") == "BigEndian";
    header_bytes_ = tag.attribute("header_type") == "UInt64" ? 8 : 4;
  }

  /// Returns an attribute that cannot exceed the file's number of bytes.
  std::int64_t count_attribute(const XmlTag& tag, const char* key) {
    std::int64_t count = 0;
    const bool is_count = parse_number(tag.attribute(key), count) && count >= 0;
    if (!is_count || count > static_cast<std::int64_t>(cursor_.text().size()))
      cursor_.fail("<" + tag.name + "> has the " + key + " \"" + tag.attribute(key) + "\"",
                   is_count ? "the file cannot hold so many" : "expected a count");
    return count;
  }

  Piece read_piece_head(const XmlTag& tag) {
    Piece piece;
    piece.points = count_attribute(tag, "NumberOfPoints");
    piece.cells = count_attribute(tag, "NumberOfCells");
    return piece;
  }

  void record_array(const XmlTag& tag, const std::string& section) {
    DataArray array{tag.attribute("type"), tag.attribute("format", "ascii"), tag.end, tag.end, 0};
    if (array.format == "appended") array.offset = count_attribute(tag, "offset");
    if (!tag.is_empty) array.end = find_array_end(tag);
    if (pieces_.empty()) return;
    Piece& piece = pieces_.back();
    const std::string name = tag.attribute("Name");
    if (section == "Points") piece.positions = array;
    if (section == "Cells" && name == "connectivity") piece.connectivity = array;
    if (section == "Cells" && name == "offsets") piece.offsets = array;
    if (section == "Cells" && name == "types") piece.types = array;
  }

  /// Moves the cursor there too, since values are not tags.
  std::size_t find_array_end(const XmlTag& tag) {
    const std::size_t end = cursor_.text().find("</DataArray", tag.end);
    if (end == std::string_view::npos) cursor_.fail("a <DataArray> has no end", "expected </DataArray>");
    cursor_.seek(end);
    return end;
  }

  void record_appended_data(const XmlTag& tag) {
    appended_is_raw_ = tag.attribute("encoding") == "raw";
    if (!cursor_.skip_past("_")) cursor_.fail("<AppendedData> is empty", "expected _ and the data");
    appended_begin_ = cursor_.offset();
  }

  void read_piece(const Piece& piece) {
    if (piece.points == 0 && piece.cells == 0) return;
    const int first_point = static_cast<int>(file_.soup.points.size());
    const auto positions = values<double>(piece.positions, "Points", 3 * double(piece.points));
    const auto types = values<std::int64_t>(piece.types, "types", double(piece.cells));
    const auto offsets = values<std::int64_t>(piece.offsets, "offsets", double(piece.cells));
    const auto connectivity = values<std::int64_t>(piece.connectivity, "connectivity", -1);
    for (std::size_t i = 0; i < positions.size(); i += 3) file_.soup.points.emplace_back(&positions[i]);
    const std::string problem = add_vtk_cells({types, offsets, connectivity}, first_point, piece.points, file_);
    if (!problem.empty())
      cursor_.fail(
          problem,
          "connectivity, offsets and types that fit together; ParaView's filter Tetrahedralize splits any cell");
  }

  /// Decodes an array that must exist and have `count` values (any number if negative).
  template <class T>
  std::vector<T> values(const std::optional<DataArray>& array, const char* name, double count) {
    if (!array) cursor_.fail(std::string("no DataArray ") + name, "every piece has Points and Cells");
    place_message(array->begin);
    std::vector<T> result =
        array->format == "ascii" ? parse_text<T>(*array) : convert<T>(array->type, raw_bytes(*array));
    if (count >= 0 && double(result.size()) != count)
      cursor_.fail(std::string(name) + " has " + std::to_string(result.size()) + " values",
                   "expected " + std::to_string(static_cast<std::int64_t>(count)));
    return result;
  }

  void place_message(std::size_t offset) {
    cursor_.seek(offset);
    cursor_.bytes(0, "data");
  }

  template <class T>
  std::vector<T> parse_text(const DataArray& array) {
    std::vector<T> result;
    cursor_.seek(array.begin);
    while (!cursor_.at_end() && cursor_.offset() < array.end) {
      // The last number may touch the closing tag.
      std::string_view word = cursor_.word("a number");
      word = word.substr(0, word.find('<'));
      T value{};
      if (!parse_number(word, value)) cursor_.fail_expecting("a number", word);
      result.push_back(value);
    }
    return result;
  }

  /// Returns the bytes of a binary array without the leading length.
  std::string raw_bytes(const DataArray& array) {
    const bool appended = array.format == "appended";
    if (!appended && array.format != "binary") cursor_.fail("format " + array.format, "ascii, binary or appended");
    if (appended && appended_begin_ == 0) cursor_.fail("appended data are missing", "expected <AppendedData>");
    std::string_view source = cursor_.text().substr(array.begin, array.end - array.begin);
    if (appended) {
      const std::string_view all = cursor_.text().substr(appended_begin_);
      if (static_cast<std::uint64_t>(array.offset) > all.size())
        cursor_.fail("offset " + std::to_string(array.offset) + " lies beyond the file", "a right offset");
      source = all.substr(array.offset);
    }
    const bool raw = appended && appended_is_raw_;
    const auto take = [&](std::size_t wanted) {
      return raw ? std::string(source.substr(0, wanted)) : decode_base64(source, wanted);
    };
    const std::string header = take(header_bytes_);
    if (header.size() < header_bytes_) cursor_.fail("the data end too early", "expected their length");
    const std::uint64_t length = header_bytes_ == 8 ? decode_number<std::uint64_t>(header.data(), byte_order())
                                                    : decode_number<std::uint32_t>(header.data(), byte_order());
    if (length > source.size()) cursor_.fail("announces " + std::to_string(length) + " bytes", "the file has fewer");
    decoded_ += length;
    if (decoded_ > cursor_.text().size())
      cursor_.fail("the arrays of all pieces are longer than the file", "each array has data of its own");
    std::string bytes = take(header_bytes_ + length);
    if (bytes.size() < header_bytes_ + length)
      cursor_.fail("the data end too early", "expected " + std::to_string(length) + " bytes");
    return bytes.substr(header_bytes_);
  }

  Encoding byte_order() const { return big_endian_ ? Encoding::big_endian : Encoding::little_endian; }

  template <class Stored, class T>
  std::vector<T> convert_stored(const std::string& bytes) {
    std::vector<T> result(bytes.size() / sizeof(Stored));
    for (std::size_t i = 0; i < result.size(); ++i) {
      const Stored value = decode_number<Stored>(&bytes[i * sizeof(Stored)], byte_order());
      if constexpr (std::is_floating_point_v<Stored>)
        if (!std::isfinite(value)) cursor_.fail("a position that is not finite", "finite numbers");
      result[i] = static_cast<T>(value);
    }
    return result;
  }

  template <class T>
  std::vector<T> convert(const std::string& type, const std::string& bytes) {
    if constexpr (std::is_floating_point_v<T>) {
      if (type == "Float32") return convert_stored<float, T>(bytes);
      if (type == "Float64") return convert_stored<double, T>(bytes);
    } else {
      if (type == "Int8") return convert_stored<std::int8_t, T>(bytes);
      if (type == "UInt8") return convert_stored<std::uint8_t, T>(bytes);
      if (type == "Int16") return convert_stored<std::int16_t, T>(bytes);
      if (type == "UInt16") return convert_stored<std::uint16_t, T>(bytes);
      if (type == "Int32") return convert_stored<std::int32_t, T>(bytes);
      if (type == "UInt32") return convert_stored<std::uint32_t, T>(bytes);
      if (type == "Int64") return convert_stored<std::int64_t, T>(bytes);
      if (type == "UInt64") return convert_stored<std::uint64_t, T>(bytes);
    }
    cursor_.fail("data type " + type, std::is_floating_point_v<T> ? "Float32 or Float64" : "an integer type");
  }

  FileCursor cursor_;
  MeshFile file_;
  std::vector<Piece> pieces_;
  bool found_head_ = false, big_endian_ = false, appended_is_raw_ = false;
  std::size_t header_bytes_ = 4;
  std::uint64_t decoded_ = 0;       ///< bytes of all arrays so far
  std::size_t appended_begin_ = 0;  ///< offset after the underscore; 0: no appended data
};

}  // namespace

MeshFile read_vtu(const std::filesystem::path& path) { return VtuReader(path).read(); }

}  // namespace griffith
