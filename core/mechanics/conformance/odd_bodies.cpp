// Masses, centres of mass, inertias and drawn solids that do not go together.
//
// A body's second moments of mass tell how far it extends: with <.> the mean over its mass, about its centre of mass,
//     I_xx = m <y^2 + z^2>, and so on, hence   <x^2> = (I_yy + I_zz - I_xx) / 2m                                                  (1)
// and a uniform bar or plate of edge a along x has <x^2> = a^2 / 12. So
//     a = sqrt(6 (I_yy + I_zz - I_xx) / m)                                                                                         (2)
// is its size along x: the length of a uniform cylinder exactly, sqrt(3) times its radius across.
#include <core/mechanics/conformance/oddities.hpp>

#include <core/text/units.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace pmreport::mechanics {

using Eigen::Vector3d;

namespace {

// A solid's mass over its volume. Parts weigh 1000 to 25000 kg/m^3, and a sketch may draw them ten times too thick, as it does what is
// hollow, or ten times too thin.
constexpr Range density{10, 2.5e6};  // [kg/m^3]

// Of the sizes of one body or limb, in terms of the one that they are compared with.
constexpr double too_long = 3, too_compact = 1.0 / 30;

// By (2), body axes; what is not a possible body has no size there.
Vector3d size_by_inertia(const Inertia& inertia) {
  const Vector3d i = inertia.about_centre.diagonal();
  const Vector3d squares = (6 / inertia.mass) * (Vector3d::Constant(i.sum()) - 2 * i);
  return squares.cwiseMax(0).cwiseSqrt();
}

const char* axis_word(Eigen::Index k) { return k == 0 ? "x" : k == 1 ? "y" : "z"; }

// What a body's parts are compared with: the reach of its limb, or itself and the whole where it belongs to none.
double room_of(const AtHome& home, int body) {
  const int limb = home.body(body).limb;
  return limb > 0 ? home.reach(limb) : std::max(home.apart(home.joints_of(body)), home.drawn_size(body));
}

std::string room_words(const AtHome& home, int body) {
  const int limb = home.body(body).limb;
  if (limb == 0) return fmt::format("its joints are {} apart", length_words(home.apart(home.joints_of(body))));
  std::string out = fmt::format("the joints of limb {} are {} apart at home", limb, length_words(home.joints_apart(limb)));
  if (home.longest_drive(limb) > 0) out += fmt::format(" and its drive ends at {}", length_words(home.longest_drive(limb)));
  return out;
}

void look_at_centre(const AtHome& home, int i, std::vector<Oddity>& out) {
  const Vector3d& c = home.body(i).inertia.centre;
  const Eigen::AlignedBox3d box = home.box(i);
  if (box.isEmpty()) return;
  const double size = std::max(box.diagonal().norm(), home.joints_of(i).size() < 2 ? home.drawn_size(i) : 0);
  if (!(size > 0)) return;
  Eigen::AlignedBox3d of_joints;
  for (const int j : home.joints_of(i)) of_joints.extend(home.seat(j, i));
  // Along an axis in which the body extends its centre lies between its ends; across a thin one it may stand off, as a tool on a plate
  // does. To the side where a limb's part is drawn beyond its joints it may be longer than it is drawn, as a rod that its cylinder hides.
  const int limb = home.body(i).limb;
  for (Eigen::Index k = 0; k < 3; ++k) {
    const bool below = c(k) < box.min()(k);
    const double side = box.sizes()(k), outside = below ? box.min()(k) - c(k) : c(k) - box.max()(k);
    const double drawn = of_joints.isEmpty() ? 0 : below ? of_joints.min()(k) - box.min()(k) : box.max()(k) - of_joints.max()(k);
    double allowed = (side > 0.2 * size ? 0.1 : 0.5) * size;
    if (limb > 0 && drawn > 0.1 * size) allowed = std::max(allowed, home.reach(limb));
    if (outside <= allowed) continue;
    out.push_back({"centre",
                   outside / size,
                   {{home.body(i).name},
                    fmt::format("the centre of mass lies {} outside its joints and what is drawn of it, along {}{}", length_words(outside),
                                c(k) > 0 ? "+" : "-", axis_word(k)),
                    "a part's centre of mass lies between its ends",
                    "look at its sign, its unit, and from which end it counts: weight and inertia act there"}});
    return;
  }
}

// Whether it was odd.
bool look_at_inertia(const AtHome& home, int i, std::vector<Oddity>& out) {
  const Vector3d size = size_by_inertia(home.body(i).inertia);
  Eigen::Index longest, shortest;
  const double largest = size.maxCoeff(&longest), room = room_of(home, i);
  if (!(largest > 0) || !(room > 0)) return false;
  if (largest > too_long * room) {
    out.push_back({"long",
                   largest / room,
                   {{home.body(i).name},
                    fmt::format("mass and inertia are those of a body {} long along {}, while {}", length_words(largest),
                                axis_word(longest), room_words(home, i)),
                    fmt::format("a part is at most {} times as long as what it is a part of", too_long),
                    "its length or inertia is that of a machine of another size, or in another unit"}});
    return true;
  }
  const Eigen::AlignedBox3d box = home.box(i);
  if (box.isEmpty()) return false;
  const Vector3d sides = box.sizes();
  const double side = sides.maxCoeff(&longest), drawn = home.drawn_size(i), whole = drawn > 0 ? drawn : side;
  if (largest < too_compact * whole) {
    out.push_back(
        {"compact",
         whole / largest,
         {{home.body(i).name},
          fmt::format("by its inertia all mass lies within {}, while the body is {} long", length_words(largest), length_words(side)),
          fmt::format("a part's mass spreads over more than {:.0f} % of its length", 100 * too_compact),
          "look at the unit of its inertia, kg m^2"}});
    return true;
  }
  // A rod or a plate whose inertia is that of the other: long where it is thin. Factors leave room for bodies that are drawn roughly.
  sides.minCoeff(&shortest);
  const bool exchanged = sides(shortest) < side / 3 && size(shortest) > 1.3 * size(longest);
  if (exchanged)
    out.push_back({"exchanged",
                   size(shortest) / std::max(size(longest), 1e-3 * size(shortest)),
                   {{home.body(i).name},
                    fmt::format("by its inertia it is {} long along {} and {} along {}, while it extends by {} along {} and {} along {}",
                                length_words(size(shortest)), axis_word(shortest), length_words(size(longest)), axis_word(longest),
                                length_words(sides(shortest)), axis_word(shortest), length_words(side), axis_word(longest)),
                    "mass extends most where the body does",
                    "the inertias about two of its axes, axial and transverse, may be exchanged"}});
  return exchanged;
}

void look_at_drawing(const AtHome& home, int i, std::vector<Oddity>& out) {
  const Body& b = home.body(i);
  const double drawn = home.drawn_size(i), limit = b.limb > 0 ? too_long * home.reach(b.limb) : 10 * home.span();
  if (limit > 0 && drawn > limit)
    out.push_back({"drawn",
                   drawn / limit,
                   {{b.name},
                    fmt::format("a solid {} in size is drawn, while {}", length_words(drawn),
                                b.limb > 0 ? room_words(home, i)
                                           : fmt::format("all joints of the mechanism are within {}", length_words(home.span()))),
                    "a part is drawn in proportion to what it is a part of",
                    "its length or radius may be in another unit, or that of a machine of another size"}});
  const double volume = home.drawn_volume(i), mass = b.inertia.mass;
  if (!(mass > 0) || !(volume > 0) || (mass > density.min * volume && mass < density.max * volume)) return;
  const double ratio = mass / volume;
  out.push_back({"density",
                 ratio < density.min ? density.min / ratio : ratio / density.max,
                 {{b.name},
                  fmt::format("{} kg in the volume that is drawn are {} kg/m^3", format_number(mass, 3), format_number(ratio, 2)),
                  fmt::format("a part, even if drawn too thick or thin, has between {} and {} kg/m^3", format_number(density.min, 3),
                              format_number(density.max, 3)),
                  "look at its mass, and at the unit of its radius and length"}});
}

double mass_of_limb(const AtHome& home, int limb) {
  double sum = 0;
  for (const int i : home.bodies_of(limb)) sum += home.body(i).inertia.mass;
  return sum;
}

}  // namespace

std::vector<Oddity> odd_bodies(const AtHome& home) {
  std::vector<Oddity> out;
  for (int i = 1; i < home.bodies(); ++i) {
    // The centre of a body that is far too long lies outside it too.
    if (home.body(i).inertia.mass > 0 && !look_at_inertia(home, i, out)) look_at_centre(home, i, out);
    look_at_drawing(home, i, out);
  }
  return out;
}

std::vector<Oddity> odd_masses(const AtHome& home) {
  std::vector<Oddity> out;
  const Topology& t = home.topology();
  struct Share {
    std::string name;
    double mass;
  };
  std::vector<Share> shares;
  double of_limbs = 0;
  const double platform = home.body(t.platform).inertia.mass;
  if (platform > 0) shares.push_back({home.body(t.platform).name, platform});
  for (const auto& group : home.alike())
    for (const int limb : group)
      if (const double mass = mass_of_limb(home, limb); mass > 0) {
        of_limbs += mass;
        shares.push_back({fmt::format("limb {}", limb), mass});
      }
  if (platform == 0 && of_limbs > 0)
    out.push_back({"no mass",
                   1,
                   {{home.body(t.platform).name},
                    fmt::format("the platform has no mass, while the limbs have {} kg", format_number(of_limbs, 3)),
                    "the platform, or what it carries, has a mass where the limbs have one",
                    "its weight and inertia are missing in every force"}});
  if (shares.size() < 3) return out;
  std::vector<double> masses;
  for (const Share& s : shares) masses.push_back(s.mass);
  std::nth_element(masses.begin(), masses.begin() + static_cast<std::ptrdiff_t>(masses.size() / 2), masses.end());
  const double middle = masses[masses.size() / 2];
  constexpr double most = 100;
  for (const Share& s : shares) {
    const double ratio = std::max(s.mass / middle, middle / s.mass);
    if (ratio < most) continue;
    out.push_back({"mass",
                   ratio,
                   {{s.name},
                    fmt::format("its mass is {} kg, that of most others, platform and limbs, about {} kg", format_number(s.mass, 3),
                                format_number(middle, 3)),
                    fmt::format("limbs and platform of one machine are within {:.0f} times of one another", most),
                    "a mass may be in g, or its decimal point misplaced"}});
  }
  return out;
}

}  // namespace pmreport::mechanics
