// Crack planes, contacts and axes that are clicked in the view.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "app/editor/symbol_picking.h"
#include "editor_fixture.h"
#include "tests/random_values.h"

namespace griffith::app {
namespace {

using ::testing::HasSubstr;
using ui::SymbolKind;

constexpr double kNoLimit = std::numeric_limits<double>::infinity();

TEST(SymbolOn, FindsWhatARayThroughItsCenterMeetsFirst) {
  testing::RandomValues random(5);
  for (int trial = 0; trial < 300; ++trial) {
    std::vector<LayerSymbol> symbols;
    for (int i = 0; i < 4; ++i)
      symbols.push_back({{static_cast<SymbolKind>(random.index(4)), i}, random.vector(2), random.vector(0.3)});
    const Vec3 eye = random.vector(1) + Vec3(0, 0, 10);
    const Vec3 toward = (symbols[0].place - eye).normalized();
    const render::Ray ray{eye.cast<float>(), toward.cast<float>()};
    const double distance = (symbols[0].place - eye).norm();
    const LayerSymbol* found = symbol_on(ray, symbols, 0.002, kNoLimit);
    ASSERT_TRUE(found);
    const double nearer = (found->place - eye).norm() - found->arm.norm();
    EXPECT_LE(nearer, distance + 1e-3) << "or one in front of it";
    EXPECT_EQ(symbol_on(ray, std::span(symbols).first(1), 0.002, 0.9 * distance - 1), nullptr) << "beyond the limit";
    const render::Ray away{ray.origin, -ray.direction};
    EXPECT_EQ(symbol_on(away, symbols, 0.002, kNoLimit), nullptr);
  }
}

TEST(SymbolOn, AnAxisIsMetWithinTheSlackAlone) {
  const std::vector<LayerSymbol> axis = {{{SymbolKind::stress_axis, 3, 1}, Vec3::Zero(), Vec3(0, 1, 0)}};
  for (const double aside : {0.0, 0.09, 0.11, 1.0})
    for (const double height : {0.0, 0.95, 1.2}) {
      const render::Ray ray{Eigen::Vector3f(static_cast<float>(aside), static_cast<float>(height), 10),
                            -Eigen::Vector3f::UnitZ()};
      const bool near = std::hypot(aside, std::max(0.0, height - 1)) < 0.1;
      EXPECT_EQ(symbol_on(ray, axis, 0.01, kNoLimit) != nullptr, near) << aside << " " << height;
    }
}

class SymbolsTest : public EditorTest {
 protected:
  void run_to_crack() {
    editor_.state().shot.speed = 60;
    editor_.execute({.name = "simulation.fire"});
    while (editor_.run().frame().crack_events.empty()) editor_.run().step();
  }
  void show(const char* view) {
    editor_.viewport().use_view(view, editor_.run().frame());
    draw(2);
  }
  /// Returns the symbols of the view in front of the eye, with their places in it, 0..1.
  std::vector<std::pair<ui::Symbol, Vec2>> symbols_in_view() {
    const Frame frame = editor_.run().frame();
    const ShownMesh shown = shown_mesh(frame, editor_.state().view, {}, {});
    const render::Camera camera = editor_.viewport().exported_view(editor_.run().built()).camera;
    const Mat3 axes = render::view_matrix(camera).topLeftCorner<3, 3>().cast<double>();
    const ImVec2 size = editor_.state().viewport_size;
    const double tangent = std::tan(camera.vertical_fov * std::numbers::pi / 360);
    std::vector<std::pair<ui::Symbol, Vec2>> places;
    for (const LayerSymbol& symbol : layer_symbols(shown)) {
      const Vec3 eye = axes * (symbol.place - camera.position.cast<double>());
      const Vec2 place(0.5 + 0.5 * eye.x() / (-eye.z() * tangent * size.x / size.y),
                       0.5 - 0.5 * eye.y() / (-eye.z() * tangent));
      if (eye.z() < 0 && place.minCoeff() > 0.02 && place.maxCoeff() < 0.98) places.emplace_back(symbol.symbol, place);
    }
    return places;
  }
  /// Clicks on the places of symbols, some at most. Returns the number of clicks that selected the symbol there.
  int hits(SymbolKind kind) {
    int hits = 0, clicks = 0;
    for (const auto& [symbol, place] : symbols_in_view()) {
      if (clicks++ == 20) break;
      editor_.execute({.name = "view.pick", .cursor = place});
      EXPECT_TRUE(editor_.state().symbol) << "something is met there";
      hits += editor_.state().symbol == symbol;
      if (!editor_.state().symbol) continue;
      EXPECT_EQ(editor_.state().symbol->kind, kind);
    }
    return hits;
  }
};

TEST_F(SymbolsTest, ACrackPlaneExplainsItself) {
  run_to_crack();
  show("fracture_planes");
  EXPECT_GT(hits(SymbolKind::fracture_plane), 0);
  draw();
  EXPECT_THAT(value("symbol/sentence"), HasSubstr("the load"));
  const Frame frame = editor_.run().frame();
  const CrackEvent& crack = frame.crack_events[static_cast<std::size_t>(editor_.state().symbol->index)];
  EXPECT_EQ(value("symbol/Node"), std::to_string(crack.node.index()));
  EXPECT_EQ(editor_.state().selection.node, crack.node) << "the node of the plane is explained below";
  editor_.execute({.name = "view.pick", .cursor = Vec2(0.01, 0.01)});
  draw();
  EXPECT_FALSE(ui::find_tag(editor_.tags(), "symbol/sentence"));
}

TEST_F(SymbolsTest, AContactExplainsItselfInItsStep) {
  run_to_crack();
  show("contacts");
  EXPECT_GT(hits(SymbolKind::contact), 0);
  draw();
  EXPECT_THAT(value("symbol/sentence"), HasSubstr(" pushed "));
  EXPECT_THAT(value("symbol/Normal force"), HasSubstr("N"));
  editor_.run().step();
  draw();
  EXPECT_FALSE(editor_.state().symbol) << "the next step has others";
}

TEST_F(SymbolsTest, AxesExplainThemselves) {
  run_to_crack();
  show("stress_axes");
  EXPECT_GT(hits(SymbolKind::stress_axis), 0);
  draw();
  EXPECT_THAT(value("symbol/sentence"), HasSubstr("along this axis"));
  EXPECT_EQ(editor_.state().selection.tet, TetId(editor_.state().symbol->index));
}

TEST_F(SymbolsTest, SeparationAxesBelongToNodes) {
  editor_.state().shot.speed = 3;
  editor_.execute({.name = "simulation.fire"});
  for (int step = 0; step < 60 && editor_.run().frame().report.peak_utilization == 0; ++step) editor_.run().step();
  show("separation_axes");
  ASSERT_FALSE(symbols_in_view().empty());
  EXPECT_GT(hits(SymbolKind::separation_axis), 0);
  draw();
  EXPECT_EQ(editor_.state().selection.node, NodeId(editor_.state().symbol->index));
}

TEST_F(SymbolsTest, OpaqueBodiesHideWhatIsBehindThem) {
  run_to_crack();
  show("fracture_planes");
  editor_.state().view.opacity = 1;
  draw(2);
  editor_.viewport().look_from(Vec3(0, 1, -8), Vec3(0, 1, 0));
  draw(2);
  int picked = 0;
  for (const auto& [symbol, place] : symbols_in_view()) {
    editor_.execute({.name = "view.pick", .cursor = place});
    picked += editor_.state().symbol.has_value();
  }
  EXPECT_LT(picked, static_cast<int>(symbols_in_view().size())) << "planes at the struck side are hidden from behind";
}

}  // namespace
}  // namespace griffith::app
