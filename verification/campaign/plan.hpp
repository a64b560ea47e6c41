// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_CAMPAIGN_PLAN_HPP
#define VERIFICATION_CAMPAIGN_PLAN_HPP

#include "runtime/yaml/document.hpp"
#include "runtime/yaml/value.hpp"
#include "verification/campaign/device.hpp"
#include "verification/campaign/outcome.hpp"
#include "verification/campaign/surroundings.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace counterpoint::campaign
{
/// What goes wrong. Which of them a part can have: KindsOf. [SRS_CMG_003]
enum class FaultKind : std::uint8_t
{
    kFlip = 0U,     ///< Of a bit: once.
    kStuckAt0 = 1U, ///< From then on, at each phase of each cycle.
    kStuckAt1 = 2U,
    kIntermittent = 3U, ///< Flips again and again at the same phase, some cycles apart.
    kLost = 4U,         ///< Of a frame: so many from this one on. [SRS_CMG_020]
    kRepeated = 5U,     ///< Comes again, later.
    kInserted = 6U,     ///< One with its identifier and drawn data, later.
    kWrongOrder = 7U,   ///< Changes places with a later one.
    kDelayed = 8U,
    kCorrupted = 9U,    ///< One bit of its data.
    kWrongLength = 10U, ///< Each other length.
    kWrongIdentifier =
        11U,             ///< Each other identifier that differs in a bit, or is another SRDO's; other kinds of frames.
    kPairRepeated = 12U, ///< Of a complete pair: comes again, later. [SRS_CMG_021]
    kPairDelayed = 13U,
    kPairForged = 14U, ///< A valid one with drawn data, later.
    kSkipped = 15U,    ///< Of a call, a step or a cycle. [SRS_CMG_022, SRS_CMG_560, SRS_CMG_561]
    kDoubled = 16U,
    kReordered = 17U, ///< Comes behind the next one.
    kLate = 18U,      ///< Of a call: comes with the next cycle. Of a step: behind the next one. Of a cycle: by a time.
    kEarly = 19U,     ///< Of a cycle: by a time.
    kStopped = 20U,   ///< Of one counter, or both. [SRS_CMG_023]
    kFast = 21U,
    kSlow = 22U,
    kJump = 23U,
    kWrongCommand = 24U, ///< Another one instead. [SRS_CMG_029]
};
constexpr std::size_t kFaultKindCount = 25U;

/// A member of the device under test, or one byte of it.
struct Member
{
    std::string name;
    std::optional<std::size_t> byte;
    runtime::Source source;
};

/// A cause that one channel has to report by itself.
struct Voice
{
    std::string name; ///< As channel_b.srvt.
    std::uint8_t mark{0U};
    SrdoCause cause{SrdoCause::kNone};
};

/// Findings that a mechanism outside of the device answers for, by their place. [SRS_CMG_046]
struct Known
{
    std::string place; ///< A member, a byte of it or a bit: comparator.verdict+8.0; what is no memory: as it is told.
    std::string reason;
    std::optional<Class> result{}; ///< Of these alone; kDetected: late ones.
    runtime::Source source{};      ///< Where the place is named.
};

constexpr runtime::Nanoseconds kUsualReach = 60 * runtime::kNanosecondsPerMillisecond;

/// A campaign as its file says. [SRS_CMG_004]
struct Plan
{
    std::string file;
    std::string title;
    std::string scenario; ///< Path, usable from here.
    runtime::YamlNode device_node;
    std::vector<runtime::Nanoseconds> at;
    runtime::Source at_source;
    std::uint32_t cycles{1U}; ///< Consecutive cycles from each instant.
    std::vector<Phase> phases;
    std::vector<Part> parts;
    std::vector<runtime::Source> part_sources; ///< Where they are named; empty: all of memory, by default.
    std::vector<Member> members;               ///< Of these parts; none: all.
    std::vector<FaultKind> kinds;
    std::vector<runtime::Source> kind_sources; ///< Where they are named; empty: all.
    std::vector<Detector> detectors;           ///< That have to find something.
    std::uint64_t seed{1U};
    std::uint64_t sample{0U};                ///< Of each part and kind; 0: all.
    runtime::Nanoseconds reach{kUsualReach}; ///< How far faults of frames and cycles move in time.
    std::uint32_t confidence_percent{99U};
    OutputKind output{OutputKind::kGate};
    bool has_self_test{false}; ///< The device has the shipped self tests.
    std::vector<Known> known;
    std::vector<Voice> voices; ///< That have to say something.
    std::uint64_t digest{0U};  ///< Of the text of this file, for results that belong together.
};

/// @brief Reads a plan. Throws YamlError.
[[nodiscard]] Plan ReadPlan(const std::string& file);

/// @brief Whether a part can have faults of this kind.
[[nodiscard]] bool IsOf(Part part, FaultKind kind);

/// @brief Whether `reach` tells how far faults of this kind of this part move in time.
[[nodiscard]] bool HasReach(Part part, FaultKind kind);

/// @brief The words of a plan.
[[nodiscard]] const char* WordOf(Phase phase);
[[nodiscard]] const char* WordOf(Part part);
[[nodiscard]] const char* WordOf(FaultKind kind);
} // namespace counterpoint::campaign

#endif // VERIFICATION_CAMPAIGN_PLAN_HPP
