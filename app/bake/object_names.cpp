#include "app/bake/object_names.h"

#include <cstdio>
#include <set>

namespace griffith::app {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

/// Makes an identifier: file formats do not allow names to begin with a digit.
std::string word_of(const std::string& name) {
  std::string word;
  for (const char c : name) word += is_letter(c) || is_digit(c) ? c : '_';
  if (word.empty() || is_digit(word.front())) word.insert(0, 1, '_');
  return word;
}

}  // namespace

std::vector<std::string> name_stems(const Scene& scene) {
  std::vector<std::string> names;
  for (const BodyDescription& body : scene.bodies) names.push_back(body.name);
  names.push_back("projectile");
  std::vector<std::string> stems;
  std::set<std::string> taken;
  for (const std::string& name : names) {
    std::string stem = word_of(name);
    for (int i = 2; !taken.insert(stem).second; ++i) stem = word_of(name) + '_' + std::to_string(i);
    stems.push_back(stem);
  }
  return stems;
}

std::string numbered_name(const std::string& stem, int number) {
  char digits[16];
  std::snprintf(digits, sizeof digits, "_%04d", number);
  return stem + digits;
}

}  // namespace griffith::app
