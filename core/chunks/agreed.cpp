#include <core/chunks/agreed.hpp>

#include <utility>

namespace pmreport::chunks {

bool agreed(const Sharing& sharing, std::string name, std::uint64_t meaning, const std::function<bool()>& decide, const Watch& watch) {
  if (sharing.dealer == nullptr) return decide();
  const Work work{std::move(name), meaning, 1, true};
  bool yes = false;
  Watch only_stops;
  only_stops.stop_if_asked = watch.stop_if_asked;
  run(
      work, sharing,
      [&](std::size_t) {
        Writer w;
        w.put(decide());
        return w.take();
      },
      [&](std::size_t, std::span<const std::byte> answers) {
        Reader r(answers);
        r.get(yes);
        r.end();
      },
      only_stops);
  return yes;
}

}  // namespace pmreport::chunks
