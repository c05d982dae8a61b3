#include "app/render/read_render_jobs.h"

#include <gtest/gtest.h>

#include "program.h"
#include "sim/core/error.h"

namespace griffith::app {
namespace {

std::vector<RenderJob> jobs_from(const std::string& text) { return read_render_jobs(test_file("jobs.json", text)); }

TEST(RenderJobs, DefaultsHoldUntilAJobSaysOtherwise) {
  const auto jobs = jobs_from(R"({"defaults": {"size": [320, 180], "views": ["body"]}, "pictures": [
      {"name": "a", "scene": "x.json", "frames": "0:4:2"},
      {"name": "b", "scene": "sub/y.json", "frames": [3, 1], "size": [64, 48], "ui": true, "node": 4,
       "cameras": ["front", ""], "samples": 2, "legend": false}]})");
  ASSERT_EQ(jobs.size(), 2u);
  EXPECT_EQ(jobs[0].frames, std::vector<int>({0, 2, 4}));
  EXPECT_EQ(jobs[0].width, 320);
  EXPECT_EQ(jobs[0].samples, 1);
  EXPECT_EQ(jobs[0].scene, test_folder() / "x.json");
  EXPECT_EQ(jobs[1].frames, std::vector<int>({1, 3}));
  EXPECT_EQ(jobs[1].height, 48);
  EXPECT_EQ(jobs[1].views, std::vector<std::string>({"body"}));
  EXPECT_EQ(jobs[1].cameras.size(), 2u);
  EXPECT_EQ(jobs[1].node, 4);
  EXPECT_TRUE(jobs[1].interface);
  EXPECT_FALSE(jobs[1].legend);
}

TEST(RenderJobs, WhatIsWrittenReadsBackTheSame) {
  RenderJob job;
  job.name = "wall";
  job.scene = test_folder() / "scenes/wall.json";
  job.frames = {0, 7, 30};
  job.views = {"body", "utilization+slice"};
  job.samples = 1;
  job.quality = PictureQuality::high;
  job.node = 3;
  job.interface = true;
  job.open_sections = true;
  job.commands = {"help.show"};
  const auto jobs = jobs_from(render_jobs_json({job}, test_folder()));
  ASSERT_EQ(jobs.size(), 1u);
  EXPECT_EQ(jobs[0].name, job.name);
  EXPECT_EQ(jobs[0].scene, job.scene);
  EXPECT_EQ(jobs[0].frames, job.frames);
  EXPECT_EQ(jobs[0].views, job.views);
  EXPECT_EQ(jobs[0].quality, job.quality);
  EXPECT_EQ(jobs[0].node, job.node);
  EXPECT_TRUE(jobs[0].interface);
  EXPECT_TRUE(jobs[0].open_sections);
  EXPECT_EQ(jobs[0].commands, job.commands);
}

TEST(RenderJobs, ProblemsNameTheirPlace) {
  const std::pair<const char*, const char*> cases[] = {
      {"{", "jobs.json:1"},
      {"[]", "jobs.json"},
      {R"({"pictures": []})", "jobs.json"},
      {R"({"pictures": [{"scene": "x"}]})", "#/pictures/0"},
      {R"({"pictures": [{"name": "a"}]})", "#/pictures/0"},
      {R"({"pictures": [{"name": "a/b", "scene": "x"}]})", "#/pictures/0"},
      {R"({"pictures": [{"name": "a\u001b[2J", "scene": "x"}]})", "#/pictures/0"},
      {R"({"pictures": [{"name": "a'b", "scene": "x"}]})", "#/pictures/0"},
      {R"({"pictures": [{"name": "a", "scene": "x", "frame": 3}]})", "#/pictures/0/frame"},
      {R"({"pictures": [{"name": "a", "scene": "x", "frames": [1.5]}]})", "#/pictures/0/frames"},
      {R"({"pictures": [{"name": "a", "scene": "x", "frames": true}]})", "#/pictures/0/frames"},
      {R"({"pictures": [{"name": "a", "scene": "x", "size": [1, 100]}]})", "#/pictures/0/size/0"},
      {R"({"pictures": [{"name": "a", "scene": "x", "views": []}]})", "#/pictures/0/views"},
      {R"({"pictures": [{"name": "a", "scene": "x"}, {"name": "a", "scene": "y"}]})", "#/pictures/1"},
      {R"({"defaults": {"samples": 99}, "pictures": [{"name": "a", "scene": "x"}]})", "#/defaults/samples"},
      {R"({"pictures": [{"name": "a", "scene": "x", "quality": "best"}]})", "#/pictures/0/quality"},
      {R"({"pictures": [{"name": "a", "scene": "x", "commands": ["fly"]}]})", "#/pictures/0/commands/0"},
      {R"({"pictures": [{"name": "a", "scene": "x", "ui": true, "commands": ["file.save"]}]})",
       "#/pictures/0/commands/0"},
      {R"({"pictures": [{"name": "a", "scene": "x", "ui": true, "transparent": true}]})", "#/pictures/0"},
      {R"({"pictures": [{"name": "a", "scene": "x", "open_sections": true}]})", "#/pictures/0"},
      {R"({"pictures": [{"name": "a", "scene": "x", "views": ["body", "body"]}]})", "#/pictures/0"},
      {R"({"pictures": [{"name": "a", "scene": "x", "views": ["body", "tet"]}, {"name": "a_body", "scene": "x"}]})",
       "#/pictures/1"},
      {R"({"picture": 1, "pictures": [{"name": "a", "scene": "x"}]})", "#/picture"}};
  for (const auto& [text, place] : cases) {
    try {
      jobs_from(text);
      ADD_FAILURE() << text;
    } catch (const InputError& error) {
      EXPECT_NE(error.where().find(place), std::string::npos) << text << "\n" << error.what();
    }
  }
}

}  // namespace
}  // namespace griffith::app
