#include <core/scan/proof/refined_bytes.hpp>

#include <algorithm>
#include <array>
#include <vector>

namespace pmreport::scan {

using program::Bounds;

namespace {

// Of boxes, one column after the other: whole numbers are mostly like those before.
struct Columns {
  std::vector<double> numbers;  // of each box the ends of its sides, and of its volume
  std::vector<std::uint32_t> sure, split, blind, open;
  std::vector<std::uint32_t> orientations, sets;  // of each open orientation
};

Columns columns_of(const OpenBoxes& boxes) {
  Columns c;
  for (std::size_t k = 0; k < boxes.size(); ++k) {
    for (const Bounds& side : boxes.sides(k)) c.numbers.insert(c.numbers.end(), {side.low, side.high});
    c.numbers.insert(c.numbers.end(), {boxes.volume(k).low, boxes.volume(k).high});
    const BoxState state = boxes.state(k);
    c.sure.push_back(state.sure);
    c.split.push_back(state.split);
    c.blind.push_back(state.blind ? 1 : 0);
    c.open.push_back(static_cast<std::uint32_t>(boxes.open(k).size()));
    for (const OpenOrientation& o : boxes.open(k)) {
      c.orientations.push_back(o.orientation);
      c.sets.push_back(o.set);
    }
  }
  return c;
}

void put_boxes(const OpenBoxes& boxes, chunks::Writer& w) {
  const Columns c = columns_of(boxes);
  w.put(c.numbers);
  w.put(std::uint64_t{boxes.size()});
  w.put(std::uint64_t{c.sets.size()});
  for (const auto* column : {&c.sure, &c.split, &c.blind, &c.open, &c.orientations, &c.sets})
    w.put_runs(std::span<const std::uint32_t>(*column));
}

void get_boxes(chunks::Reader& r, std::size_t orientations, std::size_t sets, std::size_t axes, OpenBoxes& out) {
  Columns c;
  std::uint64_t boxes = 0, open = 0;
  r.get(c.numbers);
  r.get(boxes);
  r.get(open);
  const std::size_t each = 2 * (axes + 1);
  if (c.numbers.size() % each != 0 || c.numbers.size() / each != boxes || open / std::max<std::size_t>(orientations, 1) > boxes)
    throw chunks::NotReadable();
  for (auto* column : {&c.sure, &c.split, &c.blind, &c.open, &c.orientations, &c.sets}) {
    column->resize(column == &c.orientations || column == &c.sets ? open : boxes);
    r.get_runs(std::span(*column));
  }
  const auto all_below = [](const std::vector<std::uint32_t>& numbers, std::size_t end) {
    return std::ranges::all_of(numbers, [&](std::uint32_t n) { return n < end; });
  };
  if (!all_below(c.split, std::size_t{1} << axes) || !all_below(c.orientations, orientations) || !all_below(c.sets, sets))
    throw chunks::NotReadable();
  std::vector<Bounds> sides(axes);
  std::vector<OpenOrientation> of_box;
  std::size_t o = 0;
  for (std::size_t k = 0; k < boxes; ++k) {
    const double* ends = &c.numbers[k * each];
    for (Bounds& side : sides) side = {ends[0], ends[1]}, ends += 2;
    if (c.open[k] > open - o) throw chunks::NotReadable();
    of_box.clear();
    for (const std::size_t end = o + c.open[k]; o < end; ++o) of_box.push_back({c.orientations[o], c.sets[o]});
    out.add(sides, {ends[0], ends[1]}, {c.sure[k], static_cast<std::uint16_t>(c.split[k]), c.blind[k] != 0}, of_box);
  }
  if (o != open) throw chunks::NotReadable();
}

template <class Ends>  // const or not
auto numbers_of(Ends& e) {
  return std::array{&e.least, &e.greatest, &e.low_at_most, &e.high_at_least};
}

}  // namespace

void put(const Refined& refined, chunks::Writer& w) {
  const MarginSets& sets = refined.examination.sets;
  w.put(refined.came_from);
  for (std::uint32_t s = 0; s < sets.size(); ++s)
    for (const std::uint64_t word : sets.bits(s)) w.put(word);
  put_boxes(refined.open, w);
  w.put(refined.filled.low);
  w.put(refined.filled.high);
  for (const Ends& e : refined.ends)
    for (const double* x : numbers_of(e)) w.put(*x);
  w.put(refined.filled_count);
  w.put(refined.boxes);
}

void get(chunks::Reader& r, std::size_t orientations, std::size_t sets, Refined& out) {
  r.get(out.came_from);
  std::vector<std::uint64_t> bits(out.examination.sets.words());
  for (std::uint32_t s = 0; s < out.came_from.size(); ++s) {
    if (out.came_from[s] >= sets && out.came_from[s] != Refined::nowhere) throw chunks::NotReadable();
    for (std::uint64_t& word : bits) r.get(word);
    if (out.examination.sets.add(bits) != s) throw chunks::NotReadable();  // each set is there once
  }
  get_boxes(r, orientations, out.came_from.size(), out.ends.size(), out.open);
  r.get(out.filled.low);
  r.get(out.filled.high);
  for (Ends& e : out.ends)
    for (double* x : numbers_of(e)) r.get(*x);
  r.get(out.filled_count);
  r.get(out.boxes);
}

}  // namespace pmreport::scan
