// Section `reactions` of an analysis, with its picture.
#pragma once

#include <reports/scene/studio.hpp>
#include <reports/section/reactions/reactions.hpp>

inline pmreport::section::Result reactions_of(const pmreport::section::Analysis& a,
                                              const pmreport::section::ReactionsOptions& request = {}) {
  pmreport::scene::Studio studio;
  return pmreport::section::reactions_section(a, request, pmreport::section::Stage(a, studio));
}
