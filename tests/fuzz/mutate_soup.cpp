#include "tests/fuzz/mutate_soup.h"

#include <cmath>
#include <limits>

#include "sim/mesh/box_mesh.h"

namespace griffith::fuzz {
namespace {

double odd_number(RandomValues& random) {
  static const std::vector<double> kNumbers = {0,
                                               1,
                                               -1,
                                               1e-9,
                                               1e-160,
                                               5e-324,
                                               1e9,
                                               1e20,
                                               1e100,
                                               1e154,
                                               -1e200,
                                               1e308,
                                               std::numeric_limits<double>::quiet_NaN(),
                                               std::numeric_limits<double>::infinity()};
  return pick(random, kNumbers);
}

/// Far too large and far too small, and whatever is between.
double any_factor(RandomValues& random) {
  return std::pow(10, chance(random, 0.8) ? random.uniform(-6, 6) : random.uniform(-300, 300));
}

void change_point(TetSoup& soup, RandomValues& random) {
  const int count = static_cast<int>(soup.points.size());
  Vec3& point = soup.points[random.index(count)];
  switch (random.index(5)) {
    case 0:
      point[random.index(3)] = odd_number(random);
      break;
    case 1:
      point = Vec3(soup.points[random.index(count)]);
      break;
    case 2:
      point += random.vector(1e-7);
      break;
    case 3:
      point += random.vector(0.3);
      break;
    default:
      point = (point + soup.points[random.index(count)]) / 2;
  }
}

void change_tet(TetSoup& soup, RandomValues& random) {
  const int place = random.index(static_cast<int>(soup.tets.size()));
  const int points = static_cast<int>(soup.points.size());
  auto& tet = soup.tets[place];
  switch (random.index(6)) {
    case 0:
      std::swap(tet[random.index(4)], tet[random.index(4)]);
      break;
    case 1:
      soup.tets.push_back(std::array<int, 4>(tet));
      break;
    case 2:
      tet[random.index(4)] = random.index(points);
      break;
    case 3:
      tet[random.index(4)] = chance(random, 0.5) ? points : -1;
      break;
    default:
      soup.tets.erase(soup.tets.begin() + place);
  }
}

/// All uses of one point become uses of another: parts that were apart meet in a node.
void join_points(TetSoup& soup, RandomValues& random) {
  const int count = static_cast<int>(soup.points.size());
  const int from = random.index(count), to = random.index(count);
  for (auto& tet : soup.tets)
    for (int& corner : tet) corner = corner == from ? to : corner;
}

/// Adds a second copy next to the first that shares a node, an edge or more with it.
void add_neighbor(TetSoup& soup, RandomValues& random) {
  const int count = static_cast<int>(soup.points.size()), tets = static_cast<int>(soup.tets.size());
  const int shared = 1 + random.index(3);
  const Vec3 shift = chance(random, 0.5) ? Vec3(1, 1, 0) : Vec3(2.5 * random.direction());
  for (int i = 0; i < count; ++i) soup.points.push_back(soup.points[i] + shift);
  for (int i = 0; i < tets; ++i) {
    auto tet = soup.tets[i];
    for (int& corner : tet) corner = corner < count && corner >= shared ? corner + count : corner;
    soup.tets.push_back(tet);
  }
}

void thin_out(TetSoup& soup, RandomValues& random) {
  const double fraction = random.uniform(0, 0.7);
  std::erase_if(soup.tets, [&](const auto&) { return chance(random, fraction); });
}

}  // namespace

std::vector<TetSoup> small_soups() {
  std::vector<TetSoup> soups = {{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2, 3}}}};
  for (const BoxPattern pattern : {BoxPattern::kuhn, BoxPattern::five_tet, BoxPattern::bcc}) {
    soups.push_back(make_box(Vec3(1, 1, 1), Vec3(1, 1, 1), pattern));
    soups.push_back(make_box(Vec3(2, 1, 1), Vec3(1, 1, 1), pattern));
  }
  return soups;
}

TetSoup mutate_soup(TetSoup soup, RandomValues& random) {
  const double factor = any_factor(random);
  if (chance(random, 0.2))
    for (Vec3& point : soup.points) point *= factor;
  do {
    if (soup.points.empty() || soup.tets.empty()) break;
    const int way = random.index(12);
    if (way < 4)
      change_point(soup, random);
    else if (way < 7)
      change_tet(soup, random);
    else if (way < 9)
      thin_out(soup, random);
    else if (way < 10)
      join_points(soup, random);
    else if (soup.points.size() < 40)
      add_neighbor(soup, random);
  } while (chance(random, 0.4));
  return soup;
}

}  // namespace griffith::fuzz
