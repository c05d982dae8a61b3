// griffith_surface_reader SURFACE OUT: reads a surface file and writes its objects as bytes. See surface_objects.h.

#include <cstdio>
#include <exception>
#include <new>

#include "sim/core/error.h"
#include "sim/core/replace_file.h"
#include "sim/meshing/surface_objects.h"

int main(int count, char** arguments) try {
  if (count != 3) {
    std::fputs("usage: griffith_surface_reader SURFACE OUT\n", stdout);
    return 1;
  }
  griffith::replace_file(arguments[2], griffith::encode(griffith::import_objects(arguments[1])));
  return 0;
} catch (const griffith::InputError& error) {
  std::printf("%s\n%s\n", error.problem().c_str(), error.remedy().c_str());
  return 2;
} catch (const std::bad_alloc&) {
  return griffith::kReaderOutOfMemory;
} catch (const std::exception& error) {
  std::printf("%s\n", error.what());
  return 1;
}
