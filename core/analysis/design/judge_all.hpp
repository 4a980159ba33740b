// Many variants, each a chunk of work.
#pragma once

#include <core/analysis/design/problem.hpp>
#include <core/analysis/progress.hpp>

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace pmreport::analysis {

// Of variants 0 to count - 1, in their order. `work`: its name and what decides the answers, its count left out. Throws what chunks::run
// throws.
std::vector<Judged> judge_all(chunks::Work work, std::size_t count, const std::function<Judged(std::size_t)>& judge,
                              const Progress& progress);

}  // namespace pmreport::analysis
