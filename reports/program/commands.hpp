// The commands, one a source. Each prints on standard output what it is asked for and gives the exit status; what goes wrong is thrown.
#pragma once

#include <core/host/catalog.hpp>
#include <core/scenario/loaded.hpp>
#include <reports/document/write.hpp>
#include <reports/program/command_line.hpp>

#include <string>
#include <vector>

namespace pmreport::program {

// pmreport SCENARIO: reads it, makes the report and writes it. `stop`: asked again and again, whether to give up; throws
// document::Interrupted then, and leaves an earlier report as it was.
int report(const Options& options, bool (*stop)());
int list(const Options& options);
int describe(const Options& options);
int check(const Options& options);
int new_mechanism(const Options& options);
int classify(const Options& options);
int limits(const Options& options, bool (*stop)());
int compare(const Options& options, bool (*stop)());  // scenarios among the reports are run, and leave nothing behind
int approve(const Options& options);
int many(const Options& options, bool (*stop)());  // not to be run in a worker: it runs one for each scenario
int schema(const Options& options);
int new_scenario(const Options& options);
int import_settings(const Options& options);

// Warns of plugins that were found and refused.
void tell_refused(const host::Catalog& catalog);

// A mechanism by its name, or those of a library file given by its path. Throws host::PluginError when there is none.
std::vector<const pm_mechanism*> mechanisms_named(const host::Catalog& catalog, const std::string& name);

// Where scenarios find their mechanism. `catalog` must live as long.
scenario::MechanismSource source_of(const host::Catalog& catalog);

}  // namespace pmreport::program
