#include "sim/core/file_content.h"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <span>

#include "sim/core/error.h"

namespace griffith {
namespace {

/// Beginning of a kind of file. `endings`, each before a blank, are the suffixes of files with such content.
struct Signature {
  std::string_view start;  ///< text in lower case, after blanks and a byte order mark
  std::string_view endings, what, remedy;
};

constexpr Signature kTexts[] = {
    {"version https://git-lfs.", "", "is a pointer of Git LFS, not the file itself",
     "install git-lfs and run \"git lfs pull\" in its repository, or download the file"},
    {"<!doctype html", "", "is a web page", "download the file itself, on GitHub by \"Raw\""},
    {"<html", "", "is a web page", "download the file itself, on GitHub by \"Raw\""},
    {"<vtkfile", ".vtu ", "is a VTK file in XML", "end its name in .vtu"},
    {"<?xml", ".vtu ", "is XML", "end its name in .vtu if it is a VTK file"},
    {"# vtk datafile", ".vtk ", "is a legacy VTK file", "end its name in .vtk"},
    {"$meshformat", ".msh ", "is a mesh of Gmsh", "end its name in .msh"},
    {"$nod\n", "", "is a mesh of Gmsh in version 1 of MSH",
     "convert it to version 4.1: gmsh OLD.msh -save -format msh41 -o NEW.msh"},
    {"$nod\r", "", "is a mesh of Gmsh in version 1 of MSH",
     "convert it to version 4.1: gmsh OLD.msh -save -format msh41 -o NEW.msh"},
    {"meshversionformatted", ".mesh ", "is a Medit mesh", "end its name in .mesh"},
    {"*heading", "", "is an Abaqus input file", "convert it to .vtu or .msh, by meshio or Gmsh"},
    {"ply\n", ".ply ", "is a PLY surface", "end its name in .ply"},
    {"ply\r", ".ply ", "is a PLY surface", "end its name in .ply"},
    {"off\n", ".off ", "is an OFF surface", "end its name in .off"},
    {"solid ", ".stl ", "is an STL surface", "end its name in .stl"},
};

constexpr Signature kBytes[] = {
    {"glTF", ".glb ", "is a binary glTF file", "end its name in .glb"},
    {"\x89PNG", ".png ", "is a PNG picture", "name another file"},
    {"\x89HDF", "", "is an HDF5 file", "convert it to .vtu or .msh, by meshio or ParaView"},
    {"\x1f\x8b", ".gz .tgz ", "is compressed by gzip", "unpack it: gunzip"},
    {"PK\x03\x04", ".zip ", "is a ZIP archive", "unpack it: unzip"},
    {"\x28\xb5\x2f\xfd", ".zst ", "is compressed by zstd",
     "unpack it: griffith replay FILE --extract DIR if it is a recording, else tar -xf or unzstd"},
    {"\xfd\x37zXZ", ".xz .txz ", "is compressed by xz", "unpack it: tar -xf, or unxz"},
    {"BZh", ".bz2 ", "is compressed by bzip2", "unpack it: tar -xf, or bunzip2"},
    {"\xff\xfe", "", "is text in UTF-16", "save it in UTF-8"},
    {"\xfe\xff", "", "is text in UTF-16", "save it in UTF-8"},
};

std::string lower_case(std::string_view text) {
  std::string result(text);
  std::ranges::transform(result, result.begin(), [](unsigned char c) { return std::tolower(c); });
  return result;
}

/// Returns the beginning of a text in lower case, without leading blanks and byte order mark.
std::string start_of_text(std::string_view content) {
  constexpr std::size_t kLength = 64;
  if (content.starts_with("\xef\xbb\xbf")) content.remove_prefix(3);
  content.remove_prefix(std::min(content.find_first_not_of(" \t\r\n"), content.size()));
  return lower_case(content.substr(0, kLength));
}

void require_none_of(std::span<const Signature> signatures, std::string_view start, const std::filesystem::path& path) {
  const std::string ending = lower_case(path.extension().string()) + " ";
  for (const Signature& known : signatures) {
    const bool expected = ending != " " && known.endings.find(ending) != std::string_view::npos;
    if (start.starts_with(known.start) && !expected)
      throw InputError(path.string(), std::string(known.what), std::string(known.remedy));
  }
}

}  // namespace

void require_expected_content(const std::filesystem::path& path, std::string_view content) {
  require_none_of(kTexts, start_of_text(content), path);
  require_none_of(kBytes, content, path);
}

void require_expected_content(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return;
  std::string start(512, '\0');
  std::ifstream file(path, std::ios::binary);
  file.read(start.data(), static_cast<std::streamsize>(start.size()));
  start.resize(static_cast<std::size_t>(file.gcount()));
  require_expected_content(path, start);
}

std::string read_expected_file(const std::filesystem::path& path, std::int64_t max_bytes) {
  std::string content = read_file(path, max_bytes);
  require_expected_content(path, content);
  return content;
}

}  // namespace griffith
