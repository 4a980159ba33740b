// Sections of the gantry (tests/given/gantry.hpp), of which every reaction can be worked out by hand.
#pragma once

#include <catch2/catch.hpp>

#include <core/scenario/loaded.hpp>
#include <reports/section/kinds.hpp>
#include <tests/given/gantry.hpp>
#include <tests/given/only.hpp>
#include <tests/section/report_words.hpp>

#include <string>

namespace gantry {

inline scenario::MechanismSource source() { return test::only(table()); }

// x = 50 mm sin(pi t / s) over 2 s in steps of 0.1 s: the largest acceleration, 0.05 pi^2 m/s^2, at 0.5 and 1.5 s.
struct Run {
  explicit Run(const std::string& more)
      : loaded(scenario::load_text("title = \"Gantry\"\n[mechanism]\nuse = \"gantry\"\n[motion]\nduration = \"2 s\"\nsamples = 21\n"
                                   "x = \"50 mm * sin(2*pi*t/2 s)\"\n" +
                                       more,
                                   "a.toml", source(), section::kinds())),
        analysis(loaded.scenario, loaded.trajectory, *loaded.machine, analysis::asked_by(loaded.scenario), {}) {}
  scenario::Loaded loaded;
  section::Analysis analysis;
};

using report_words::check_proofs, report_words::text_of, report_words::value;

}  // namespace gantry
