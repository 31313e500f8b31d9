// Walls of triangles through the whole engine, against the shapes that they stand for.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "dem/insertion/placement.hpp"
#include "tests/dem/mesh/meshes.hpp"
#include "tests/dem/walls_in_motion.hpp"

BOOST_AUTO_TEST_SUITE(mesh_wall_test)

namespace dem = fiberchain::dem;
using V = dem::Vec<double, 3>;
using namespace walls_in_motion;

namespace {

const dem::ContactProperties kRough{.restitution = 0.6, .friction = 0.37, .rolling_friction = 0.02};

/// A fiber and how it begins.
struct Launch {
  int aspect_ratio;
  V place, along, velocity, spin;
};

dem::Assembly launched(const Launch& launch, const dem::Domain& around, double step, bool accounted = false) {
  const dem::Chain<3> chain = dem::straight_chain<3>(fiber_with(launch.aspect_ratio));
  dem::ChainState<3> state = dem::placed(chain, {launch.place, launch.along, launch.velocity});
  for (V& w : state.spin) w = launch.spin;
  return {{{chain, {state}}}, around, {.step = step, .account_energy = accounted}};
}

/// Largest distance of a sphere's center in one from that in the other [m].
double apart(const dem::Assembly& a, const dem::Assembly& b) {
  const dem::PlacedSpheres x = a.placed(), y = b.placed();
  double largest = 0;
  for (std::size_t i = 0; i < x.position.size(); ++i)
    largest = std::max(largest, norm(x.position[i] - y.position[i]));
  return largest;
}

/// Moves both on and says how far apart they come, over the diameter.
double largest_apart(dem::Assembly& a, dem::Assembly& b, int times, int steps) {
  double largest = 0;
  for (int n = 0; n < times; ++n) {
    a.march(steps), b.march(steps);
    largest = std::max(largest, apart(a, b));
  }
  return largest / a.chain(0).fiber.diameter;
}

/// Features of a mesh that contacts have been with so far.
void see_features(const dem::Assembly& assembly, std::vector<std::int32_t>& seen) {
  for (const auto& contact : assembly.contacts()) {
    if (is_facet(contact.key.second) && std::ranges::find(seen, contact.key.slot) == seen.end())
      seen.push_back(contact.key.slot);
  }
}

const dem::Quaternion<double> kTilt = dem::rotation(V{0.31, -0.22, 0.4});
const V kUp = rotate(kTilt, V{0, 0, 1}), kAlong = rotate(kTilt, V{1, 0, 0}),
        kAcross = rotate(kTilt, V{0, 1, 0});

dem::MeshShape tilted_flat(double half, int cells, dem::MeshSides sides = dem::MeshSides::both) {
  dem::MeshShape shape = meshes::shape_of(meshes::flat(half, cells), sides);
  shape.turn(kTilt);
  shape.point = {1e-3, 2e-3, -3e-3};
  return shape;
}

dem::Domain on(const dem::Wall& wall) {
  dem::Domain around;
  around.walls = {wall};
  around.contacts = kRough;
  around.wall_youngs_modulus = 7e6;
  around.gravity = -g * kUp;
  return around;
}

}  // namespace

/// Rebound, sliding and rolling of a sphere and of a fiber over faces, edges and corners.
BOOST_AUTO_TEST_CASE(bodies_move_on_triangles_as_on_a_plane) {
  const double R = 0.83e-3, step = 4e-6;
  const dem::MeshShape mesh = tilted_flat(0.02, 11);
  const dem::Plane plane{mesh.point, kUp};
  const Launch launches[] = {
      {1, mesh.point + 1.5 * R * kUp - 8e-3 * kAlong, kAcross, 0.2 * kAlong - 0.3 * kUp, 30.0 * kUp},
      {1, mesh.point + R * kUp - 8e-3 * kAlong, kAcross, 0.25 * kAlong, {}},
      {1, mesh.point + R * kUp - 8e-3 * kAlong, kAcross, 0.2 * kAlong + 0.02 * kAcross, (0.2 / R) * kAcross},
      {7,
       mesh.point + 1.4 * R * kUp - 9e-3 * kAlong - 3e-3 * kAcross,
       rotate(kTilt, V{0.6, 0.8, 0.02}),
       0.2 * kAlong - 0.1 * kUp,
       {}}};
  for (const dem::MeshSides sides : {dem::MeshSides::both, dem::MeshSides::one}) {
    for (const Launch& launch : launches) {
      dem::MeshShape sheet = mesh;
      sheet.sides = sides;
      dem::Assembly exact = launched(launch, on({plane}), step), meshed = launched(launch, on({sheet}), step);
      std::vector<std::int32_t> seen;
      double off = 0;
      for (int n = 0; n < 40; ++n) {
        off = std::max(off, largest_apart(exact, meshed, 1, 250));
        BOOST_TEST(exact.touching() == meshed.touching());
        see_features(meshed, seen);
      }
      BOOST_TEST_MESSAGE("apart by " << off << " diameters, " << seen.size() << " features touched");
      BOOST_TEST(off < 1e-9);
      BOOST_TEST(seen.size() > (&launch == launches ? 0u : 4u));
      BOOST_TEST(norm(meshed.state(0, 0).poses[0].position - launch.place) > 2 * R);
    }
  }
}

/// A sphere and a fiber that come upon a box, its edges and corners, from many sides.
BOOST_AUTO_TEST_CASE(bodies_meet_a_box_of_triangles_as_the_obstacle) {
  const V half{3e-3, 2e-3, 4e-3};
  dem::MeshShape mesh = meshes::shape_of(meshes::box(half, 2), dem::MeshSides::one);
  mesh.turn(kTilt);
  const dem::BoxObstacle obstacle{{}, half, kAlong, kAcross};
  dem::Domain around = on({mesh}), exact_around = on({obstacle});
  around.gravity = exact_around.gravity = {};
  bool edge = false, corner = false, face = false;
  for (int n = 0; n < 12; ++n) {
    const double a = 2.4 * n, c = std::cos(1.7 * n + 0.3), s = std::sqrt(1 - c * c);
    V out{s * std::cos(a), s * std::sin(a), c}, target{};
    if (n % 3 == 0) {  // a corner, from where it is nearest
      out = {std::abs(out[0]), std::abs(out[1]), -std::abs(out[2])};
      target = {half[0], half[1], -half[2]};
    } else if (n % 3 == 1) {  // an edge
      out = {-std::abs(out[0]), 0.2 * out[1], std::abs(out[2])};
      target = {-half[0], 1e-4 * n, half[2]};
    }
    out = rotate(kTilt, (1 / norm(out)) * out), target = rotate(kTilt, target);
    const Launch launch{
        n % 2 == 0 ? 1 : 4, target + 9e-3 * out, rotate(kTilt, V{0.3, 0.5, 0.2}), -0.6 * out, {}};
    dem::Assembly exact = launched(launch, exact_around, 5e-6), meshed = launched(launch, around, 5e-6);
    double off = 0;
    for (int k = 0; k < 60; ++k) {
      off = std::max(off, largest_apart(exact, meshed, 1, 60));
      for (const auto& contact : meshed.contacts()) {
        if (!is_facet(contact.key.second)) continue;
        const dem::FeatureKind kind = mesh.mesh->kind_of(contact.key.slot);
        edge = edge || kind == dem::FeatureKind::edge;
        corner = corner || kind == dem::FeatureKind::corner;
        face = face || kind == dem::FeatureKind::face;
      }
    }
    BOOST_TEST(off < 1e-9);
    BOOST_TEST(norm(meshed.state(0, 0).velocity[0] + 0.6 * out) > 0.01, "nothing was hit");
  }
  BOOST_TEST((face && edge && corner));
}

/// A plate of triangles that turns, swings and is driven, and the same plane.
BOOST_AUTO_TEST_CASE(moved_meshes_are_moved_planes) {
  const double R = 0.83e-3;
  const dem::MeshShape mesh = tilted_flat(0.03, 9, dem::MeshSides::one);
  const dem::Plane plane{mesh.point, kUp};
  for (int motion = 0; motion < 3; ++motion) {
    dem::Wall walls[2] = {{plane}, {mesh}};
    for (dem::Wall& wall : walls) {
      if (motion == 0) {
        wall.motion.about = dem::WallAxis{mesh.point - 2e-3 * kAlong, kUp + 0.0 * kAlong};
        wall.motion.angular_velocity = 8;
        wall.velocity = 0.02 * kUp + 0.1 * kAcross;
      } else if (motion == 1) {
        wall.motion.oscillation = dem::WallOscillation{rotate(kTilt, V{0.6, 0, 0.8}), 5e-4, 60, 0.3, 0.01};
        wall.motion.about = dem::WallAxis{mesh.point, kAcross};
        wall.motion.angular_velocity = 0.5;
      } else {
        wall.motion.drive = dem::WallDrive{.axis = kUp, .mass = 2e-5, .force = 4e-4, .damping = 1e-3};
      }
    }
    const Launch launch{5, mesh.point + 1.05 * R * kUp - 3e-3 * kAcross, kAcross, 0.05 * kAlong, {}};
    dem::Assembly exact = launched(launch, on(walls[0]), 4e-6), meshed = launched(launch, on(walls[1]), 4e-6);
    const double off = largest_apart(exact, meshed, 20, 500);
    BOOST_TEST_MESSAGE("motion " << motion << ": apart by " << off << " diameters");
    BOOST_TEST(off < 1e-9);
    const dem::WallSample a = exact.wall_samples()[0], b = meshed.wall_samples()[0];
    within(norm(a.mean.force - b.mean.force) / a.force_peak, 0, 1e-8, "mean force");
    within(norm(a.mean.moment - b.mean.moment) / a.moment_peak, 0, 1e-6, "mean moment");
    within(a.work / b.work, 1, 1e-8, "work");
    BOOST_TEST(a.force_peak > 0);
  }
}

namespace {

/// A bowl with a small hole at its bottom: corners of the triangles on the sphere, `around` of them in a
/// circle.
dem::MeshShape bowl(double radius, int around) {
  return meshes::shape_of(meshes::patch(around, around / 3, [=](double u, double v) {
    const double turned = 2 * pi * (std::round(u * around) == around ? 0 : u), up = pi * (0.02 + 0.6 * v);
    return V{radius * std::sin(up) * std::cos(turned), radius * std::sin(up) * std::sin(turned),
             -radius * std::cos(up)};
  }));
}

/// A tube about y.
dem::MeshShape tube(double radius, int around) {
  dem::MeshShape shape = meshes::shape_of(meshes::tube(radius, 0.03, around, 7));
  shape.turn(dem::rotation(V{pi / 2, 0, 0}));
  return shape;
}

struct Rolled {
  V place;            ///< of the middle
  double energy_off;  ///< over the kinetic energy
};

/// A fiber of two spheres, across its way, that begins to roll in a hollow with its middle at `toward` from
/// the center, both spheres at the surface.
Rolled rolled(const dem::WallShape& shape, double radius, bool is_bowl, const V& toward, const V& along,
              const V& velocity, double restitution) {
  const double R = 0.83e-3, step = 2e-6, duration = 0.04, far = radius - R;
  dem::Domain around;
  around.walls = {{shape}};
  around.contacts = {.restitution = restitution, .friction = 0.6};
  around.gravity = {0, 0, -g};
  const V middle = (is_bowl ? std::sqrt(far * far - R * R) : far) * toward;
  const Launch launch{1, middle - R * along, along, velocity, (1 / R) * cross(toward, velocity)};
  dem::Assembly assembly = launched(launch, around, step, true);
  const double begin = total(assembly.energy()), m = dem::fiber_mass(assembly.chain(0).fiber);
  assembly.march(std::llround(duration / step));
  const dem::ChainState<3> state = assembly.state(0, 0);
  return {0.5 * (state.poses[0].position + state.poses[1].position),
          (total(assembly.energy()) - begin) / (0.5 * m * dot(velocity, velocity))};
}

}  // namespace

/// Through a bowl and a tube of ever more triangles: energy closes, and the way tends to that in the exact
/// shape, at an order between 1 (of what each edge takes: facets turn by the angle between them, an impact of
/// that times the speed, lost but for the restitution) and 2 (of the facets' depth).
BOOST_AUTO_TEST_CASE(ways_through_meshes_tend_to_those_in_exact_shapes) {
  const double radius = 11e-3, down = 0.7;
  const V toward{std::sin(down), 0, -std::cos(down)}, uphill{std::cos(down), 0, std::sin(down)}, y{0, 1, 0};
  for (const bool is_bowl : {true, false}) {
    const V along = is_bowl ? uphill : y, velocity = is_bowl ? 0.35 * y : -0.35 * uphill;
    const auto roll = [&](const dem::WallShape& shape) {
      return rolled(shape, radius, is_bowl, toward, along, velocity, 0.05);
    };
    const Rolled wanted = roll(is_bowl ? dem::WallShape(dem::Sphere{{}, radius})
                                       : dem::WallShape(dem::Cylinder{{}, y, radius}));
    BOOST_TEST_MESSAGE("exact: energy " << wanted.energy_off);
    BOOST_TEST(std::abs(wanted.energy_off) < 1e-3);
    std::vector<double> off;
    for (const int around : {72, 144, 288, 576}) {
      const Rolled own = roll(is_bowl ? bowl(radius, around) : tube(radius, around));
      off.push_back(norm(own.place - wanted.place) / radius);
      BOOST_TEST_MESSAGE((is_bowl ? "bowl " : "tube ")
                         << around << ": " << off.back() << " of the radius off, energy " << own.energy_off);
      BOOST_TEST(std::abs(own.energy_off) < 1e-3);
    }
    const double order = std::log2(off.front() / off.back()) / 3;
    BOOST_TEST_MESSAGE("order " << order);
    within(order, 1.4, 0.4, "order");
    within(off.back(), 0, 2e-3, "way");
  }
}

BOOST_AUTO_TEST_SUITE_END()
