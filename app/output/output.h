#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/image.h"
#include "sim/core/error.h"

namespace griffith::app {

/// Makes text safe for a terminal: control characters (including Unicode marks that change the writing direction) and
/// bytes that are not UTF-8 become escapes, "\\x1b". Any printed text may come from a foreign file.
std::string printable(std::string_view text);

/// Prints to stdout, or to stderr, like printf(), with printable() applied to each line.
[[gnu::format(printf, 1, 2)]] void print(const char* format, ...);
[[gnu::format(printf, 1, 2)]] void print_error(const char* format, ...);

/// Prints an error to stderr: place and problem, then the remedy.
void explain(const InputError& error);

/// Writes a PNG file with replace_file(). Throws InputError.
void save_picture(const std::filesystem::path& path, const render::Image& image);

/// Throws InputError if the folder can be neither found nor made, or not written to. Removes stale files in it like
/// check_replaceable().
void check_folder(const std::filesystem::path& folder);

/// Throws InputError if output to stdout was lost; call it when everything is printed.
void check_stdout();

/// Writes the results of long work; an error of one does not prevent the others from being written.
class Outputs {
 public:
  /// Calls `output`, which may throw InputError.
  void write(const std::function<void()>& output);
  /// Throws the last InputError, if there is any, after explaining the earlier ones.
  void finish() const;

 private:
  std::vector<InputError> failures_;
};

}  // namespace griffith::app
