#include "app/render/read_render_jobs.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <set>

#include "app/editor/editor_commands.h"
#include "app/render/frame_list.h"
#include "sim/core/file_content.h"
#include "sim/scene/read_value.h"
#include "sim/scene/view_names.h"
#include "ui/model/commands.h"

namespace griffith::app {
namespace {

constexpr std::int64_t kMaxFileSize = 16 << 20;
constexpr std::array<std::string_view, 16> kFields = {
    "environment", "quality", "name", "scene",         "frames",   "views",  "cameras",     "size",
    "samples",     "node",    "ui",   "open_sections", "commands", "legend", "transparent", "turntable"};

void read_names(const Place& place, std::vector<std::string>& names) {
  if (!place.json.is_array() || place.json.empty()) return place.reject("a list of names, [\"...\"]");
  names.assign(place.json.size(), "");
  for (std::size_t i = 0; i < names.size(); ++i)
    read(place.child(std::to_string(i), place.json[i]), names[i], Text{.minimum_length = 0});
}

void read_commands(const Place& place, std::vector<std::string>& commands) {
  std::vector<std::string_view> known;
  for (const ui::CommandInfo& command : command_registry())
    if (command.for_pictures) known.push_back(command.name);
  read_names(place, commands);
  for (std::size_t i = 0; i < commands.size(); ++i)
    if (std::ranges::find(known, commands[i]) == known.end())
      place.child(std::to_string(i), place.json[i])
          .report("is not a command for pictures: \"" + commands[i] + "\"", suggestion(commands[i], known));
}

void read_frames(const Place& place, std::vector<int>& frames) {
  const std::string where = json_place(place.document.file, place.pointer);
  std::string text;
  if (place.json.is_string()) {
    text = place.json.get<std::string>();
  } else if (place.json.is_number()) {
    text = place.json.dump();
  } else if (place.json.is_array()) {
    for (const Json& frame : place.json) text += (text.empty() ? "" : ",") + frame.dump();
  } else {
    return place.reject("a number, a list of numbers or text such as \"0:240:10\"");
  }
  try {
    frames = frames_from_text(text, where);
  } catch (const InputError& error) {
    place.document.problems.push_back(error);
  }
}

void read_size(const Place& place, RenderJob& job) {
  constexpr double kMin = kMinPictureSide, kMax = kMaxPictureSide;
  if (!place.json.is_array() || place.json.size() != 2) return place.reject("[width, height] in pixels");
  read(place.child("0", place.json[0]), job.width, between(kMin, kMax));
  read(place.child("1", place.json[1]), job.height, between(kMin, kMax));
  if (!is_possible_size(job.width, job.height)) place.report("has more than 400 million pixels", "use fewer");
}

void read_quality(const Place& place, RenderJob& job) {
  const std::vector<std::string> names = quality_names();
  std::string name = names.front();
  read(place, name, OneOf{{names.begin(), names.end()}});
  set_quality(job, name);
}

void read_environment(const Place& place, RenderJob& job) {
  std::string name = "studio";
  read(place, name, OneOf{{"studio", "sky"}});
  job.sky = name == "sky";
}

void read_field(const Place& place, std::string_view name, RenderJob& job) {
  constexpr double kMaxNode = 1 << 30;
  if (name == "name") return read(place, job.name, Text{.minimum_length = 1});
  if (name == "frames") return read_frames(place, job.frames);
  if (name == "views") return read_names(place, job.views);
  if (name == "cameras") return read_names(place, job.cameras);
  if (name == "size") return read_size(place, job);
  if (name == "samples") return read(place, job.samples.emplace(), between(1, 16));
  if (name == "environment") return read_environment(place, job);
  if (name == "quality") return read_quality(place, job);
  if (name == "node") return read(place, job.node.emplace(), between(0, kMaxNode));
  if (name == "ui") return read(place, job.interface, Flag{});
  if (name == "open_sections") return read(place, job.open_sections, Flag{});
  if (name == "commands") return read_commands(place, job.commands);
  if (name == "legend") return read(place, job.legend, Flag{});
  if (name == "turntable") return read(place, job.turntable, between(2, kMaxTurntable));
  if (name == "transparent") return read(place, job.transparent, Flag{});
  std::string scene;
  read(place, scene, Text{.minimum_length = 1});
  job.scene = place.document.folder / scene;
}

void read_job(const Place& place, RenderJob& job) {
  if (!place.json.is_object()) return place.reject("an object { ... }");
  for (const auto& [name, value] : place.json.items()) {
    const Place field = place.child(name, value);
    if (std::ranges::find(kFields, name) == kFields.end()) {
      field.report("is not a known field", suggestion(name, kFields));
    } else {
      read_field(field, name, job);
    }
  }
}

/// True for characters of file names that are special in shells, pages or terminals.
bool is_awkward(unsigned char c) { return c < ' ' || c == 0x7F || c == '"' || c == '\'' || c == '`' || c == '\\'; }

/// Throws InputError for what a well-formed job may still lack.
void check_job(const Place& place, const RenderJob& job, std::set<std::string>& names) {
  if (job.scene.empty()) place.report("lacks \"scene\"", "add it: the scene file, relative to this file's folder");
  if (job.name.empty()) place.report("lacks \"name\"", "add it: it names the pictures");
  if (job.name.find('/') != std::string::npos || job.name.starts_with("."))
    place.report("has the name \"" + job.name + "\", which file names cannot contain",
                 "leave out slashes and a leading dot");
  if (std::ranges::any_of(job.name, is_awkward))
    place.report("has the name \"" + job.name + "\", which shells and pages cannot show",
                 "leave out quotes, backslashes and control characters");
  if (job.name.ends_with(".ids"))
    place.report("has the name \"" + job.name + "\", which is reserved for the ids of pictures", "leave out .ids");
  if (!job.name.empty() && !names.insert(job.name).second)
    place.report("has the name \"" + job.name + "\" of an earlier job", "give every job a unique name");
  if (job.interface && job.poster)
    place.report("has the quality \"poster\" with \"ui\"", "panels are drawn sharp; remove one of them");
  if (job.interface && job.transparent)
    place.report("has \"transparent\" with \"ui\"", "panels have no background; remove one of them");
  if (job.interface && job.turntable > 0)
    place.report("has \"turntable\" with \"ui\"", "panels show the first picture alone; remove one of them");
  if (!job.interface && (job.open_sections || !job.commands.empty()))
    place.report("has \"open_sections\" or \"commands\" without \"ui\"", "add \"ui\": true");
}

/// Throws InputError if a picture would replace another one.
void check_pictures(const Place& place, const RenderJob& job, std::set<std::string>& pictures) {
  constexpr std::size_t kMaxPictures = 100'000;
  if (picture_count(job) + pictures.size() > kMaxPictures)
    return place.report("makes more than 100,000 pictures", "use fewer frames, cameras or views");
  for (const std::string& name : picture_names(job))
    if (!pictures.insert(name).second)
      return place.report("has a picture \"" + name + "\" that already exists", "rename the job, view or camera");
}

std::vector<RenderJob> jobs_of(const Place& root) {
  RenderJob defaults;
  defaults.samples = 1;
  std::vector<RenderJob> jobs;
  if (!root.json.is_object() || !root.json.contains("pictures") || !root.json["pictures"].is_array()) {
    root.report("has no list \"pictures\"", "write {\"pictures\": [{\"name\": \"...\", \"scene\": \"...\"}]}");
    return jobs;
  }
  for (const auto& [name, value] : root.json.items()) {
    if (name == "defaults") read_job(root.child(name, value), defaults);
    if (name != "defaults" && name != "pictures")
      root.child(name, value).report("is not a known field", "the fields are \"defaults\" and \"pictures\"");
  }
  const Place list = root.child("pictures", root.json["pictures"]);
  std::set<std::string> names, pictures;
  for (std::size_t i = 0; i < list.json.size(); ++i) {
    const Place place = list.child(std::to_string(i), list.json[i]);
    read_job(place, jobs.emplace_back(defaults));
    check_job(place, jobs.back(), names);
    check_pictures(place, jobs.back(), pictures);
  }
  return jobs;
}

}  // namespace

std::vector<RenderJob> read_render_jobs(const std::filesystem::path& file) {
  Document document;
  document.file = file.string();
  document.folder = file.parent_path();
  const Json json = parse_json(read_expected_file(file, kMaxFileSize), document.file, document.problems);
  std::vector<RenderJob> jobs;
  if (document.problems.empty()) jobs = jobs_of({document, json, ""});
  if (!document.problems.empty()) throw document.problems.front();
  if (jobs.empty()) throw InputError(file.string(), "contains no pictures", "add a job to \"pictures\"");
  return jobs;
}

std::string render_jobs_json(const std::vector<RenderJob>& jobs, const std::filesystem::path& folder) {
  Json pictures = Json::array();
  for (const RenderJob& job : jobs) {
    Json json = {{"name", job.name}, {"scene", job.scene.lexically_proximate(folder).generic_string()}};
    json["frames"] = job.frames;
    if (job.views != RenderJob{}.views) json["views"] = job.views;
    if (job.cameras != RenderJob{}.cameras) json["cameras"] = job.cameras;
    json["size"] = {job.width, job.height};
    if (job.samples && job.samples != 1) json["samples"] = *job.samples;
    if (job.quality)
      json["quality"] = job.poster ? "poster" : picture_quality_names()[static_cast<std::size_t>(*job.quality)];
    if (job.sky) json["environment"] = "sky";
    if (job.node) json["node"] = *job.node;
    if (job.interface) json["ui"] = true;
    if (job.open_sections) json["open_sections"] = true;
    if (!job.commands.empty()) json["commands"] = job.commands;
    if (!job.legend) json["legend"] = false;
    if (job.turntable > 0) json["turntable"] = job.turntable;
    if (job.transparent) json["transparent"] = true;
    pictures.push_back(std::move(json));
  }
  return pretty_text({{"pictures", std::move(pictures)}}) + "\n";
}

}  // namespace griffith::app
