#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "sim/mesh/tet_mesh.h"

namespace griffith {

/// Named array of numbers, vectors or tensors. The caller owns the values.
struct MeshField {
  std::string name;
  std::variant<std::span<const double>, std::span<const std::int32_t>, std::span<const Vec3>, std::span<const Mat3>>
      values;
};

/// Fields on a mesh: one value per node, one value per tet.
struct VtuFields {
  std::vector<MeshField> per_node, per_tet;
};

/// Writes a VTK XML unstructured grid (.vtu, raw appended, little-endian, uncompressed), exact to the last bit. Tensors
/// have nine components, row by row. Each field must have as many values as there are nodes or tets. The file is
/// written beside `path` and renamed. Throws InputError if that fails. `middles`, per tet: the positions in the middle
/// of its edges, ordered as kTetEdges, for a quadratic cell, or -1 for a linear one; empty: all are linear.
void write_vtu(const std::filesystem::path& path, std::span<const Vec3> positions,
               std::span<const std::array<NodeId, 4>> tets, const VtuFields& fields = {},
               std::span<const std::array<std::int32_t, 6>> middles = {});

/// Writes Gmsh MSH 2.2 as text with enough digits to read back exactly. All tets belong to physical group 1. Files are
/// replaced as by write_vtu().
void write_gmsh(const std::filesystem::path& path, const TetSoup& soup);
/// Returns the text that write_gmsh() writes.
std::string gmsh_text(const TetSoup& soup);

/// Writes TetGen's X.node and X.ele, given either one, numbered from 0 and with enough digits to read back exactly.
/// Files are replaced as by write_vtu().
void write_tetgen(const std::filesystem::path& path, const TetSoup& soup);

}  // namespace griffith
