#pragma once

#include <cmath>
#include <functional>
#include <random>
#include <string>

#include "sim/scene/scene_fields.h"

namespace griffith {

/// The archive that fills a value with random ones that every field allows, its ends among them. It follows the table
/// of fields, so a new field is covered without a change here.
class Randomizer {
 public:
  /// Mesh paths are taken from `mesh_paths`.
  Randomizer(unsigned seed, std::vector<std::string> mesh_paths) : random_(seed), mesh_paths_(std::move(mesh_paths)) {}

  Scene scene() {
    Scene scene;
    fill(scene, Parts{});
    return scene;
  }

  template <class T, class Values>
  void field(std::string_view, T& member, const Values& values, std::string_view) {
    if (std::is_same_v<Values, MeshPath> || chance(0.8)) fill(member, values);
  }

  template <class T, class Variant, class Values, class Projection = std::identity>
  void alternative(std::string_view, Variant& variant, const Values& values, std::string_view,
                   Projection projection = {}) {
    // The k-th alternative replaces the one before with probability 1/k: all are equally likely.
    if (chance(1.0 / ++alternatives_)) {
      T value{};
      fill(std::invoke(projection, value), values);
      variant = std::move(value);
    }
  }

  void require(bool holds, std::string_view, const char*, const char*) { all_hold_ = all_hold_ && holds; }

 private:
  bool chance(double probability) { return std::bernoulli_distribution(probability)(random_); }

  template <class List>
  const auto& pick(const List& list) {
    return list[std::uniform_int_distribution<std::size_t>(0, list.size() - 1)(random_)];
  }

  double number(const Numbers& numbers) {
    if (chance(0.1)) return chance(0.5) ? numbers.minimum : numbers.maximum;
    // Over all orders of magnitude where the range spans several.
    if (numbers.minimum > 0 && numbers.maximum / numbers.minimum > 100) {
      std::uniform_real_distribution exponent(std::log(numbers.minimum), std::log(numbers.maximum));
      return std::clamp(std::exp(exponent(random_)), numbers.minimum, numbers.maximum);
    }
    const double scale = chance(0.5) ? 1 : std::pow(10.0, -12 * std::uniform_real_distribution()(random_));
    const double value = std::uniform_real_distribution(numbers.minimum, numbers.maximum)(random_) * scale;
    return std::clamp(value, numbers.minimum, numbers.maximum);
  }

  void fill(bool& value, Flag) { value = chance(0.5); }
  void fill(double& value, const Numbers& numbers) { value = number(numbers); }
  void fill(int& value, const Numbers& numbers) { value = static_cast<int>(number(numbers)); }
  template <int N, int Options>
  void fill(Eigen::Matrix<double, N, 1, Options>& vector, const Numbers& numbers) {
    do {
      for (double& component : vector) fill(component, numbers);
      if (numbers.ascending) std::ranges::sort(vector);
    } while ((numbers.nonzero && vector.isZero(0)) || (numbers.ascending && !(vector[0] < vector[N - 1])));
  }
  void fill(std::vector<int>& values, const Numbers& numbers) {
    values.resize(std::uniform_int_distribution(0, 5)(random_));
    for (int& value : values) fill(value, numbers);
  }
  void fill(std::vector<Vec3>& values, const Numbers& numbers) {
    values.resize(std::uniform_int_distribution(4, 9)(random_));
    for (Vec3& value : values) fill(value, numbers);
  }
  void fill(std::string& value, const Text& text) {
    static const std::vector<std::string> kPieces = {"wall", " ",  "\"", "\\",   "/",    "~",
                                                     "ä",    "力", "\n", "\x01", "brick"};
    value = text.minimum_length > 0 ? std::to_string(++names_) : "";
    for (int i = std::uniform_int_distribution(0, 4)(random_); i > 0; --i) value += pick(kPieces);
  }
  void fill(std::string& value, const OneOf& one_of) { value = pick(one_of.names); }
  void fill(std::vector<std::string>& values, const OneOf& one_of) {
    values.resize(std::uniform_int_distribution(0, 3)(random_));
    for (std::string& value : values) fill(value, one_of);
  }
  template <class Enum>
  requires std::is_enum_v<Enum>
  void fill(Enum& value, const OneOf& one_of) {
    value = static_cast<Enum>(std::uniform_int_distribution<std::size_t>(0, one_of.names.size() - 1)(random_));
  }
  template <class Enum>
  requires std::is_enum_v<Enum>
  void fill(std::vector<Enum>& values, const OneOf& one_of) {
    values.resize(std::uniform_int_distribution(0, 3)(random_));
    for (Enum& value : values) fill(value, one_of);
  }
  void fill(std::filesystem::path& value, MeshPath) { value = pick(mesh_paths_); }

  void fill(Material& material, MaterialChoice) {
    const int preset = std::uniform_int_distribution(0, static_cast<int>(material_presets().size()) - 1)(random_);
    material = material_presets()[preset].material;
    if (chance(0.3)) return;
    // Names that presets and other bodies' materials have as well.
    const std::string name = chance(0.5) ? std::string(material_presets()[preset].key) : "mine";
    fill(material, Parts{});
    if (chance(0.5)) material.name = name;
  }

  template <class T, class Values>
  void fill(std::optional<T>& value, const Values& values) {
    if (chance(0.3)) return value.reset();
    fill(value.emplace(), values);
  }
  template <class T>
  void fill(std::vector<T>& items, Parts parts) {
    items.clear();
    for (int i = std::uniform_int_distribution(0, 4)(random_); i > 0; --i) {
      T& item = items.emplace_back();
      fill(item, parts);
      // The table asks bodies and cameras for different names.
      if constexpr (requires { item.name; }) item.name += std::to_string(items.size() - 1);
    }
  }
  template <class T>
  requires(!kIsOptional<T>) void fill(T& value, Parts) {
    const bool outer_hold = all_hold_;
    const int outer_alternatives = alternatives_;
    do {
      all_hold_ = true;
      alternatives_ = 0;
      describe(*this, value = T{});
    } while (!all_hold_);
    all_hold_ = outer_hold;
    alternatives_ = outer_alternatives;
  }

  std::mt19937 random_;
  std::vector<std::string> mesh_paths_;
  int names_ = 0;
  int alternatives_ = 0;
  bool all_hold_ = true;
};

}  // namespace griffith
