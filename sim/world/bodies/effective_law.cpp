#include "sim/world/bodies/effective_law.h"

#include "sim/elasticity/compaction.h"

namespace griffith {

bool can_be_compacted(const WorldState& world, const Body& body) {
  constexpr double kVisibleStrain = 1e-3;
  const Material& material = world.material_of(body);
  return body.is_deformable() && !body.quasi_static && body.edges.empty() && !world.integrates_explicitly() &&
         material.tensile_strength > kVisibleStrain * material.young_modulus;
}

ElasticLaw effective_elastic_law(const WorldState& world, const Body& body) {
  ElasticLaw law = elastic_law(world.material_of(body));
  if (can_be_compacted(world, body)) law.compaction = compaction_modulus(law.lambda, law.mu);
  if (!body.explicit_state) return law;
  law.lambda *= body.explicit_state->similarity;
  law.mu *= body.explicit_state->similarity;
  return law;
}

}  // namespace griffith
