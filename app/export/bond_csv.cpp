#include "app/export/bond_csv.h"

#include <limits>

#include "app/output/csv_field.h"

namespace griffith::app {

std::string bond_csv(const Bake& bake) {
  std::string csv =
      "a,b,area [m²],center x [m],center y [m],center z [m],normal x,normal y,normal z,strength [Pa],break time [s]\n";
  for (const BakedBond& bond : bake.bonds) {
    csv += csv_field(bake.objects[bond.a].name) + ',' + csv_field(bake.objects[bond.b].name);
    append_csv_number(csv, bond.area);
    for (const double x : bond.center) append_csv_number(csv, x);
    for (const double x : bond.normal) append_csv_number(csv, x);
    append_csv_number(csv, bond.strength);
    append_csv_number(csv, bond.break_time.value_or(std::numeric_limits<double>::quiet_NaN()));
    csv += '\n';
  }
  return csv;
}

}  // namespace griffith::app
