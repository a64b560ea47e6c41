// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_TWINS_UNIT_HPP
#define VERIFICATION_TWINS_UNIT_HPP

#include <cstdint>
#include <string>
#include <vector>

/// What a signature is computed of.
struct CounterpointFields
{
    std::uint32_t direction;
    std::uint32_t sct;
    std::uint32_t srvt;
    std::uint32_t cob_ids[2];
    std::uint32_t count;
    std::uint32_t entries[17]; ///< One more than are ever mapped.
};

/// A unit that is no channel: a signature alone. What the program looks up in such a library.
extern "C" std::uint32_t CounterpointSignature(const CounterpointFields* fields);

namespace counterpoint::twins
{

/// What a signature is made of, in this order; position and entry once for each entry.
enum class Part : std::uint8_t
{
    kDirection,
    kSct,
    kSrvt,
    kCobId1,
    kCobId2,
    kCount,
    kPosition,
    kEntry,
    kNone,
};

enum class Break : std::uint8_t
{
    kLeftOut,
    kZero,
    kForgetsWhatCameBefore,
    kOneMore,
    kOneLess,
    kLowByteOnly,
};

/// A requirement mutant of the signature: the plain one, bit after bit, with one thing of its requirement broken.
struct UnitRule
{
    std::string how{};
    Part part{Part::kNone};
    Break broken{Break::kLeftOut};
    std::uint32_t start{0U};       ///< Of the register.
    std::uint32_t first_entry{0U}; ///< Entries before it are left out.
    std::uint32_t most_entries{16U};
    std::uint32_t further_entries{0U}; ///< Behind the last one.
    bool is_silent{false};             ///< The signature is always 0.
};

[[nodiscard]] std::vector<UnitRule> UnitRules();
/// @brief Everything that the unit shows of `count` drawn sets of fields, as one number; with a rule, what the plain
/// signature shows that breaks it.
[[nodiscard]] std::uint64_t DriveUnit(decltype(&CounterpointSignature) unit, std::uint32_t seed, std::uint32_t count,
                                      const UnitRule* rule);

} // namespace counterpoint::twins

#endif
