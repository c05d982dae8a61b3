#include "sim/meshing/tetgen.h"

#include <cmath>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <optional>

#include "sim/core/number_text.h"
#include "sim/core/replace_file.h"
#include "sim/core/temporary_folder.h"
#include "sim/mesh/read_mesh.h"

namespace griffith {
namespace {

namespace fs = std::filesystem;

/// Ratio of the bound given to TetGen to the desired mean edge, since it stays well below its bounds.
constexpr double kAllowance = 1.3;

/// Returns TetGen's .poly: points, then a facet of one triangle each, all with the marker 1.
std::string poly_text(const TriangleSurface& surface) {
  std::string text;
  append_number(text, surface.points.size(), ' ');
  text += "3 0 0\n";
  for (std::size_t i = 0; i < surface.points.size(); ++i) {
    append_number(text, i, ' ');
    for (int axis = 0; axis < 3; ++axis) append_number(text, surface.points[i][axis], axis < 2 ? ' ' : '\n');
  }
  append_number(text, surface.triangles.size(), ' ');
  text += "1\n";
  for (const auto& triangle : surface.triangles) {
    text += "1 0 1\n3 ";
    for (int corner = 0; corner < 3; ++corner) append_number(text, triangle[corner], corner < 2 ? ' ' : '\n');
  }
  return text + "0\n0\n";
}

/// Returns TetGen's .var: facets with the marker 1 have triangles of at most the area of a regular one.
std::string var_text(double element_size) {
  const double edge = kAllowance * element_size;
  std::string text = "1\n0 1 ";
  append_number(text, std::sqrt(3.0) / 4 * edge * edge, '\n');
  return text + "0\n";
}

std::string switches(const MeshingOptions& options, double element_size) {
  const double inner_size = kAllowance * options.grading * element_size;
  const double volume = inner_size * inner_size * inner_size / (6 * std::sqrt(2.0));
  char text[128];
  std::snprintf(text, sizeof text, "-pq%.6g/%.6ga%.17gzFB", options.radius_edge_ratio, options.min_dihedral_angle,
                volume);
  return text;
}

/// Returns the stage in a line: "Refining mesh..." is one; "Refinement seconds:  0.07" is none.
std::optional<std::string> stage_in(const std::string& line) {
  const std::size_t dots = line.find("...");
  if (dots == std::string::npos || dots == 0) return std::nullopt;
  return line.substr(0, line.find_last_not_of(' ', dots - 1) + 1);
}

std::string refusal_of(const ProcessOutcome& outcome, const std::string& stage) {
  if (outcome.end == ProcessOutcome::End::not_found)
    return "TetGen is not installed or not in PATH (Debian's package is tetgen)";
  const std::string code = std::to_string(outcome.code);
  const bool aborted = outcome.end == ProcessOutcome::End::killed_by_signal && outcome.code == SIGABRT;
  const std::string how = aborted                                      ? "aborted"
                          : outcome.end == ProcessOutcome::End::exited ? "ended with exit code " + code
                                                                       : "was ended by signal " + code;
  return "TetGen " + how + (stage.empty() ? " at its start" : " at \"" + stage + "\"");
}

/// True if the program probably ran out of memory. It does not report this, but memory was short.
bool ran_out_of_memory(const ProcessOutcome& outcome, const ProcessLimits& limits) {
  return !outcome.succeeded() && outcome.peak_memory_bytes > limits.memory_bytes / 2;
}

/// Returns the failure if a limit ended the program; none otherwise.
std::optional<TetgenResult> beyond_limits(const ProcessOutcome& outcome, const ProcessLimits& limits) {
  constexpr double kMegabyte = 1 << 20;
  char amount[64];
  if (outcome.end == ProcessOutcome::End::out_of_time) {
    std::snprintf(amount, sizeof amount, "%.3g s", limits.seconds);
    return TetgenResult{{},
                        std::string("TetGen did not finish within the time limit of ") + amount,
                        "use a larger element size or time limit"};
  }
  if (ran_out_of_memory(outcome, limits)) {
    std::snprintf(amount, sizeof amount, "%.0f MB", static_cast<double>(limits.memory_bytes) / kMegabyte);
    return TetgenResult{{},
                        std::string("TetGen needs more than the memory limit of ") + amount,
                        "use a larger element size or memory limit"};
  }
  return std::nullopt;
}

}  // namespace

TetgenResult run_tetgen(const TriangleSurface& surface, const MeshingOptions& options, double element_size,
                        const ProcessLimits& limits, const Monitor& monitor) {
  const TemporaryFolder folder;
  replace_file(folder.path() / "surface.poly", poly_text(surface));
  replace_file(folder.path() / "surface.var", var_text(element_size));
  std::string stage;
  const auto on_line = [&](const std::string& line) {
    const auto found = stage_in(line);
    if (!found) return;
    stage = *found;
    monitor.enter("TetGen: " + stage);
  };
  // Without stdbuf its lines would stay in its buffer until the end, and be lost if it aborts.
  const ProcessOutcome outcome = run_process(
      {"stdbuf", "-oL", "tetgen", switches(options, element_size), (folder.path() / "surface.poly").string()}, limits,
      on_line, [&] { return folder.termination_requested() || monitor.is_cancelled(); });
  if (outcome.end == ProcessOutcome::End::cancelled) throw Cancelled();
  if (auto beyond = beyond_limits(outcome, limits)) return *std::move(beyond);
  TetgenResult result;
  const fs::path elements = folder.path() / "surface.1.ele";
  if (!outcome.succeeded() || !fs::exists(elements)) {
    result.refusal = refusal_of(outcome, stage);
    if (outcome.end == ProcessOutcome::End::not_found) result.remedy = "install TetGen";
    return result;
  }
  monitor.enter("Reading TetGen's mesh");
  result.soup = read_mesh(elements);
  if (result.soup.tets.empty()) result.refusal = "TetGen found no inside";
  return result;
}

}  // namespace griffith
