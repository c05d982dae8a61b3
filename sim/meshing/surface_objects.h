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

/// Object of a surface file: a group of triangles and its name, which may be empty.
struct SurfaceObject {
  std::string name;
  TriangleSurface surface;
};

/// Reads the objects of a surface file in any format of read_surface(), without merging points. The reader runs as a
/// separate program, griffith_surface_reader, since damaged files can make it crash or never end. Throws InputError as
/// read_surface() does, Cancelled, and std::runtime_error if that program is missing. `limits`: those of the program;
/// by default they follow from the size of the file.
std::vector<SurfaceObject> read_surface_objects(const std::filesystem::path& path, const Monitor& monitor = {},
                                                std::optional<ProcessLimits> limits = {});

/// Exit code of griffith_surface_reader when it runs out of memory.
inline constexpr int kReaderOutOfMemory = 3;

/// Convert the objects to bytes, to pass them between programs, and back; none if the bytes are invalid.
std::string encode(const std::vector<SurfaceObject>& objects);
std::optional<std::vector<SurfaceObject>> decode_objects(std::string_view bytes);

/// Reads a file with Assimp in this process. Throws InputError if Assimp rejects it.
std::vector<SurfaceObject> import_objects(const std::filesystem::path& path);

}  // namespace griffith
