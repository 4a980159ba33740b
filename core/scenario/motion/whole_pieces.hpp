// What a curve does in each of its pieces as a whole, and in any number of neighbouring ones.
#pragma once

#include <array>
#include <core/scenario/expression/hulls.hpp>
#include <functional>
#include <memory>
#include <mutex>
#include <pmreport/jet.hpp>

namespace pmreport::scenario {

// Asked of the curve when a span first holds many pieces; shared by its copies. Safe in threads.
class WholePieces {
 public:
  // Of pieces first to last, first <= last, of `count`.
  Jet<program::Bounds> of(std::size_t first, std::size_t last, std::size_t count,
                          const std::function<Jet<program::Bounds>(std::size_t)>& piece) const {
    std::call_once(table_->once, [&] {
      std::array<std::vector<program::Bounds>, 3> rows;
      for (std::size_t i = 0; i < count; ++i) {
        const Jet<program::Bounds> x = piece(i);
        rows[0].push_back(x.value), rows[1].push_back(x.rate), rows[2].push_back(x.acceleration);
      }
      for (std::size_t k = 0; k < 3; ++k) table_->hulls[k] = Hulls(rows[k]);
    });
    const auto& h = table_->hulls;
    return {h[0].of(first, last), h[1].of(first, last), h[2].of(first, last)};
  }

 private:
  struct Table {
    std::once_flag once;
    std::array<Hulls, 3> hulls;  // of value, rate, acceleration
  };
  std::shared_ptr<Table> table_ = std::make_shared<Table>();
};

}  // namespace pmreport::scenario
