// What a figure shows, told in words and numbers, for those who do not see it.
#pragma once

#include <reports/figure/figure.hpp>

#include <string>
#include <vector>

namespace pmreport::document {

struct PanelWords {
  std::string heading;             // "(a) limb lengths: limb length [mm] against time [s], from 0 to 2"
  std::vector<std::string> lines;  // one a curve, with its least and greatest values and where they are; one a shading, a limit, a map
};

// One a panel. Numbers have four digits and the units of the axes: the data behind the figure have them all.
std::vector<PanelWords> words_of(const figure::Figure& figure);

// "Plot of limb lengths, limb rates": what a drawing is called where its name must be short.
std::string name_of(const figure::Figure& figure);

// The label of a curve; where it has none, that of the curve of another panel which looks the same, for a figure whose panels are alike has
// its legend once. Empty where there is none either.
std::string curve_name(const figure::Figure& figure, std::size_t panel, std::size_t series);

}  // namespace pmreport::document
