#include "sim/recording/hash_table.h"

#include <charconv>
#include <cstdio>

#include "sim/core/error.h"

namespace griffith {
namespace {

std::string heading() {
  std::string line = "step";
  for (const std::string_view field : kStateFields) line.append(",").append(field);
  return line;
}

/// Removes and returns the first line of `text`, without its end.
std::string_view take_line(std::string_view& text) {
  const std::size_t end = text.find('\n');
  std::string_view line = text.substr(0, end);
  text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

/// Removes a number and its separator from the row. Returns false if there is none.
template <class Whole>
bool take_number(std::string_view& row, Whole& number, int base) {
  const auto [end, error] = std::from_chars(row.data(), row.data() + row.size(), number, base);
  if (error != std::errc()) return false;
  row.remove_prefix(static_cast<std::size_t>(end - row.data()));
  if (row.empty()) return true;
  if (row.front() != ',' || row.size() == 1) return false;
  row.remove_prefix(1);
  return true;
}

bool read_row(std::string_view row, std::size_t step, StateHashes& hashes) {
  std::size_t number = 0;
  constexpr std::size_t kDigits = 16;
  if (!take_number(row, number, 10) || number != step || row.size() != hashes.size() * (kDigits + 1) - 1) return false;
  for (std::uint64_t& hash : hashes)
    if (row.empty() || !take_number(row, hash, 16)) return false;
  return row.empty();
}

}  // namespace

std::string hashes_to_csv(const std::vector<StateHashes>& hashes) {
  std::string text = heading() + "\n";
  for (std::size_t step = 0; step < hashes.size(); ++step) {
    text += std::to_string(step);
    for (const std::uint64_t hash : hashes[step]) {
      char digits[20];
      std::snprintf(digits, sizeof digits, ",%016llx", static_cast<unsigned long long>(hash));
      text += digits;
    }
    text += '\n';
  }
  return text;
}

std::vector<StateHashes> hashes_from_csv(std::string_view text, const std::string& where, const std::string& program) {
  if (take_line(text) != heading())
    throw InputError(where, "holds hashes of other fields than this program has",
                     "replay it with the version that made it" + (program.empty() ? "" : ": " + program));
  std::vector<StateHashes> hashes;
  while (!text.empty()) {
    const std::size_t step = hashes.size();
    if (!read_row(take_line(text), step, hashes.emplace_back()))
      throw InputError(where + ":" + std::to_string(step + 2), "is not a row of hashes of step " + std::to_string(step),
                       "use an unchanged recording");
  }
  if (hashes.empty()) throw InputError(where, "holds no hashes", "use an unchanged recording");
  return hashes;
}

}  // namespace griffith
