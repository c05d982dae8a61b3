#include "app/picture/crack_lines.h"

#include <gtest/gtest.h>

namespace griffith::app {
namespace {

/// Two tets with a common face at rest. Cut: each has nodes of its own there.
struct TwoTets {
  explicit TwoTets(bool cut) {
    rest = {{0, 0, -1}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    const auto tet = [](int a, int b, int c, int d) {
      return std::array{NodeId(std::int64_t{a}), NodeId(std::int64_t{b}), NodeId(std::int64_t{c}),
                        NodeId(std::int64_t{d})};
    };
    tets = {tet(0, 1, 2, 3), cut ? tet(4, 5, 6, 7) : tet(4, 1, 2, 3)};
    frame.nodes.rest_positions = frame.nodes.positions = rest;
    frame.elements.tets = tets;
    frame.elements.bodies = bodies;
    frame.elements.first_surface = first_surface;
    frame.crack_events = events;
  }

  std::size_t lines() const {
    const ViewSettings view;
    const ShownMesh shown{frame, view, {Vec3::Zero(), Vec3::Zero()}, rest, 1, 1, {}};
    return crack_lines(surface_triangles(frame, [](std::size_t, std::size_t face) { return face != 0; }), shown).size();
  }

  std::vector<Vec3> rest;
  std::vector<std::array<NodeId, 4>> tets;
  std::vector<BodyId> bodies = {BodyId(std::int64_t{0}), BodyId(std::int64_t{0})};
  std::vector<std::uint8_t> first_surface = {0b1110, 0b1110};
  std::vector<std::array<TetId, 4>> neighbors = std::vector<std::array<TetId, 4>>(2);
  std::vector<CrackEvent> events = std::vector<CrackEvent>(1);
  Frame frame;
};

TEST(CrackLines, ACrackInOnePieceShowsWhereItComesToTheSurface) {
  TwoTets cut(true);
  cut.frame.elements.neighbors = cut.neighbors;
  EXPECT_EQ(cut.lines(), 3u);
}

TEST(CrackLines, NeitherWholeNorPartedPiecesHaveAny) {
  TwoTets whole(false);
  whole.frame.elements.neighbors = whole.neighbors;
  EXPECT_EQ(whole.lines(), 0u);
  TwoTets parted(true);
  parted.frame.elements.neighbors = parted.neighbors;
  parted.bodies[1] = BodyId(std::int64_t{1});
  EXPECT_EQ(parted.lines(), 0u);
}

}  // namespace
}  // namespace griffith::app
