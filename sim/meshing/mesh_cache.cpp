#include "sim/meshing/mesh_cache.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <span>
#include <string_view>

#include "sim/core/bytes.h"
#include "sim/core/error.h"
#include "sim/core/hash_bytes.h"
#include "sim/core/read_file.h"
#include "sim/core/replace_file.h"

namespace griffith {
namespace {

namespace fs = std::filesystem;

/// Version of the meshes. Changes whenever the same surface and options would give another mesh.
constexpr std::string_view kFormat = "griffith mesh 5\n";

std::string options_text(const MeshingOptions& options) {
  char text[160];
  std::snprintf(text, sizeof text, "%d %.17g %.17g %.17g %.17g", static_cast<int>(options.method),
                options.element_size.value_or(0), options.grading, options.radius_edge_ratio,
                options.min_dihedral_angle);
  return text;
}

struct Header {
  std::int32_t method = 0, refusal_length = 0, points = 0, tets = 0;
  LatticeParting parting;
};

/// True if fill() could have made the mesh. The hash of its bytes detects damage, but not intent.
bool is_possible(const FilledSurface& filled) {
  const auto points = std::ssize(filled.soup.points);
  const auto known = [points](const auto& tet) {
    return std::ranges::all_of(tet, [points](int corner) { return 0 <= corner && corner < points; });
  };
  const bool method = filled.method == MeshingMethod::tetgen || filled.method == MeshingMethod::volumetric;
  const LatticeParting& parting = filled.parting;
  const bool counted = parting.pieces > 0 && parting.joined > 0 && parting.shells > 0 && parting.tried >= 0;
  const bool sized = parting.element_size >= 0 && parting.least_size >= 0;
  return method && counted && sized && !filled.soup.tets.empty() && std::ranges::all_of(filled.soup.tets, known) &&
         std::ranges::all_of(filled.soup.points, [](const Vec3& point) { return point.allFinite(); });
}

std::optional<FilledSurface> decode(std::string_view bytes) {
  std::uint64_t sum = 0;
  Header header;
  if (!bytes.starts_with(kFormat)) return std::nullopt;
  bytes.remove_prefix(kFormat.size());
  if (!take(bytes, &sum, 1) || hash_bytes(bytes) != sum || !take(bytes, &header, 1)) return std::nullopt;
  FilledSurface filled;
  filled.method = static_cast<MeshingMethod>(header.method);
  filled.parting = header.parting;
  const bool whole = take_values(bytes, filled.refusal, header.refusal_length) &&
                     take_values(bytes, filled.soup.points, header.points) &&
                     take_values(bytes, filled.soup.tets, header.tets) && bytes.empty();
  return whole && is_possible(filled) ? std::optional(std::move(filled)) : std::nullopt;
}

}  // namespace

fs::path default_mesh_cache() {
  if (const char* cache = std::getenv("XDG_CACHE_HOME"); cache && *cache) return fs::path(cache) / "griffith";
  if (const char* home = std::getenv("HOME"); home && *home) return fs::path(home) / ".cache" / "griffith";
  return {};
}

fs::path cache_entry(const fs::path& folder, const TriangleSurface& surface, const MeshingOptions& options) {
  const std::string settings = std::string(kFormat) + options_text(options);
  std::array<std::uint64_t, 2> key = {0, 1};
  for (std::uint64_t& part : key)
    for (const std::string_view bytes :
         {std::string_view(settings), bytes_of(surface.points), bytes_of(surface.triangles)})
      part = hash_bytes(bytes, part);
  char name[48];
  std::snprintf(name, sizeof name, "%016llx%016llx.tets", static_cast<unsigned long long>(key[0]),
                static_cast<unsigned long long>(key[1]));
  return folder / name;
}

std::optional<FilledSurface> read_cache_entry(const fs::path& path) try {
  constexpr std::int64_t kMaxBytes = 1 << 30;
  return decode(read_file(path, kMaxBytes));
} catch (const InputError&) {
  return std::nullopt;
}

void write_cache_entry(const fs::path& path, const FilledSurface& filled) {
  const Header header = {static_cast<std::int32_t>(filled.method), static_cast<std::int32_t>(filled.refusal.size()),
                         static_cast<std::int32_t>(filled.soup.points.size()),
                         static_cast<std::int32_t>(filled.soup.tets.size()), filled.parting};
  std::string content(bytes_of(std::span(&header, 1)));
  content.append(filled.refusal).append(bytes_of(filled.soup.points)).append(bytes_of(filled.soup.tets));
  const std::uint64_t sum = hash_bytes(content);
  std::error_code ignored;
  fs::create_directories(path.parent_path(), ignored);
  remove_stale_files(path.parent_path());
  try {
    replace_file(path, std::string(kFormat).append(bytes_of(std::span(&sum, 1))) + content);
  } catch (const InputError&) {
    // A full or read-only disk costs only time.
  }
}

}  // namespace griffith
