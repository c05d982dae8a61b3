#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/image.h"
#include "sim/core/error.h"

namespace griffith::app {

/// Text as a terminal may be given it: control characters (also those of Unicode that turn the direction of writing)
/// and bytes that are not UTF-8 stand as escapes, "\\x1b". All that is printed may come from a file of somebody else's.
std::string printable(std::string_view text);

/// Prints to stdout, or to stderr, as printf() does, what printable() makes of each line.
[[gnu::format(printf, 1, 2)]] void print(const char* format, ...);
[[gnu::format(printf, 1, 2)]] void print_error(const char* format, ...);

/// Prints an error to stderr: place and problem, and below them the remedy.
void explain(const InputError& error);

/// Writes a PNG file as replace_file() does. Throws InputError.
void save_picture(const std::filesystem::path& path, const render::Image& image);

/// Throws InputError when a folder of that name can be neither found nor made, or not written to. Removes stale files
/// in it, as check_replaceable() does.
void check_folder(const std::filesystem::path& folder);

/// Throws InputError when anything that was printed to stdout did not get there: call it when all is printed.
void check_stdout();

/// Writes the results of long work: one that cannot be written keeps none of the others from being written.
class Outputs {
 public:
  /// Calls `output`, which may throw InputError.
  void write(const std::function<void()>& output);
  /// Throws the last InputError, if there is any, when it has explained the ones before.
  void finish() const;

 private:
  std::vector<InputError> failures_;
};

}  // namespace griffith::app
