#include "app/export/html_player.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>
#include <regex>

#include "baked_run.h"
#include "program.h"
#include "sim/core/read_file.h"

namespace griffith::app {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using Json = nlohmann::json;

BakedMesh box(const Vec3& size) {
  BakedMesh mesh;
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-1.0, 1.0}) {
      const int first = static_cast<int>(mesh.points.size());
      const Vec3 u = Vec3::Unit((axis + 1) % 3), v = Vec3::Unit((axis + 2) % 3), n = side * Vec3::Unit(axis);
      for (const auto& [a, b] : {std::pair(-1, -1), std::pair(1, -1), std::pair(1, 1), std::pair(-1, 1)}) {
        mesh.points.push_back((n + a * side * u + b * v).cwiseProduct(size) / 2);
        mesh.normals.push_back(n);
        mesh.uvs.push_back(Vec2(a, b));
      }
      auto& triangles = mesh.triangles[static_cast<int>(axis == 0 ? Look::inside : Look::outside)];
      triangles.push_back({first, first + 1, first + 2});
      triangles.push_back({first, first + 2, first + 3});
    }
  return mesh;
}

/// A row of blocks that fly apart, each turning, and a shot that comes in frame 2.
Bake flying_blocks() {
  Bake bake;
  bake.scene_name = "Blocks </script> & \"more\"";
  bake.body_names = {"row"};
  bake.frames_per_second = 60;
  for (int frame = 0; frame < 6; ++frame) bake.times.push_back(frame / 60.0);
  bake.materials = {{"outside", Vec3(0.8, 0.2, 0.1), 1, 0.8}, {"inside", Vec3(0.9, 0.8, 0.7), 0.4, 0.1}};
  for (int i = 0; i < 3; ++i) {
    BakedObject& block = bake.objects.emplace_back();
    block.name = "row_" + std::to_string(i);
    block.scene_body = 0;
    block.mass = 1.5 + i;
    block.break_time = (i + 1) / 60.0;
    block.materials[static_cast<int>(Look::inside)] = 1;
    block.mesh = box(Vec3(1, 1, 1));
    for (int frame = 0; frame < 6; ++frame)
      block.poses.push_back(
          {Vec3((i - 1) * (1 + 0.1 * frame), 0.5, 0), Quat(Eigen::AngleAxisd(0.1 * frame * (i - 1), Vec3::UnitY()))});
  }
  BakedObject& shot = bake.objects.emplace_back();
  shot.name = "shot";
  shot.first_frame = 2;
  shot.mesh = box(Vec3::Constant(0.2));
  for (int frame = 2; frame < 6; ++frame) shot.poses.push_back({Vec3(0, 2, 5.0 - frame), Quat::Identity()});
  bake.bonds = {{0, 1, 1, Vec3(-0.5, 0.5, 0), Vec3::UnitX(), 3e6, 1 / 60.0},
                {1, 2, 1, Vec3(0.5, 0.5, 0), Vec3::UnitX(), 2e6, 2 / 60.0}};
  return bake;
}

/// Returns the content of the data element of that id.
std::string data_of(const std::string& page, const std::string& id) {
  const std::string start = "id=\"" + id + "\">";
  const std::size_t at = page.find(start) + start.size();
  return page.substr(at, page.find("</script>", at) - at);
}

std::string decoded(const std::string& text) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  unsigned bits = 0, count = 0;
  for (const char c : text) {
    if (c == '=') break;
    bits = bits << 6 | static_cast<unsigned>(digits.find(c));
    if ((count += 6) >= 8) bytes += static_cast<char>(bits >> (count -= 8) & 255);
  }
  return bytes;
}

template <class Number>
std::vector<Number> numbers_of(const std::string& page, const std::string& id) {
  const std::string bytes = decoded(data_of(page, id));
  std::vector<Number> numbers(bytes.size() / sizeof(Number));
  std::memcpy(numbers.data(), bytes.data(), bytes.size());
  return numbers;
}

TEST(HtmlPlayer, AsksForNothingFromElsewhere) {
  const std::string page = html_player(flying_blocks());
  EXPECT_FALSE(std::regex_search(page, std::regex("(src|href)\\s*=|https?://|import |@import|fetch\\(")));
  EXPECT_THAT(page, Not(HasSubstr("Blocks </script>")));
  EXPECT_EQ(Json::parse(data_of(page, "bake"))["scene"], flying_blocks().scene_name);
}

TEST(HtmlPlayer, HoldsTheNumbersOfTheBake) {
  const Bake bake = flying_blocks();
  const std::string page = html_player(bake);
  const Json header = Json::parse(data_of(page, "bake"));
  const std::vector<float> floats = numbers_of<float>(page, "floats");
  const std::vector<std::uint32_t> indices = numbers_of<std::uint32_t>(page, "indices");
  std::size_t at = 0, index = 0;
  for (std::size_t i = 0; i < bake.objects.size(); ++i) {
    const BakedObject& object = bake.objects[i];
    EXPECT_EQ(header["objects"][i]["pointCount"], object.mesh.points.size());
    EXPECT_EQ(header["objects"][i]["breakTime"].is_null(), !object.break_time);
    for (const auto* vectors : {&object.mesh.points, &object.mesh.normals})
      for (const Vec3& vector : *vectors)
        for (const double value : vector) EXPECT_EQ(floats[at++], static_cast<float>(value));
    for (const Pose& pose : object.poses) {
      for (const double value : pose.translation) EXPECT_EQ(floats[at++], static_cast<float>(value));
      for (const double value : pose.rotation.coeffs()) EXPECT_EQ(floats[at++], static_cast<float>(value));
    }
    for (const auto& triangle : all_triangles(object.mesh))
      for (const int corner : triangle) EXPECT_EQ(indices[index++], static_cast<std::uint32_t>(corner));
  }
  EXPECT_EQ(at, floats.size());
  EXPECT_EQ(index, indices.size());
}

/// Returns the result of the script after it has run in the page, in a browser without a window.
Json in_browser(const std::string& name, const Bake& bake, const std::string& script, const std::string& hash = "") {
  std::string page = html_player(bake);
  page.insert(page.rfind("</body>"), R"(<pre id="result"></pre><script>
    window.onerror = message => document.getElementById('result').textContent = JSON.stringify({error: message});
    setTimeout(() => { const player = window.griffith, result = {};
    try { )" + script + R"( } catch (error) { result.error = String(error); }
    document.getElementById('result').textContent = JSON.stringify(result); }, 500);</script>)");
  const std::filesystem::path file = test_file(name + ".html", page), profile = test_folder() / "profile";
  const std::string command =
      "timeout 60 chromium --headless=new --no-sandbox --use-gl=angle --use-angle=swiftshader "
      "--enable-unsafe-swiftshader --window-size=800,600 --virtual-time-budget=1500 --user-data-dir=" +
      profile.string() + " --dump-dom 'file://" + file.string() + hash + "' 2>/dev/null >" +
      (test_folder() / "dom").string();
  if (std::system(command.c_str()) != 0) return {{"error", "the browser failed"}};
  const std::string dom = read_file(test_folder() / "dom");
  std::smatch match;
  if (!std::regex_search(dom, match, std::regex("<pre id=\"result\">(.*?)</pre>"))) return {{"error", "no result"}};
  return Json::parse(match[1].str());
}

class HtmlPlayerInBrowser : public ::testing::Test {
 protected:
  void SetUp() override {
    if (std::system("command -v chromium >/dev/null") != 0) GTEST_SKIP() << "chromium is not installed";
  }
};

TEST_F(HtmlPlayerInBrowser, PlaysStepsPicksAndReports) {
  const Json result = in_browser("blocks", flying_blocks(), R"(
    player.draw();
    result.thereAtFirst = player.there;
    player.setFrame(2.5);
    player.draw();
    result.there = player.there;
    result.pose = poseAt(player.bake.objects[2], 2.5);
    result.clock = document.getElementById('clock').textContent;
    dispatchEvent(new KeyboardEvent('keydown', {key: 'ArrowRight'}));
    result.stepped = player.frame;
    dispatchEvent(new KeyboardEvent('keydown', {key: '['}));
    result.speed = player.speed;
    dispatchEvent(new KeyboardEvent('keydown', {key: ' '}));
    result.playing = player.playing;
    player.play(false);
    player.setFrame(0);
    player.view.camera.yaw = player.view.camera.pitch = 0;
    player.draw();
    const canvas = document.getElementById('canvas'), size = [canvas.clientWidth, canvas.clientHeight];
    result.middle = player.view.pick(size[0] / 2, size[1] / 2);
    result.corner = player.view.pick(2, 2);
    for (const type of ['pointerdown', 'pointerup'])
      canvas.dispatchEvent(new PointerEvent(type, {pointerId: 1, button: 0, clientX: size[0] / 2, clientY: size[1] / 2}));
    result.selected = player.selected;
    result.panel = document.getElementById('piece').textContent;
    document.querySelector('#piece .link').click();
    result.neighbour = player.selected;
    player.draw();
    const gl = player.view.gl, pixels = new Uint8Array(4 * canvas.width * canvas.height);
    gl.readPixels(0, 0, canvas.width, canvas.height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
    result.drawn = pixels.filter((value, i) => i % 4 === 3 && value > 0).length / (canvas.width * canvas.height);
    result.glError = gl.getError();)");
  ASSERT_FALSE(result.contains("error")) << result;
  EXPECT_EQ(result["thereAtFirst"], 3) << "the shot comes later";
  EXPECT_EQ(result["there"], 4);
  EXPECT_NEAR(result["pose"][0], 1.25, 1e-6);
  EXPECT_NEAR(result["pose"][4], std::sin(0.25 / 2), 1e-4);
  EXPECT_THAT(std::string(result["clock"]), HasSubstr("0.042 s"));
  EXPECT_EQ(result["stepped"], 4);
  EXPECT_EQ(result["speed"], 0.5);
  EXPECT_EQ(result["playing"], true);
  EXPECT_EQ(result["middle"], 1);
  EXPECT_EQ(result["corner"], -1);
  EXPECT_EQ(result["selected"], 1);
  for (const char* text : {"row_1", "2.5 kg", "row_0", "3 MPa", "2 MPa", "16.7 ms"})
    EXPECT_THAT(std::string(result["panel"]), HasSubstr(text));
  EXPECT_EQ(result["neighbour"], 0) << "the bond that opened first stands first";
  EXPECT_GT(result["drawn"], 0.05);
  EXPECT_EQ(result["glError"], 0);
}

TEST_F(HtmlPlayerInBrowser, OpensAsItsAddressSays) {
  const Json result = in_browser("hash", flying_blocks(), R"(
    result.frame = player.frame;
    result.selected = player.selected;
    result.speed = player.speed;)",
                                 "#frame=3&select=row_2&speed=0.1");
  ASSERT_FALSE(result.contains("error")) << result;
  EXPECT_EQ(result["frame"], 3);
  EXPECT_EQ(result["selected"], 2);
  EXPECT_EQ(result["speed"], 0.1);
}

TEST_F(HtmlPlayerInBrowser, DeformedPointsAreFollowed) {
  Bake bake = flying_blocks();
  BakedObject& block = bake.objects[0];
  for (int frame = 0; frame < 6; ++frame) {
    block.deformed_points.push_back(block.mesh.points);
    for (Vec3& point : block.deformed_points.back()) point.x() *= 1 + 0.2 * frame;
  }
  const Json result = in_browser("deformed", bake, R"(
    player.setFrame(2.5);
    player.draw();
    const object = player.bake.objects[0], [vertex, point] = object.vertices[0];
    result.ratio = player.view.vertices[8 * vertex] / object.points[3 * point];)");
  ASSERT_FALSE(result.contains("error")) << result;
  EXPECT_NEAR(result["ratio"], 1.5, 1e-5);
}

TEST_F(HtmlPlayerInBrowser, NothingAndASingleFrameArePlayedToo) {
  Bake empty;
  empty.scene_name = "empty";
  empty.times = {0};
  const Json result = in_browser("empty", empty, R"(
    dispatchEvent(new KeyboardEvent('keydown', {key: ' '}));
    dispatchEvent(new KeyboardEvent('keydown', {key: 'Home'}));
    player.draw();
    result.playing = player.playing;
    result.there = player.there;
    result.glError = player.view.gl.getError();)");
  ASSERT_FALSE(result.contains("error")) << result;
  EXPECT_EQ(result["playing"], false);
  EXPECT_EQ(result["there"], 0);
  EXPECT_EQ(result["glError"], 0);
}

}  // namespace
}  // namespace griffith::app
