#include <core/scan/judge/groups.hpp>

#include <algorithm>
#include <optional>

namespace pmreport::scan {

namespace {

constexpr std::size_t kept = 2;  // where one group ends chunks of it are still at work when those of the next begin

}  // namespace

struct Groups::Prepared {
  std::once_flag once;
  std::optional<const Orientations> orientations;
};

std::shared_ptr<const Orientations> Groups::at(std::size_t group) {
  std::shared_ptr<Prepared> out;
  {
    const std::lock_guard lock(mutex_);
    auto found = std::ranges::find(last_, group, [](const auto& one) { return one.first; });
    if (found == last_.end()) {
      if (last_.size() == kept) last_.pop_back();
      found = last_.insert(last_.end(), {group, std::make_shared<Prepared>()});
    }
    std::rotate(last_.begin(), found, found + 1);
    out = last_.front().second;
  }
  // Not under the lock: others are prepared meanwhile.
  std::call_once(out->once,
                 [&] { out->orientations.emplace(plan_, first(group), std::min(most, plan_.scan.orientation_count() - first(group))); });
  return {out, &*out->orientations};
}

}  // namespace pmreport::scan
