#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "problems.h"
#include "tests/scene/scene_schema.h"

// Every field, from the schema, which is made from the table that the reader follows.

namespace griffith {
namespace {

using Json = nlohmann::ordered_json;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;

/// A scene with `value` at `pointer` and nothing else.
std::vector<InputError> problems_with(const std::string& pointer, const Json& value) {
  Json document = {{"version", 1}};
  document[Json::json_pointer(pointer)] = value;
  return problems_of(document.dump());
}

/// Calls visit(pointer, schema) for every value that a scene may have, each schema without alternatives inside.
template <class Visit>
void for_every_value(const std::string& pointer, const Json& schema, const Visit& visit) {
  if (schema.contains("anyOf")) {
    for (const Json& option : schema["anyOf"]) for_every_value(pointer, option, visit);
    return;
  }
  visit(pointer, schema);
  if (schema.contains("properties")) {
    for (const auto& [name, property] : schema["properties"].items())
      for_every_value(pointer + "/" + name, property, visit);
  }
  if (schema.value("additionalProperties", Json()).is_object()) {
    for_every_value(pointer + "/custom", schema["additionalProperties"], visit);
  }
  if (schema.contains("items")) {
    // A vector's components are judged together: the others have to be right.
    if (!schema.contains("minItems")) for_every_value(pointer + "/0", schema["items"], visit);
  }
}

template <class Visit>
void for_every_field(const Visit& visit) {
  const Json schema = Json::parse(scene_schema());
  for (const auto& [name, property] : schema["properties"].items()) {
    if (name != "version" && name != "$schema") for_every_value("/" + name, property, visit);
  }
}

TEST(SceneFields, AValueOfTheWrongTypeIsReportedAtItsPlace) {
  int checked = 0;
  for_every_field([&](const std::string& pointer, const Json& schema) {
    if (schema.value("type", "") == "null") return;
    // No field takes both numbers and booleans, or an array that holds an object and a text.
    std::vector<Json> wrong = {Json{{1, {}}, "text"}};
    if (schema.value("type", "") != "boolean") wrong.push_back(true);
    if (schema.value("type", "") == "boolean") wrong.push_back(0);
    for (const Json& value : wrong) {
      const auto where = places(problems_with(pointer, value));
      EXPECT_TRUE(std::ranges::any_of(
          where,
          [&](const std::string& place) { return place == "doc#" + pointer || place == "doc#" + pointer + "/0"; }))
          << pointer << " = " << value << "\n"
          << testing::PrintToString(where);
      ++checked;
    }
  });
  EXPECT_GT(checked, 120);
}

TEST(SceneFields, ANumberMayBeAtTheEndsOfItsRangeAndNotBeyond) {
  int checked = 0;
  for_every_field([&](const std::string& pointer, const Json& schema) {
    const bool vector = schema.contains("items") && schema.contains("minItems");
    const Json& range = vector ? schema["items"] : schema;
    if (!range.contains("minimum")) return;
    const double low = range["minimum"], high = range["maximum"];
    const bool whole = range["type"] == "integer";
    const auto try_number = [&](double number) {
      Json value = number;
      if (vector) value = Json(schema["minItems"].get<std::size_t>(), low);
      if (vector) value.back() = number;
      std::vector<std::string> where;
      for (const InputError& problem : problems_with(pointer, value)) {
        // A value of the range may still be at odds with another field.
        if (problem.remedy().starts_with("expected")) where.push_back(problem.where());
      }
      return where;
    };
    const std::string place =
        "doc#" + pointer + (vector ? "/" + std::to_string(schema["minItems"].get<int>() - 1) : "");
    EXPECT_THAT(try_number(high), Not(Contains(place)));
    EXPECT_THAT(try_number(low), Not(Contains(place)));
    EXPECT_THAT(try_number(whole ? high + 1 : std::nextafter(high, INFINITY)), Contains(place));
    EXPECT_THAT(try_number(whole ? low - 1 : std::nextafter(low, -INFINITY)), Contains(place));
    if (whole) {
      EXPECT_THAT(try_number(low + 0.5), Contains(place));
    }
    ++checked;
  });
  EXPECT_GT(checked, 50);
}

TEST(SceneFields, AVectorOfTheWrongLengthIsReported) {
  int checked = 0;
  for_every_field([&](const std::string& pointer, const Json& schema) {
    if (!schema.contains("minItems")) return;
    for (const int length : {-1, 1}) {
      const Json values(schema["minItems"].get<int>() + length, schema["items"]["maximum"]);
      EXPECT_THAT(places(problems_with(pointer, values)), Contains("doc#" + pointer));
    }
    if (schema.contains("not")) {
      EXPECT_THAT(places(problems_with(pointer, {0, 0, 0})), Contains("doc#" + pointer));
    }
    ++checked;
  });
  EXPECT_GT(checked, 15);
}

TEST(SceneFields, AMisspelledFieldIsReportedWithItsRightName) {
  int checked = 0;
  for_every_field([&](const std::string& pointer, const Json& schema) {
    if (!schema.contains("properties")) return;
    for (const auto& [name, property] : schema["properties"].items()) {
      const std::string place = pointer + "/" + name + "x";
      const auto problems = problems_with(place, property.value("default", Json(1)));
      const auto found = std::ranges::find(problems, "doc#" + place, &InputError::where);
      ASSERT_NE(found, problems.end()) << place;
      EXPECT_EQ(found->remedy(), "did you mean \"" + name + "\"?");
      ++checked;
    }
  });
  EXPECT_GT(checked, 70);
}

TEST(SceneFields, AnUnknownNameIsReportedWithTheKnownOnes) {
  int checked = 0;
  for_every_field([&](const std::string& pointer, const Json& schema) {
    if (!schema.contains("enum")) return;
    const auto problems = problems_with(pointer, "completely different");
    const auto found = std::ranges::find(problems, "doc#" + pointer, &InputError::where);
    ASSERT_NE(found, problems.end()) << pointer;
    for (const std::string name : schema["enum"]) {
      EXPECT_THAT(found->remedy(), HasSubstr(name));
      EXPECT_THAT(places(problems_with(pointer, name)), Not(Contains("doc#" + pointer)));
    }
    ++checked;
  });
  EXPECT_GE(checked, 6);
}

}  // namespace
}  // namespace griffith
