#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "sim/scene/scene_fields.h"
#include "ui/widgets/field_widgets.h"
#include "ui/widgets/kind_fields.h"
#include "ui/widgets/number_field.h"

namespace griffith::ui {

/// Archive for describe() that draws a row for each field of a part of a scene and edits it. The panels thus have every
/// field of scene files, with unit, limits and meaning.
class FieldRows {
 public:
  /// `tag`: prefix of tags. Fields named in `hidden` get no row.
  FieldRows(Panel& panel, std::string tag, std::vector<std::string_view> hidden = {})
      : panel_(panel), tag_(std::move(tag)), units_{tag_, panel.state}, hidden_(std::move(hidden)) {}

  /// Draws the rows of all fields of `value` and edits them.
  template <class T>
  void show(T& value) {
    describe(units_, value);
    describe(*this, value);
    if (!edit_.changed) return;
    drop_idle_fields(value);
    if (!problem_.empty()) return;
    Rules rules;
    describe(rules, value);
    problem_ = rules.problem;
  }

  template <class T, class Values>
  void field(std::string_view name, T& member, const Values& values, std::string_view description) {
    if (std::ranges::find(hidden_, name) == hidden_.end()) draw(row(name, description), member, values);
  }

  template <class T, class Variant, class Values, class Projection = std::identity>
  void alternative(std::string_view name, Variant& variant, const Values& values, std::string_view description,
                   Projection projection = {}) {
    T* held = std::get_if<T>(&variant);
    if (!held) return;
    if constexpr (std::is_same_v<Values, Parts>) {
      draw_fields(tag_ + "/" + std::string(name), *held);
    } else {
      draw(row(name, description), std::invoke(projection, *held), values);
    }
  }

  void require(bool, std::string_view, const char*, const char*) {}  // checked at the end: see Rules

  /// Returns the edit of this frame. An edit that would break a rule is rejected, and the panel shows the rule.
  Edit finish() {
    if (edit_.changed && !problem_.empty()) panel_.state.field_note = {edited_tag_, problem_};
    if (!problem_.empty()) edit_.changed = false;
    return edit_;
  }
  /// Returns the label of the edited field.
  const std::string& edited() const { return edited_; }

 private:
  /// Common unit of all vectors with the same numbers, such as position and target of a camera.
  struct SharedUnit {
    Numbers numbers;
    double largest = 0;                    ///< largest of their components
    std::optional<SiPrefix> ongoing = {};  ///< prefix of the edit of one of them
  };

  /// Archive that finds these units.
  struct SharedUnits {
    std::string tag;
    const EditorState& state;
    std::vector<SharedUnit> found = {};

    template <int N, int Options>
    void field(std::string_view name, Eigen::Matrix<double, N, 1, Options>& vector, const Numbers& numbers,
               std::string_view) {
      SharedUnit& unit = of(numbers);
      unit.largest = std::max(unit.largest, vector.cwiseAbs().maxCoeff());
      if (!unit.ongoing) unit.ongoing = ongoing_prefix(state, tag + "/" + std::string(name) + "/");
    }
    template <class T, class Values>
    void field(std::string_view, T&, const Values&, std::string_view) {}
    template <class Fixed, class... Anything>
    void alternative(Anything&&...) {}
    void require(bool, std::string_view, const char*, const char*) {}

    SharedUnit& of(const Numbers& numbers) {
      for (SharedUnit& unit : found)
        if (unit.numbers.unit == numbers.unit && unit.numbers.minimum == numbers.minimum &&
            unit.numbers.maximum == numbers.maximum)
          return unit;
      return found.emplace_back(SharedUnit{numbers});
    }
    SiPrefix prefix(const Numbers& numbers) {
      const SharedUnit& unit = of(numbers);
      return unit.ongoing.value_or(si_prefix(unit.largest, unit_symbol(numbers)));
    }
  };

  /// Archive that finds the first rule broken by a value.
  struct Rules {
    std::string problem;
    template <class... Anything>
    void field(Anything&&...) {}
    template <class Fixed, class... Anything>
    void alternative(Anything&&...) {}
    void require(bool holds, std::string_view name, const char* what, const char* remedy) {
      if (!holds && problem.empty()) problem = label_of(name) + " " + what + ": " + remedy + ".";
    }
  };

  FieldRow row(std::string_view name, std::string_view description) const {
    return {tag_ + "/" + std::string(name), label_of(name), std::string(description)};
  }

  void note(const FieldRow& row, const Edit& edit) {
    if (edit.changed || edit.finished) edited_ = row.label, edited_tag_ = row.tag;
    edit_.changed |= edit.changed;
    edit_.finished |= edit.finished;
  }

  /// Draws the rows of a value with fields of its own, as a section.
  template <class T>
  void draw_fields(const std::string& tag, T& value) {
    FieldRows rows(panel_, tag, idle_fields(value));
    rows.show(value);
    if (problem_.empty()) problem_ = rows.problem_;
    note({rows.edited_tag_, rows.edited_, ""}, rows.edit_);
  }

  void draw(const FieldRow& row, double& value, const Numbers& numbers) {
    note(row, draw_field(panel_, row, numbers, value));
  }
  void draw(const FieldRow& row, int& value, const Numbers& numbers) {
    note(row, draw_field(panel_, row, numbers, value));
  }
  void draw(const FieldRow& row, std::vector<int>& values, const Numbers& numbers) {
    note(row, draw_field(panel_, row, numbers, values));
  }
  void draw(const FieldRow& row, std::vector<Vec3>& points, const Numbers& numbers) {
    if (!begin_part(panel_, row, std::to_string(points.size()))) return;
    double largest = 0;
    for (const Vec3& point : points) largest = std::max(largest, point.cwiseAbs().maxCoeff());
    const SiPrefix prefix = shared_prefix(panel_.state, row.tag + "/", largest, unit_symbol(numbers));
    for (std::size_t i = 0; i < points.size(); ++i)
      draw({row.tag + "/" + std::to_string(i), "Number " + std::to_string(i + 1), ""}, points[i], numbers, prefix);
    const bool removed = text_button(panel_, (row.tag + "/remove").c_str(), ("Remove last##" + row.tag).c_str());
    const bool added = text_button(panel_, (row.tag + "/add").c_str(), ("Add##" + row.tag).c_str());
    if (removed && !points.empty()) points.pop_back();
    if (added) points.push_back(points.empty() ? Vec3(Vec3::Zero()) : Vec3(points.back()));
    if (removed || added) note(row, {true, true});
    end_part();
  }
  template <int N, int Options>
  void draw(const FieldRow& row, Eigen::Matrix<double, N, 1, Options>& vector, const Numbers& numbers) {
    draw(row, vector, numbers, units_.prefix(numbers));
  }
  template <int N, int Options>
  void draw(const FieldRow& row, Eigen::Matrix<double, N, 1, Options>& vector, const Numbers& numbers,
            const SiPrefix& prefix) {
    Eigen::Matrix<double, N, 1, Options> edited = vector;
    Edit edit = draw_field(panel_, row, numbers, std::span<double>(edited.data(), N), prefix);
    const FieldRow first{row.tag + "/0", row.label, row.description};
    if (edit.changed && numbers.nonzero && edited.isZero(0)) {
      panel_.state.field_note = {first.tag, "The components cannot all be 0; the value was not changed."};
      edit.changed = false;
    }
    if (edit.changed) vector = edited;
    note(first, edit);
  }
  void draw(const FieldRow& row, bool& value, Flag flag) { note(row, draw_field(panel_, row, flag, value)); }
  void draw(const FieldRow& row, std::string& value, const Text& text) {
    note(row, draw_field(panel_, row, text, value));
  }
  void draw(const FieldRow& row, std::filesystem::path& value, const MeshPath&) {
    note(row, draw_field(panel_, row, panel_.history.scene().folder, value));
  }
  // These have panels of their own.
  void draw(const FieldRow&, Material&, MaterialChoice) {}
  void draw(const FieldRow&, ViewSettings&, Parts) {}

  template <class Enum>
  requires std::is_enum_v<Enum>
  void draw(const FieldRow& row, Enum& value, const OneOf& one_of) {
    int index = static_cast<int>(value);
    note(row, draw_choice(panel_, row, one_of, index));
    value = static_cast<Enum>(index);
  }
  template <class Enum>
  requires std::is_enum_v<Enum>
  void draw(const FieldRow& row, std::vector<Enum>& values, const OneOf& one_of) {
    std::vector<int> chosen;
    for (const Enum value : values) chosen.push_back(static_cast<int>(value));
    note(row, draw_choices(panel_, row, one_of, chosen));
    values.clear();
    for (const int index : chosen) values.push_back(static_cast<Enum>(index));
  }
  void draw(const FieldRow& row, std::vector<std::string>& values, const OneOf& one_of) {
    std::vector<int> chosen;
    for (const std::string& value : values)
      chosen.push_back(static_cast<int>(std::ranges::find(one_of.names, value) - one_of.names.begin()));
    note(row, draw_choices(panel_, row, one_of, chosen));
    values.clear();
    for (const int index : chosen) values.emplace_back(one_of.names[static_cast<std::size_t>(index)]);
  }

  void draw(const FieldRow& row, std::optional<double>& value, const Numbers& numbers) {
    bool present = value.has_value();
    const Edit toggled = draw_presence(panel_, row, present);
    note(row, toggled);
    if (toggled.changed) value = present ? std::optional(first_value(numbers)) : std::nullopt;
    if (value) draw(FieldRow{row.tag + "/value", "", row.description}, *value, numbers);
  }
  template <class T>
  void draw(const FieldRow& row, std::optional<T>& value, Parts) {
    bool present = value.has_value();
    const Edit toggled = draw_presence(panel_, row, present);
    note(row, toggled);
    if (toggled.changed) value = present ? std::optional<T>(T{}) : std::nullopt;
    if (value) draw(FieldRow{row.tag + "/parts", row.label, row.description}, *value, Parts{});
  }

  template <class... Alternatives>
  void draw(const FieldRow& row, std::variant<Alternatives...>& value, Parts) {
    if (!begin_part(panel_, row, "")) return;
    draw_kind(FieldRow{row.tag + "/kind_of", "Kind", row.description}, value);
    draw_fields(row.tag, value);
    end_part();
  }

  // The outliner lists these.
  template <class T>
  void draw(const FieldRow&, std::vector<T>&, Parts) {}

  template <class T>
  void draw(const FieldRow& row, T& value, Parts) {
    if (!begin_part(panel_, row, "")) return;
    draw_fields(row.tag, value);
    end_part();
  }

  /// Names of the alternatives of a variant that need no file.
  struct Kinds {
    std::vector<std::string_view> names;
    std::vector<std::function<void()>> hold;
    int held = -1;

    template <class T, class Variant, class Values, class Projection = std::identity>
    void alternative(std::string_view name, Variant& variant, const Values&, std::string_view, Projection = {}) {
      const bool is_held = std::holds_alternative<T>(variant);
      if constexpr (requires(T value) { value.path; })
        if (!is_held) return;
      if (is_held) held = static_cast<int>(names.size());
      names.push_back(name);
      hold.push_back([&variant] { variant = T{}; });
    }
    void require(bool, std::string_view, const char*, const char*) {}
  };

  template <class Variant>
  void draw_kind(const FieldRow& row, Variant& variant) {
    Kinds kinds;
    describe(kinds, variant);
    int chosen = kinds.held;
    const Edit edit = draw_choice(panel_, row, OneOf{kinds.names}, chosen);
    note(row, edit);
    if (edit.changed) kinds.hold[static_cast<std::size_t>(chosen)]();
  }

  /// Initial value of a number that was absent: 1, or the geometric mean of its limits.
  static double first_value(const Numbers& numbers) {
    if (numbers.minimum <= 0) return std::clamp(1.0, numbers.minimum, numbers.maximum);
    return std::sqrt(numbers.minimum * numbers.maximum);
  }

  Panel& panel_;
  std::string tag_;
  SharedUnits units_;
  std::vector<std::string_view> hidden_;
  std::string edited_, edited_tag_, problem_;
  Edit edit_;
};

}  // namespace griffith::ui
