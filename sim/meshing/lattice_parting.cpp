#include "sim/meshing/lattice_parting.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "sim/mesh/mesh_report.h"
#include "sim/meshing/volumetric.h"

namespace griffith {
namespace {

/// Rounds a size to readable digits, so that the reported size is the one that was tried.
double rounded(double size) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2g", size);
  return std::strtod(text, nullptr);
}

int pieces_of(TetSoup soup, const std::string& name) { return soup.tets.empty() ? 0 : prepare(soup, name).pieces; }

}  // namespace

LatticeParting find_parting(const TriangleSurface& surface, const SurfaceReport& report, const TetSoup& mesh,
                            const MeshingOptions& options, double element_size, const MeshingSetup& setup) {
  constexpr int kSteps = 6;  // each step shortens elements by the square root of two
  constexpr double kMaxTets = 5e5;
  LatticeParting parting;
  parting.pieces = parting.joined = pieces_of(mesh, setup.name);
  parting.shells = report.shells;
  const bool shells_may_cross = report.self_intersections.pairs > 0 || report.boundary_edges > 0;
  if (parting.pieces == 1 || !(parting.pieces > parting.shells || shells_may_cross)) return parting;
  setup.monitor.enter("Looking for what keeps it together");
  const double tets = static_cast<double>(mesh.tets.size());
  for (int step = 1; step <= kSteps && parting.joined > 1; ++step) {
    const double size = rounded(element_size * std::pow(2, -step / 2.0));
    if (tets * std::pow(element_size / size, 3) > kMaxTets) break;
    const int pieces = pieces_of(stuff_surface(surface, size, options.grading, setup.name, setup.monitor), setup.name);
    ++parting.tried;
    parting.least_size = size;
    if (pieces == 0 || pieces >= parting.joined) continue;
    parting.joined = pieces;
    parting.element_size = size;
  }
  return parting;
}

std::string finding(const LatticeParting& parting) {
  const bool found = parting.element_size > 0;
  if (parting.pieces < 2 || !(found || parting.pieces > parting.shells)) return {};
  char text[240], remedy[120];
  if (found)
    std::snprintf(remedy, sizeof remedy, "an element size of %.2g m keeps it in %d", parting.element_size,
                  parting.joined);
  else if (parting.tried > 0)
    std::snprintf(remedy, sizeof remedy, "so does one of %.2g m, give a smaller element size", parting.least_size);
  else
    std::snprintf(remedy, sizeof remedy, "give a smaller element size");
  std::snprintf(text, sizeof text, "the lattice parts it into %d pieces where it is thinner than the elements: %s",
                parting.pieces, remedy);
  return text;
}

}  // namespace griffith
