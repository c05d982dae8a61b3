#include "sim/scene/json_document.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

namespace griffith {
namespace {

constexpr std::size_t kMaxDepth = 64;
constexpr std::size_t kMaxLine = 110;
/// A few characters of text can take a hundred bytes of memory, so limits apply during reading. An array or object
/// counts as several plain values.
constexpr std::size_t kMaxWeight = 20'000'000, kStructureWeight = 8;
constexpr std::size_t kMaxDuplicates = 1000;

/// Returns the parser's message without its number and position, which the error has already.
std::string plain_message(std::string message) {
  message.erase(0, message.find("] ") + 2);
  if (message.starts_with("parse error at")) message.erase(0, message.find(": ") + 2);
  return message;
}

/// Builder of the document from the parser's events, which sees duplicate keys and positions.
class DocumentBuilder : public nlohmann::json_sax<Json> {
 public:
  DocumentBuilder(std::string_view text, const std::string& file, std::vector<InputError>& problems)
      : text_(text), file_(file), problems_(problems) {}

  Json take_root() { return std::move(root_); }

  bool null() override { return add(nullptr); }
  bool boolean(bool value) override { return add(value); }
  bool number_integer(number_integer_t value) override { return add(value); }
  bool number_unsigned(number_unsigned_t value) override { return add(value); }
  bool number_float(number_float_t value, const string_t&) override { return add(value); }
  bool string(string_t& value) override { return add(std::move(value)); }
  bool binary(binary_t&) override { return false; }
  bool start_object(std::size_t) override { return open(Json::object()); }
  bool end_object() override { return close(); }
  bool start_array(std::size_t) override { return open(Json::array()); }
  bool end_array() override { return close(); }

  bool key(string_t& key) override {
    Level& level = levels_.back();
    level.duplicate = !level.keys.insert(key).second;
    level.key = std::move(key);
    if (level.duplicate && problems_.size() < kMaxDuplicates) {
      problems_.emplace_back(json_place(file_, json_pointer(pointer(levels_.size() - 1), level.key)), "appears twice",
                             "keep one of the two");
    }
    return true;
  }

  bool parse_error(std::size_t position, const std::string&, const Json::exception& error) override {
    report_here(position, plain_message(error.what()), "correct the JSON text here");
    return false;
  }

 private:
  struct Level {
    Json value;
    std::set<std::string> keys;
    std::string key;
    bool duplicate = false;
  };

  std::string pointer(std::size_t depth) const {
    std::string text;
    for (std::size_t i = 0; i < depth; ++i) {
      const Level& level = levels_[i];
      text = json_pointer(text, level.value.is_array() ? std::to_string(level.value.size()) : level.key);
    }
    return text;
  }

  bool open(Json value) {
    if (levels_.size() == kMaxDepth) {
      problems_.emplace_back(json_place(file_, pointer(2)), "is nested more than 64 levels deep",
                             "no scene needs that");
      return false;
    }
    levels_.push_back({.value = std::move(value), .keys = {}, .key = {}});
    return weigh(kStructureWeight);
  }

  bool weigh(std::size_t weight) {
    weight_ += weight;
    if (weight_ <= kMaxWeight) return true;
    problems_.emplace_back(json_place(file_, pointer(std::min<std::size_t>(levels_.size(), 2))),
                           "brings the file to more values than any scene or run has", "is it the intended file?");
    return false;
  }

  bool close() {
    Json value = std::move(levels_.back().value);
    levels_.pop_back();
    return add(std::move(value));
  }

  bool add(Json value) {
    if (!value.is_structured() && !weigh(1)) return false;
    if (levels_.empty()) {
      root_ = std::move(value);
    } else if (Level& level = levels_.back(); level.value.is_array()) {
      level.value.push_back(std::move(value));
    } else if (!level.duplicate) {
      // The set of keys has shown that this one is new, so the object is not searched.
      level.value.get_ref<Json::object_t&>().push_back({level.key, std::move(value)});
    }
    return true;
  }

  void report_here(std::size_t position, const std::string& problem, const std::string& remedy) {
    const std::string_view before = text_.substr(0, std::min(position, text_.size() + 1) - (position > 0));
    const auto line = 1 + std::ranges::count(before, '\n');
    const std::size_t column = before.size() - (before.rfind('\n') + 1) + 1;
    problems_.emplace_back(file_ + ":" + std::to_string(line) + ":" + std::to_string(column), problem, remedy);
  }

  std::string_view text_;
  const std::string& file_;
  std::vector<InputError>& problems_;
  std::vector<Level> levels_;
  std::size_t weight_ = 0;
  Json root_;
};

std::string enclosed(const Json& json, const std::string& items) {
  std::string text = json.is_object() ? "{" : "[";
  return text.append(items).append(json.is_object() ? "}" : "]");
}

std::string line_text(const Json& json) {
  if (!json.is_structured()) return json.dump();
  std::string text;
  for (const auto& [key, value] : json.items()) {
    if (!text.empty()) text += ", ";
    if (json.is_object()) text += Json(key).dump() + ": ";
    text += line_text(value);
  }
  return enclosed(json, text);
}

/// `used`: characters of the line before the value.
std::string block_text(const Json& json, std::size_t indentation, std::size_t used) {
  std::string line = line_text(json);
  if (!json.is_structured() || (used + line.size() <= kMaxLine && indentation > 0)) return line;
  const std::string margin(indentation + 2, ' ');
  std::string text;
  for (const auto& [key, value] : json.items()) {
    const std::string label = json.is_object() ? Json(key).dump() + ": " : "";
    text.append(text.empty() ? "\n" : ",\n").append(margin).append(label);
    text += block_text(value, indentation + 2, margin.size() + label.size() + 1);
  }
  text.append("\n").append(indentation, ' ');
  return enclosed(json, text);
}

}  // namespace

Json parse_json(std::string_view text, const std::string& file, std::vector<InputError>& problems) {
  DocumentBuilder builder(text, file, problems);
  return Json::sax_parse(text, &builder) ? builder.take_root() : Json();
}

std::string json_pointer(std::string_view pointer, std::string_view key) {
  std::string text = std::string(pointer) + "/";
  for (char c : key) {
    if (c == '~') {
      text += "~0";
    } else if (c == '/') {
      text += "~1";
    } else {
      text += c;
    }
  }
  return text;
}

std::string json_place(const std::string& file, const std::string& pointer) {
  return pointer.empty() ? file : file + "#" + pointer;
}

std::string pretty_text(const Json& json) try {
  return block_text(json, 0, 0) + "\n";
} catch (const Json::type_error&) {
  throw InputError("scene", "has a text that is not UTF-8", "replace its unreadable characters");
}

}  // namespace griffith
