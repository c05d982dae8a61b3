#include "bindings/c/guarded.h"

using namespace griffith::c;

// Pictures in a library built without the renderer: always an error.

griffith_status griffith_painter_create(const griffith_world*, std::int32_t, std::int32_t, const char*, const char*,
                                        griffith_painter**, griffith_error* error) {
  return guarded(error, [] {
    throw griffith::InputError("griffith_painter_create", "the library was built without the renderer",
                               "build it with GRIFFITH_BUILD_EDITOR");
  });
}

griffith_status griffith_painter_paint(griffith_painter*, const griffith_world*, griffith_array*,
                                       griffith_error* error) {
  return guarded(error, [] { require(false, "painter", "is null", "pass an object that the library made"); });
}

void griffith_painter_destroy(griffith_painter*) {}
