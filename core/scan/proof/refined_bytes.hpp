// What was found of halved boxes as bytes and back, for a proof that several processes share.
#pragma once

#include <core/chunks/bytes.hpp>
#include <core/scan/proof/refine.hpp>

#include <cstddef>

namespace pmreport::scan {

// All but the examination's answers to each question, which nobody asks for any more.
void put(const Refined& refined, chunks::Writer& w);
// Into one that is new, for as many axes and margins. Throws NotReadable; numbers of orientations and of sets that it came from are then
// known to be less than these.
void get(chunks::Reader& r, std::size_t orientations, std::size_t sets, Refined& out);

}  // namespace pmreport::scan
