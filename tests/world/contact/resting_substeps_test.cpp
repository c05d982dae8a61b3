#include <gtest/gtest.h>

#include "sim/scene/scene_reader.h"
#include "sim/world/world.h"

namespace griffith {
namespace {

// Contacts let what rests sink in by a share of its own size, here by more than the share of an element for which
// substeps of bodies that turn below the ground are undone.
TEST(RestingSubsteps, AreNotUndoneForTheOverlapThatContactsLeave) {
  World world(read_scene(GRIFFITH_SOURCE_DIR "/scenes/prince_ruperts_drop.json"));
  int divided = 0;
  for (int step = 0; step < 30; ++step) {
    world.step();
    divided += world.frame().report.substeps > 1;
  }
  EXPECT_LE(divided, 1);
}

}  // namespace
}  // namespace griffith
