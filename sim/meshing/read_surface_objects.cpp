#include <dlfcn.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <fstream>
#include <stdexcept>

#include "sim/core/error.h"
#include "sim/core/file_content.h"
#include "sim/core/read_file.h"
#include "sim/core/temporary_folder.h"
#include "sim/meshing/surface_objects.h"

namespace griffith {
namespace {

namespace fs = std::filesystem;

constexpr std::array kFormats = {".obj", ".stl", ".ply", ".off", ".gltf", ".glb"};
constexpr std::uintmax_t kMaxBytes = 1 << 30;
constexpr char kRemedy[] = "the file is damaged: export the surface again";

/// Throws for a PLY file with an unterminated header, since Assimp's reader would never end.
void require_ply_header(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("end_header")) return;
  throw InputError(path.string(), "cannot be read: its header has no end", "a line \"end_header\" is missing");
}

void require_known_file(const fs::path& path) {
  require_regular_file(path);
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  if (std::find(kFormats.begin(), kFormats.end(), extension) == kFormats.end())
    throw InputError(path.string(), "is not a known surface format", ".obj, .stl, .ply, .off, .gltf or .glb");
  const std::uintmax_t size = fs::file_size(path);
  if (size == 0) throw InputError(path.string(), "is empty", "export the surface again");
  if (size > kMaxBytes) throw InputError(path.string(), "is larger than a gigabyte", "export it with fewer triangles");
  require_expected_content(path);
  if (extension == ".ply") require_ply_header(path);
}

constexpr char kReader[] = "griffith_surface_reader";

fs::path folder_of_this_program() {
  std::error_code error;
  return fs::read_symlink("/proc/self/exe", error).parent_path();
}

/// Returns the folder of the shared library that holds this code, or of the program if it is linked statically.
fs::path folder_of_this_code() {
  Dl_info info{};
  return dladdr(&kReader, &info) && info.dli_fname ? fs::path(info.dli_fname).parent_path() : fs::path();
}

/// Returns the reader beside this program or library, else in its build folder, else its name alone, to be found in
/// PATH.
fs::path reader_program() {
  std::error_code error;
  for (const fs::path& folder : {folder_of_this_program(), folder_of_this_code()})
    if (fs::exists(folder / kReader, error)) return folder / kReader;
  if (fs::exists(GRIFFITH_SURFACE_READER, error)) return GRIFFITH_SURFACE_READER;
  return kReader;
}

[[noreturn]] void refuse_without_reader() {
  throw std::runtime_error(std::string(kReader) + " is missing: copy it beside the program, into " +
                           folder_of_this_program().string() +
                           ", or name its folder in PATH (it is installed with the library, in bin)");
}

/// Returns limits of ten times the needs of the slowest format, with as much memory as TetGen may take.
ProcessLimits limits_for(std::uintmax_t file_size) {
  const auto bytes = static_cast<std::int64_t>(file_size);
  return {20 + 5e-6 * static_cast<double>(bytes),
          std::min((std::int64_t{2} << 30) + 100 * bytes, std::int64_t{8} << 30)};
}

void require_success(const ProcessOutcome& outcome, const ProcessLimits& limits, const fs::path& path) {
  if (outcome.end == ProcessOutcome::End::cancelled) throw Cancelled();
  if (outcome.end == ProcessOutcome::End::out_of_time) {
    const std::string seconds = std::to_string(static_cast<int>(limits.seconds));
    throw InputError(path.string(), "cannot be read: its reader did not finish within " + seconds + " s", kRemedy);
  }
  if (outcome.end == ProcessOutcome::End::killed_by_signal)
    throw InputError(path.string(), "cannot be read: its reader was ended by signal " + std::to_string(outcome.code),
                     kRemedy);
  if (outcome.end == ProcessOutcome::End::not_found) refuse_without_reader();
  if (outcome.code == 0) return;
  if (outcome.code == kReaderOutOfMemory)
    throw InputError(path.string(),
                     "cannot be read with " + std::to_string(limits.memory_bytes >> 20) + " MB of memory, the limit",
                     "export it with fewer triangles; if it is small, it is damaged");
  const std::size_t line = outcome.output.find('\n');
  const std::string problem = outcome.output.substr(0, line);
  const std::string rest = line == std::string::npos ? "" : outcome.output.substr(line + 1);
  throw InputError(path.string(), problem.empty() ? "cannot be read" : problem,
                   outcome.code == 2 ? rest.substr(0, rest.find('\n')) : kRemedy);
}

}  // namespace

std::vector<SurfaceObject> read_surface_objects(const fs::path& path, const Monitor& monitor,
                                                std::optional<ProcessLimits> limits) {
  require_known_file(path);
  const TemporaryFolder folder;
  const fs::path objects = folder.path() / "objects";
  if (!limits) limits = limits_for(fs::file_size(path));
  const auto cancelled = [&] { return folder.termination_requested() || monitor.is_cancelled(); };
  const ProcessOutcome outcome =
      run_process({reader_program().string(), fs::absolute(path).string(), objects.string()}, *limits, {}, cancelled);
  require_success(outcome, *limits, path);
  auto decoded = decode_objects(read_file(objects, limits->memory_bytes));
  if (!decoded) throw std::runtime_error("griffith_surface_reader belongs to another version of this program");
  return std::move(*decoded);
}

}  // namespace griffith
