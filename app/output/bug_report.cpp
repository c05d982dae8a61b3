#include "app/output/bug_report.h"

namespace griffith::app {
namespace {

constexpr char kReadme[] =
    "A bug report of Griffith: a run with everything needed to repeat it.\n"
    "\n"
    "  griffith replay FILE                  repeats the run from this archive, and reports the first step that "
    "differs\n"
    "  griffith replay FILE --extract DIR    unpacks it; so does tar --zstd -xf FILE\n"
    "  griffith DIR/scene.json               opens its scene in the editor\n"
    "\n"
    "scene.json      the scene at the start of the run\n"
    "assets/         its files, and the meshes of its surfaces\n"
    "inputs.json     shots, grabs and changes of material, with their steps\n"
    "hashes.csv      hashes of the state after each step, by field\n"
    "versions.json   versions of the program and its libraries\n"
    "log.txt         messages\n"
    "screenshot.png  the last step, if graphics were available\n";

}  // namespace

void add_report(Recording& recording, const ReportParts& parts) {
  recording.extras["README.txt"] = kReadme;
  recording.extras["log.txt"] += parts.log;
  if (parts.picture) recording.extras["screenshot.png"] = render::encode_png(*parts.picture);
}

}  // namespace griffith::app
