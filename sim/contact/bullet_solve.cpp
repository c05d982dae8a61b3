#include <algorithm>
#include <cassert>
#include <tuple>

#include "sim/contact/bullet_world.h"

namespace griffith {

using namespace contact;

namespace {

ProxyId id_of(const btCollisionObject* object) { return ProxyId(object->getUserIndex()); }

/// Names a manifold whatever the order in which pairs were found: the objects and the parts of compounds that touch.
auto order_of(const btPersistentManifold* manifold) {
  const btManifoldPoint& point = manifold->getContactPoint(0);
  return std::tuple(manifold->getBody0()->getUserIndex(), manifold->getBody1()->getUserIndex(), point.m_index0,
                    point.m_index1);
}

/// Distance less the overlap that is allowed; a gap stays a gap.
double distance_beyond(double distance, double allowed_overlap) {
  return distance < 0 ? std::min(0.0, distance + allowed_overlap) : distance;
}

double largest_overlap(const btPersistentManifold& manifold) {
  double overlap = 0;
  for (int i = 0; i < manifold.getNumContacts(); ++i)
    overlap = std::max(overlap, -manifold.getContactPoint(i).getDistance());
  return overlap;
}

bool pair_less(const Allowance& left, const Allowance& right) {
  return std::tie(left.a, left.b) < std::tie(right.a, right.b);
}

Vec3 rotation_vector(const Quat& turn) {
  const Eigen::AngleAxisd rotation(turn);
  return rotation.angle() * rotation.axis();
}

}  // namespace

void ContactWorld::Impl::detect() {
  delete_retired();
  world.performDiscreteCollisionDetection();
  collect_manifolds();
  update_allowances();
  list_contacts();
  for (Object& object : objects) object.fresh = false;
}

void ContactWorld::Impl::collect_manifolds() {
  manifolds.clear();
  for (int i = 0; i < dispatcher.getNumManifolds(); ++i) {
    btPersistentManifold* manifold = dispatcher.getManifoldByIndexInternal(i);
    if (manifold->getNumContacts() > 0) manifolds.push_back(manifold);
  }
  std::sort(manifolds.begin(), manifolds.end(),
            [](auto* left, auto* right) { return order_of(left) < order_of(right); });
}

void ContactWorld::Impl::update_allowances() {
  std::vector<Allowance> overlaps;  // one per pair: manifolds of a pair are neighbours
  for (const btPersistentManifold* manifold : manifolds) {
    const ProxyId a = id_of(manifold->getBody0()), b = id_of(manifold->getBody1());
    if (overlaps.empty() || overlaps.back().a != a || overlaps.back().b != b) overlaps.push_back({a, b, 0});
    overlaps.back().overlap = std::max(overlaps.back().overlap, largest_overlap(*manifold));
  }
  std::erase_if(overlaps, [&](Allowance& pair) {
    const Object &a = objects[pair.a], &b = objects[pair.b];
    const bool fresh = (a.fresh || b.fresh) && a.kind != Kind::ground && b.kind != Kind::ground;
    if (!fresh) pair.overlap = std::min(pair.overlap, allowance(pair.a, pair.b));
    return pair.overlap == 0;
  });
  allowances = std::move(overlaps);
}

double ContactWorld::Impl::allowance(ProxyId a, ProxyId b) const {
  const Allowance wanted{a, b, 0};
  const auto found = std::lower_bound(allowances.begin(), allowances.end(), wanted, pair_less);
  return found != allowances.end() && found->a == a && found->b == b ? found->overlap : 0;
}

void ContactWorld::Impl::list_contacts() {
  contacts.clear();
  points.clear();
  max_penetration = 0;
  for (btPersistentManifold* manifold : manifolds) {
    const ProxyId a = id_of(manifold->getBody0()), b = id_of(manifold->getBody1());
    const double allowed = allowance(a, b);
    for (int i = 0; i < manifold->getNumContacts(); ++i) {
      btManifoldPoint& point = manifold->getContactPoint(i);
      Contact contact{a,
                      b,
                      from_bullet(point.m_positionWorldOnA),
                      from_bullet(point.m_positionWorldOnB),
                      from_bullet(point.m_normalWorldOnB),
                      point.getDistance()};
      max_penetration = std::max(max_penetration, -distance_beyond(contact.distance, allowed));
      contacts.push_back(contact);
      points.push_back(&point);
    }
  }
}

void ContactWorld::Impl::solve(double dt) {
  assert(dt > 0);
  for (std::size_t i = 0; i < contacts.size(); ++i) prepare_contact(i, dt);
  std::vector<btCollisionObject*> bodies;
  for (Object& object : objects) {
    object.correction = {};
    if (!object.moves()) continue;
    object.body->applyCentralForce(to_bullet(gravity) / object.body->getInvMass());
    bodies.push_back(object.body.get());
  }
  if (bodies.empty()) return;
  settings.m_timeStep = dt;
  solver.solveGroup(bodies.data(), static_cast<int>(bodies.size()), manifolds.data(),
                    static_cast<int>(manifolds.size()), nullptr, 0, settings, nullptr, &dispatcher);
  last_dt = dt;
  read_impulses();
  for (Object& object : objects)
    if (object.moves()) read_motion(object);
  move_spheres(dt);
}

Vec3 ContactWorld::Impl::velocity_at(const Object& object, const Vec3& point, double dt) const {
  const Vec3 arm = point - object.state.pose.translation;
  const Vec3 velocity = object.state.velocity + object.state.angular_velocity.cross(arm);
  return object.moves() ? Vec3(velocity + dt * gravity) : velocity;
}

void ContactWorld::Impl::prepare_contact(std::size_t index, double dt) {
  const Contact& contact = contacts[index];
  btManifoldPoint& point = *points[index];
  const Object &a = objects[contact.a], &b = objects[contact.b];
  const double allowed = allowance(contact.a, contact.b);
  const Vec3 velocity = velocity_at(a, contact.position_on_a, dt) - velocity_at(b, contact.position_on_b, dt);
  const double approach = -contact.normal.dot(velocity);

  // A gap that closes in this substep is struck now, at full speed, rather than half now and half in the next one.
  const bool struck = approach > kQuietSpeed && approach * dt > contact.distance;
  point.m_distance1 = struck ? std::min(contact.distance, 0.0) : contact.distance;
  point.m_distance1 = distance_beyond(point.m_distance1, allowed);
  point.m_combinedFriction = std::sqrt(a.surface.friction * b.surface.friction);
  point.m_combinedRestitution = allowed > 0 ? 0 : std::min(a.surface.restitution, b.surface.restitution);

  // The last substep's impulse is where the solver starts; a resting one is proportional to dt.
  if (last_dt > 0) point.m_appliedImpulse *= dt / last_dt;

  // The solver adds m_contactCFM / dt to the inverse effective mass.
  point.m_contactPointFlags = BT_CONTACT_FLAG_HAS_CONTACT_CFM | BT_CONTACT_FLAG_LATERAL_FRICTION_INITIALIZED;
  point.m_contactCFM = dt * contact.compliance;

  // One direction of friction along the sliding, or the sliding that gravity would begin.
  const Vec3 sliding = velocity + approach * contact.normal;
  const double speed = sliding.norm();
  const Vec3 direction = speed > 1e-9 ? Vec3(sliding / speed) : contact.normal.unitOrthogonal();
  point.m_lateralFrictionDir1 = to_bullet(direction);
  point.m_lateralFrictionDir2 = to_bullet(direction.cross(contact.normal));
}

void ContactWorld::Impl::read_impulses() {
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const btManifoldPoint& point = *points[i];
    contacts[i].impulse = from_bullet(point.m_appliedImpulse * point.m_normalWorldOnB +
                                      point.m_appliedImpulseLateral1 * point.m_lateralFrictionDir1 +
                                      point.m_appliedImpulseLateral2 * point.m_lateralFrictionDir2);
  }
}

void ContactWorld::Impl::read_motion(Object& object) {
  object.body->clearForces();
  object.state.velocity = from_bullet(object.body->getLinearVelocity());
  object.state.angular_velocity = from_bullet(object.body->getAngularVelocity());
  const btTransform pushed = object.body->getWorldTransform();
  place(object);
  const btTransform& before = object.body->getWorldTransform();
  if (pushed == before) return;  // else the solver has moved it out of an overlap
  object.correction.translation = from_bullet(pushed.getOrigin() - before.getOrigin());
  btQuaternion turn;
  (pushed.getBasis() * before.getBasis().transpose()).getRotation(turn);
  object.correction.rotation = rotation_vector(Quat(turn.w(), turn.x(), turn.y(), turn.z()));
}

}  // namespace griffith
