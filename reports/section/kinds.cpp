#include <reports/section/kinds.hpp>

namespace pmreport::section {

// The one list. A kind NAME is a folder beside this file with `const SectionKind& NAME_kind()` in it, and a line here.
#define PMREPORT_SECTION_KINDS(KIND) \
  KIND(mechanism)                    \
  KIND(snapshots)                    \
  KIND(displacement)                 \
  KIND(velocity)                     \
  KIND(acceleration)                 \
  KIND(statics)                      \
  KIND(dynamics)                     \
  KIND(drives)                       \
  KIND(reactions)                    \
  KIND(stiffness)                    \
  KIND(speed)                        \
  KIND(mobility)                     \
  KIND(singularity)                  \
  KIND(transmission)                 \
  KIND(assembly)                     \
  KIND(workspace)                    \
  KIND(study)                        \
  KIND(comparison)                   \
  KIND(classification)

#define PMREPORT_DECLARED(name) const SectionKind& name##_kind();
PMREPORT_SECTION_KINDS(PMREPORT_DECLARED)
#undef PMREPORT_DECLARED

scenario::Kinds kinds() {
#define PMREPORT_LISTED(name) &name##_kind(),
  static const scenario::SectionKind* const all[] = {PMREPORT_SECTION_KINDS(PMREPORT_LISTED)};
#undef PMREPORT_LISTED
  return all;
}

const SectionKind& kind_of(const scenario::Section& section) { return static_cast<const SectionKind&>(*section.kind); }

}  // namespace pmreport::section
