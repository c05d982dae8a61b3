#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/render/render_job.h"

namespace griffith::app {

/// A suite is a folder: suite.json, whose jobs read_render_jobs() reads, and goldens/RENDERER/NAME.png, the accepted
/// pictures of each renderer, each with its record (.json), its writing (.txt) and, without panels, its ids (.ids.png).
inline constexpr char kSuiteFile[] = "suite.json", kGoldenFolder[] = "goldens";

/// The endings of all files that a picture may have.
inline constexpr std::array<const char*, 4> kPictureFiles = {".png", ".json", ".txt", ".ids.png"};

/// One of equal parts of a suite, for one of several machines.
struct Shard {
  int index = 1, count = 1;  ///< 1 <= index <= count
};

/// "2/5". Throws InputError for anything else.
Shard shard_from_text(const std::string& text);

/// The jobs of a suite that are in the shard: every count-th one.
std::vector<RenderJob> suite_jobs(const std::filesystem::path& suite, const Shard& shard);

/// The name of a renderer's folder of goldens: "llvmpipe-LLVM-15.0.6-256-bits".
std::string renderer_folder(const std::string& renderer);

/// Where the golden files of a picture are, without their endings.
struct GoldenPlace {
  std::filesystem::path stem;
  bool other_renderer = false;  ///< of another than the one that was asked for
};

/// The golden picture of that name: this renderer's, or else the first other renderer's by name; nothing without any.
std::optional<GoldenPlace> find_golden(const std::filesystem::path& suite, const std::string& renderer,
                                       const std::string& picture);

/// Makes a picture that was drawn into `drawn` the renderer's golden one. Throws InputError when it cannot be written.
void accept_picture(const std::filesystem::path& suite, const std::string& renderer, const std::string& picture,
                    const std::filesystem::path& drawn);

/// Golden pictures of that renderer that no job draws.
std::vector<std::string> unused_goldens(const std::filesystem::path& suite, const std::string& renderer,
                                        const std::vector<RenderJob>& jobs);

/// Makes a suite of some pictures of each scene: its materials and its pieces, each in a color of its own, at three
/// time steps. Throws InputError where there is a suite already, and for scenes that cannot be read.
void make_suite(const std::filesystem::path& suite, const std::vector<std::filesystem::path>& scenes);

}  // namespace griffith::app
