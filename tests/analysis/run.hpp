// A scenario of the stage, loaded and analysed for what its sections ask.
#pragma once

#include <core/analysis/analysis.hpp>
#include <core/scenario/loaded.hpp>
#include <reports/section/kinds.hpp>
#include <tests/given/stage.hpp>

#include <string>

namespace trial {

using namespace pmreport;

struct Run {
  explicit Run(const std::string& text)
      : loaded(scenario::load_text(text, "a.toml", stage::source(), section::kinds())),
        analysis(loaded.scenario, loaded.trajectory, *loaded.machine, analysis::asked_by(loaded.scenario), {}) {}
  scenario::Loaded loaded;
  analysis::Analysis analysis;
};

// The feeler ends at 200 mm: from 1.4 s on, seven samples, it is too short.
inline const std::string feeler_too_far = R"toml(title = "Stage"
[mechanism]
use = "stage"
parameters = { arm = "200 mm", dependent = "phi" }
[motion]
duration = "2 s"
samples = 21
x = "0 mm"
y = "150 mm * t / 1 s"
[[section]]
kind = "displacement"
)toml";

}  // namespace trial
