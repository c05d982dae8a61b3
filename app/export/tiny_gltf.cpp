#define TINYGLTF_IMPLEMENTATION
#include "app/export/tiny_gltf.h"
