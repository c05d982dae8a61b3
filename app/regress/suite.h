#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/render/render_job.h"

namespace griffith::app {

/// A suite is a folder: suite.json, whose jobs read_render_jobs() reads, and goldens/RENDERER/NAME.png, the accepted
/// pictures of each renderer, each with its record (.json), its text (.txt) and, without panels, its ids (.ids.png).
inline constexpr char kSuiteFile[] = "suite.json", kGoldenFolder[] = "goldens";

/// Extensions of all files that a picture may have.
inline constexpr std::array<const char*, 4> kPictureFiles = {".png", ".json", ".txt", ".ids.png"};

/// One of equal parts of a suite, for one of several machines.
struct Shard {
  int index = 1, count = 1;  ///< 1 <= index <= count
};

/// Parses "2/5". Throws InputError for anything else.
Shard shard_from_text(const std::string& text);

/// Returns the jobs of a suite in the shard: every count-th one.
std::vector<RenderJob> suite_jobs(const std::filesystem::path& suite, const Shard& shard);

/// Returns the name of a renderer's folder of goldens: "llvmpipe-LLVM-15.0.6-256-bits".
std::string renderer_folder(const std::string& renderer);

/// Place of the golden files of a picture.
struct GoldenPlace {
  std::filesystem::path stem;
  bool other_renderer = false;  ///< true for another renderer than the requested one
};

/// Returns the golden picture of that name: this renderer's, or else the first other renderer's by name; empty without
/// any.
std::optional<GoldenPlace> find_golden(const std::filesystem::path& suite, const std::string& renderer,
                                       const std::string& picture);

/// Accepts a picture in `drawn` as the renderer's golden one. Throws InputError if it cannot be written.
void accept_picture(const std::filesystem::path& suite, const std::string& renderer, const std::string& picture,
                    const std::filesystem::path& drawn);

/// Returns the golden pictures of that renderer that no job draws.
std::vector<std::string> unused_goldens(const std::filesystem::path& suite, const std::string& renderer,
                                        const std::vector<RenderJob>& jobs);

/// Makes a suite with pictures of each scene, by material and by piece, at three time steps. Throws InputError if there
/// is a suite already, or a scene cannot be read.
void make_suite(const std::filesystem::path& suite, const std::vector<std::filesystem::path>& scenes);

}  // namespace griffith::app
