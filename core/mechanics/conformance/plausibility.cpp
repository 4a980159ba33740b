#include <core/mechanics/conformance/plausibility.hpp>

#include <core/mechanics/conformance/oddities.hpp>
#include <core/text/text.hpp>

#include <fmt/core.h>

#include <algorithm>

namespace pmreport::mechanics {

std::vector<Remark> plausibility(const Machine& machine) {
  const AtHome home(machine);
  std::vector<Oddity> all;
  for (const auto look : {odd_lengths, odd_layouts, odd_masses, odd_bodies})
    for (Oddity& o : look(home)) all.push_back(std::move(o));
  std::vector<Remark> out;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto same = [&](const Oddity& o) { return !o.kind.empty() && o.kind == all[i].kind; };
    if (std::any_of(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(i), same)) continue;
    const Oddity* worst = &all[i];
    std::vector<std::string> of = all[i].remark.of;
    for (std::size_t k = i + 1; k < all.size(); ++k) {
      if (!same(all[k])) continue;
      of.insert(of.end(), all[k].remark.of.begin(), all[k].remark.of.end());
      if (all[k].worst > worst->worst) worst = &all[k];
    }
    out.push_back(worst->remark);
    if (of.size() > worst->remark.of.size()) out.back().seen += fmt::format(" ({}, the worst of {})", listed(worst->remark.of), of.size());
    out.back().of = std::move(of);
  }
  return out;
}

std::string sentence(const Remark& r) {
  constexpr std::size_t most = 8;
  std::vector<std::string> names = r.of;
  if (names.size() > most) {
    names.resize(most - 2);
    names.push_back(fmt::format("{} more", r.of.size() - names.size()));
  }
  return fmt::format("{}: {}. Usually {}: {}.", listed(names), r.seen, r.usual, r.reason);
}

}  // namespace pmreport::mechanics
