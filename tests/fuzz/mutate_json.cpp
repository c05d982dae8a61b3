#include "tests/fuzz/mutate_json.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "tests/fuzz/mutate_bytes.h"

namespace griffith::fuzz {
namespace {

/// A value in the document, the name of the field that holds it (or its array), and what it stands in.
struct Node {
  Json* value = nullptr;
  Json* parent = nullptr;
  std::string field;
  std::size_t index = 0;  ///< in the parent
};

void collect(Json& value, Json* parent, const std::string& field, std::size_t index, std::vector<Node>& nodes) {
  nodes.push_back({&value, parent, field, index});
  std::size_t i = 0;
  if (value.is_object())
    for (const auto& [name, child] : value.items()) collect(child, &value, name, i++, nodes);
  if (value.is_array())
    for (Json& child : value) collect(child, &value, field, i++, nodes);
}

std::vector<Node> nodes_of(Json& document) {
  std::vector<Node> nodes;
  collect(document, nullptr, "", 0, nodes);
  return nodes;
}

// --- Values ---------------------------------------------------------------------------------------------------------

/// A word that is to stand in the text as it is, without quotes: JSON values cannot hold a NaN or 1e999.
Json bare(const std::string& word) { return "@" + word + "@"; }

Json extreme_value(RandomValues& random) {
  static const std::vector<std::string> kTexts = {
      "", ".", "..", "/", "/dev/zero", "/dev/null", "a\nb", "\xe2\x88\x9e", "box", "%s%n", "null"};
  if (chance(random, 0.75)) return bare(pick(random, extreme_words()));
  if (chance(random, 0.05)) return std::string(100000, 'x');
  return pick(random, kTexts);
}

Json of_another_type(RandomValues& random) {
  static const std::vector<Json> kValues = {nullptr,
                                            true,
                                            false,
                                            0,
                                            1.5,
                                            "text",
                                            Json::array(),
                                            Json::object(),
                                            Json::array({1, 2, 3}),
                                            Json::array({nullptr}),
                                            Json::array({Json::array()}),
                                            Json::object({{"name", 1}})};
  return pick(random, kValues);
}

double nudged(double value, RandomValues& random) {
  switch (random.index(6)) {
    case 0:
      return value * random.uniform(0.5, 2);
    case 1:
      return value * std::pow(10, random.uniform(-3, 3));
    case 2:
      return -value;
    case 3:
      return value + random.uniform(-1, 1);
    case 4:
      return std::round(value) + random.index(3) - 1;
    default:
      return value * (1 + random.uniform(-1e-9, 1e-9));
  }
}

void nudge(Json& value, RandomValues& random) {
  if (value.is_number_integer()) {
    value = static_cast<std::int64_t>(std::clamp(nudged(value.get<double>(), random), -1e9, 1e9));
  } else if (value.is_number()) {
    value = nudged(value.get<double>(), random);
  } else if (value.is_boolean()) {
    value = !value.get<bool>();
  } else if (value.is_array()) {
    for (Json& item : value)
      if (item.is_number()) nudge(item, random);
  }
}

/// As if another unit had been meant; the scene stays the same but for its size.
void scale_lengths(const std::vector<Node>& nodes, RandomValues& random) {
  static const std::set<std::string, std::less<>> kLengths = {
      "size",    "element_size", "radius", "length", "thickness",  "hole_radius", "notch_depth", "position", "minimum",
      "maximum", "center",       "point",  "height", "first_ring", "mortar",      "origin",      "target",   "points"};
  const double factor = std::pow(10, random.uniform(-3, 3));
  for (const Node& node : nodes)
    if (node.value->is_number() && kLengths.contains(node.field)) *node.value = node.value->get<double>() * factor;
}

// --- Structure ------------------------------------------------------------------------------------------------------

void remove(const Node& node) {
  if (node.parent) erase_at(*node.parent, node.index);
}

void repeat(const Node& node, RandomValues& random) {
  if (!node.parent || !node.parent->is_array()) return;
  const Json copy = *node.value;
  for (int i = chance(random, 0.9) ? 1 : 1 + random.index(20); i > 0; --i) {
    node.parent->push_back(copy);
    Json& added = node.parent->back();
    if (added.is_object() && added.contains("name")) added["name"] = "copy " + std::to_string(node.parent->size());
  }
}

/// Replaces a node by the donor's value of the same name.
void splice(const Node& node, Json donor, RandomValues& random) {
  std::vector<Node> candidates = nodes_of(donor);
  std::erase_if(candidates, [&](const Node& other) { return other.field != node.field; });
  if (!candidates.empty()) *node.value = Json(*pick(random, candidates).value);
}

void add_field(const Node& node, const Json& donor, const Vocabulary& words, RandomValues& random) {
  const auto known = words.fields.find(node.field);
  if (known == words.fields.end() || !node.value->is_object()) return;
  const std::string name = pick(random, known->second);
  Json& added = (*node.value)[name];
  const auto values = words.values.find(name);
  if (values != words.values.end()) added = pick(random, values->second);
  if (added.is_null() || chance(random, 0.5)) splice({&added, node.value, name, 0}, donor, random);
}

void change(Json& scene, const Json& donor, const Vocabulary& words, RandomValues& random) {
  const std::vector<Node> nodes = nodes_of(scene);
  const Node node = pick(random, nodes), other = pick(random, nodes);
  const int way = random.index(100);
  const auto known = words.values.find(node.field);
  if (way < 30) return nudge(*node.value, random);
  if (way < 47 && known != words.values.end()) return void(*node.value = pick(random, known->second));
  if (way < 62) return splice(node, donor, random);
  if (way < 74) return add_field(node, donor, words, random);
  if (way < 82) return void(*node.value = extreme_value(random));
  if (way < 86) return void(*node.value = of_another_type(random));
  if (way < 90) return remove(node);
  if (way < 94) return repeat(node, random);
  if (way < 96) return scale_lengths(nodes, random);
  if (node.value->type() == other.value->type() && !node.value->is_structured()) node.value->swap(*other.value);
}

// --- Text -----------------------------------------------------------------------------------------------------------

std::string text_of(const Json& scene) {
  std::string text = scene.dump(-1, ' ', false, Json::error_handler_t::ignore);
  for (const std::string mark : {"\"@", "@\""})
    for (std::size_t at = 0; (at = text.find(mark, at)) != std::string::npos;) text.erase(at, mark.size());
  return text;
}

/// Damages text for the parser: duplicate keys, deep nesting, a byte order mark, bytes that are not UTF-8.
std::string damaged_text(std::string text, RandomValues& random) {
  const std::size_t brace = text.find('{', static_cast<std::size_t>(random.index(static_cast<int>(text.size()) + 1)));
  switch (random.index(8)) {
    case 0:
      if (brace != std::string::npos) text.insert(brace + 1, "\"name\": 1, \"name\": 2, ");
      return text;
    case 1: {
      const std::size_t depth = std::size_t{1} << random.index(18);
      return "{\"version\": 1, \"bodies\": " + std::string(depth, '[') + std::string(depth, ']') + "}";
    }
    case 2:
      return "\xef\xbb\xbf" + text;
    case 3:
      return mutate_bytes(std::move(text), random);
    default:
      return mutate_text(std::move(text), random);
  }
}

}  // namespace

std::string mutate_scene(Json scene, const Json& donor, const Vocabulary& words, RandomValues& random) {
  do change(scene, donor, words, random);
  while (chance(random, 0.5));
  std::string text = text_of(scene);
  return chance(random, 0.06) ? damaged_text(std::move(text), random) : text;
}

}  // namespace griffith::fuzz
