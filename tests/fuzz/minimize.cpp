#include "tests/fuzz/minimize.h"

#include <algorithm>
#include <chrono>

#include "tests/fuzz/vocabulary.h"

namespace griffith::fuzz {
namespace {

using Clock = std::chrono::steady_clock;

class Minimizer {
 public:
  Minimizer(Sandbox& sandbox, const Target& target, Input input, const Failure& failure)
      : sandbox_(sandbox), target_(target), best_(std::move(input)), signature_(failure.signature()) {}

  Input run() {
    for (const auto& [name, content] : Input(best_).files) {
      drop_values(name);
      drop_parts(name, '\n');
      drop_parts(name, ' ');
      drop_parts(name, 0);
    }
    return std::move(best_);
  }

 private:
  bool in_time() const { return Clock::now() < deadline_; }

  /// Keeps a content of a file that still fails.
  bool accept(const std::string& name, const std::string& content) {
    if (!in_time() || content.size() >= best_.files[name].size()) return false;
    Input candidate = best_;
    candidate.files[name] = content;
    const auto failure = sandbox_.run_one(target_, candidate);
    if (!failure || failure->signature() != signature_) return false;
    best_ = std::move(candidate);
    return true;
  }

  /// Takes values out of a JSON text, outer ones first.
  void drop_values(const std::string& name) {
    const Json first = Json::parse(best_.files[name], nullptr, false);
    if (!first.is_structured()) return;
    accept(name, first.dump());
    std::vector<Json::json_pointer> places = {Json::json_pointer()};
    for (std::size_t i = 0; i < places.size() && in_time(); ++i) {
      const Json::json_pointer place = places[i];
      for (std::size_t k = best_document(name).at(place).size(); k-- > 0;) {
        Json smaller = best_document(name);
        erase_at(smaller[place], k);
        accept(name, smaller.dump());
      }
      const Json rest = best_document(name);
      for (const auto& [key, value] : rest.at(place).items())
        if (value.is_structured()) places.push_back(rest.at(place).is_array() ? place / std::stoul(key) : place / key);
    }
  }
  Json best_document(const std::string& name) { return Json::parse(best_.files[name]); }

  /// Takes out runs of parts that end with `separator` (0: bytes), half of all at first.
  void drop_parts(const std::string& name, char separator) {
    for (std::size_t size = parts_of(name, separator).size() / 2; size > 0 && in_time(); size /= 2)
      for (std::size_t first = 0; in_time();) {
        std::vector<std::string> parts = parts_of(name, separator);
        if (first + size > parts.size()) break;
        const auto begin = parts.begin() + static_cast<std::ptrdiff_t>(first);
        parts.erase(begin, begin + static_cast<std::ptrdiff_t>(size));
        std::string joined;
        for (const std::string& part : parts) joined += part;
        if (!accept(name, joined)) first += size;
      }
  }

  std::vector<std::string> parts_of(const std::string& name, char separator) {
    const std::string& text = best_.files[name];
    std::vector<std::string> parts;
    for (std::size_t begin = 0; begin < text.size();) {
      const std::size_t end = separator == 0 ? begin : std::min(text.find(separator, begin), text.size() - 1);
      parts.push_back(text.substr(begin, end + 1 - begin));
      begin = end + 1;
    }
    return parts;
  }

  static constexpr std::chrono::seconds kMaxTime{30};
  Sandbox& sandbox_;
  const Target& target_;
  Input best_;
  std::string signature_;
  Clock::time_point deadline_ = Clock::now() + kMaxTime;
};

}  // namespace

Input minimized(Sandbox& sandbox, const Target& target, Input input, const Failure& failure) {
  return Minimizer(sandbox, target, std::move(input), failure).run();
}

}  // namespace griffith::fuzz
