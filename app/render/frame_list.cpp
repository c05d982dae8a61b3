#include "app/render/frame_list.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <sstream>

#include "sim/core/error.h"

namespace griffith::app {
namespace {

constexpr int kMaxFrame = 10'000'000;
constexpr std::size_t kMaxCount = 10'000'001;

std::optional<int> whole_number(const std::string& text) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || value < 0 || value > kMaxFrame) return std::nullopt;
  return value;
}

/// Parses the numbers of "0:240:10"; empty for another form.
std::optional<std::vector<int>> colon_numbers(const std::string& item) {
  std::vector<int> numbers;
  std::istringstream parts(item + ":");
  for (std::string part; std::getline(parts, part, ':');) {
    const std::optional<int> number = whole_number(part);
    if (!number) return std::nullopt;
    numbers.push_back(*number);
  }
  if (numbers.empty() || numbers.size() > 3) return std::nullopt;
  return numbers;
}

}  // namespace

std::vector<int> frames_from_text(const std::string& text, const std::string& where) {
  std::vector<int> frames;
  std::istringstream items(text + ",");
  for (std::string item; std::getline(items, item, ',');) {
    const auto numbers = colon_numbers(item);
    if (!numbers || (numbers->size() == 3 && numbers->back() == 0) ||
        (numbers->size() > 1 && (*numbers)[1] < numbers->front()))
      throw InputError(where, "\"" + item + "\" is not a list of time steps",
                       "write a number or FROM:TO:STRIDE, such as 0:240:10; join several with commas");
    const int first = numbers->front(), last = numbers->size() > 1 ? (*numbers)[1] : first;
    const int every = numbers->size() > 2 ? numbers->back() : 1;
    for (int frame = first; frame <= last; frame += every) {
      frames.push_back(frame);
      if (frames.size() > kMaxCount)
        throw InputError(where, "asks for more than 10,000,000 pictures", "use fewer, as with FROM:TO:STRIDE");
    }
  }
  std::ranges::sort(frames);
  frames.erase(std::ranges::unique(frames).begin(), frames.end());
  return frames;
}

}  // namespace griffith::app
