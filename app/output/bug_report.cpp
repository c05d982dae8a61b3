#include "app/output/bug_report.h"

namespace griffith::app {
namespace {

constexpr char kReadme[] =
    "A bug report of Griffith: a run with all that is needed to make it again.\n"
    "\n"
    "  griffith replay FILE                  makes the run again from this archive, and tells the first step that "
    "differs\n"
    "  griffith replay FILE --extract DIR    unpacks it; tar --zstd -xf FILE does, too\n"
    "  griffith DIR/scene.json               opens its scene in the editor\n"
    "\n"
    "scene.json      the scene as the run began\n"
    "assets/         the files that it is built from, and the meshes that filled its surfaces\n"
    "inputs.json     shots and changes of material, with their steps\n"
    "hashes.csv      hashes of the state after each step, by field\n"
    "versions.json   what made the run\n"
    "log.txt         what was said meanwhile\n"
    "screenshot.png  the last step, where there were graphics to draw it\n";

}  // namespace

void add_report(Recording& recording, const ReportParts& parts) {
  recording.extras["README.txt"] = kReadme;
  recording.extras["log.txt"] += parts.log;
  if (parts.picture) recording.extras["screenshot.png"] = render::encode_png(*parts.picture);
}

}  // namespace griffith::app
