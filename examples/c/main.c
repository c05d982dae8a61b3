/* A wall, a ball shot at it, and the resulting pieces. */
#include <griffith/griffith.h>
#include <inttypes.h>
#include <stdio.h>

static int fail(const griffith_error* error) {
  fprintf(stderr, "%s: %s (%s)\n", error->where, error->problem, error->remedy);
  return 1;
}

int main(int argc, char** argv) {
  const char* path = argc > 1 ? argv[1] : "scenes/wall_small.json";
  griffith_error error;
  griffith_scene* scene = NULL;
  griffith_world* world = NULL;
  griffith_array masses, utilization;
  if (griffith_scene_read(path, &scene, &error) != GRIFFITH_OK ||
      griffith_world_create(scene, NULL, &world, &error) != GRIFFITH_OK ||
      griffith_world_step(world, 60, &error) != GRIFFITH_OK ||
      griffith_world_array(world, GRIFFITH_BODY_MASSES, &masses, &error) != GRIFFITH_OK ||
      griffith_world_array(world, GRIFFITH_NODE_UTILIZATION, &utilization, &error) != GRIFFITH_OK)
    return fail(&error);

  double highest = 0;
  for (int64_t i = 0; i < utilization.count; ++i) {
    const double value = *(const double*)((const char*)utilization.data + i * utilization.stride);
    if (value > highest) highest = value;
  }
  for (int64_t i = 0; i < masses.count; ++i)
    printf("%10.1f kg\n", *(const double*)((const char*)masses.data + i * masses.stride));
  printf("%" PRId64 " pieces, highest utilization %.3f, state %016" PRIx64 "\n", masses.count, highest,
         griffith_world_state_hash(world));

  griffith_world_destroy(world);
  griffith_scene_destroy(scene);
  return 0;
}
