#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/core/monitor.h"
#include "sim/core/process.h"
#include "sim/meshing/surface.h"

namespace griffith {

/// An object of a surface file: triangles that the file keeps together, and their name, which may be empty.
struct SurfaceObject {
  std::string name;
  TriangleSurface surface;
};

/// Reads the objects of a surface file in any format that read_surface() knows, as they stand in it: nothing is welded.
/// The format's reader runs as a program of its own, griffith_surface_reader, because damaged files can make it crash
/// or go on for ever. Throws InputError as read_surface() does, Cancelled, and std::runtime_error when that program is
/// missing. `limits`: of that program, unless they are to follow from the size of the file.
std::vector<SurfaceObject> read_surface_objects(const std::filesystem::path& path, const Monitor& monitor = {},
                                                std::optional<ProcessLimits> limits = {});

/// What griffith_surface_reader returns when its limit of memory does not suffice.
inline constexpr int kReaderOutOfMemory = 3;

/// The objects as bytes, for the way from that program to this, and back; nothing where the bytes are no such objects.
std::string encode(const std::vector<SurfaceObject>& objects);
std::optional<std::vector<SurfaceObject>> decode_objects(std::string_view bytes);

/// Reads a file with Assimp in this very process. Throws InputError where Assimp refuses it.
std::vector<SurfaceObject> import_objects(const std::filesystem::path& path);

}  // namespace griffith
