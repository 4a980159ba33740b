#include <core/analysis/design/judge_all.hpp>

#include <fmt/format.h>

namespace pmreport::analysis {

namespace {

chunks::Bytes bytes_of(const Judged& j) {
  chunks::Writer w;
  w.put(std::uint64_t{j.numbers.size()});
  for (const Bracketed& b : j.numbers)
    for (const double x : {b.value, b.low, b.high, b.resolution}) w.put(x);
  w.put(j.why);
  w.put(std::uint64_t{j.notes.size()});
  for (const std::string& note : j.notes) w.put(note);
  w.put(j.cut_off);
  return w.take();
}

Judged judged_of(std::span<const std::byte> bytes) {
  chunks::Reader r(bytes);
  Judged out;
  std::uint64_t numbers = 0, notes = 0;
  for (r.get(numbers); out.numbers.size() < numbers;) {
    Bracketed b;
    for (double* x : {&b.value, &b.low, &b.high, &b.resolution}) r.get(*x);
    out.numbers.push_back(b);
  }
  r.get(out.why);
  for (r.get(notes); out.notes.size() < notes;) r.get(out.notes.emplace_back());
  r.get(out.cut_off);
  r.end();
  return out;
}

}  // namespace

std::vector<Judged> judge_all(chunks::Work work, std::size_t count, const std::function<Judged(std::size_t)>& judge,
                              const Progress& progress) {
  std::vector<Judged> out(count);
  work.count = count;
  std::size_t done = 0;
  chunks::run(
      work, progress.sharing, [&](std::size_t k) { return bytes_of(judge(k)); },
      [&](std::size_t k, std::span<const std::byte> answers) {
        out[k] = judged_of(answers);
        progress.say(fmt::format("{} of {} variants", ++done, count));
      },
      {[](double) {}, progress.stop_if_asked});
  return out;
}

}  // namespace pmreport::analysis
