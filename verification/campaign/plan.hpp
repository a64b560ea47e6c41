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
/// How a bit goes wrong. [SRS_CMG_003]
enum class FaultKind : std::uint8_t
{
    kFlip = 0U,     ///< Once.
    kStuckAt0 = 1U, ///< From then on, at each phase of each cycle.
    kStuckAt1 = 2U,
    kIntermittent = 3U, ///< Flips again and again at the same phase, some cycles apart.
};
constexpr std::size_t kFaultKindCount = 4U;

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
    std::string place; ///< A member, a byte of it or a bit: comparator.verdict+8.0.
    std::string reason;
};

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
    std::vector<Member> members; ///< Of these parts; none: all.
    std::vector<FaultKind> kinds;
    std::vector<Detector> detectors; ///< That have to find something.
    std::uint64_t seed{1U};
    std::uint64_t sample{0U}; ///< Of each part and kind; 0: all.
    std::uint32_t confidence_percent{99U};
    OutputKind output{OutputKind::kGate};
    std::vector<Known> known;
    std::vector<Voice> voices; ///< That have to say something.
    std::uint64_t digest{0U};  ///< Of the text of this file, for results that belong together.
};

/// @brief Reads a plan. Throws YamlError.
[[nodiscard]] Plan ReadPlan(const std::string& file);

/// @brief The words of a plan.
[[nodiscard]] const char* WordOf(Phase phase);
[[nodiscard]] const char* WordOf(Part part);
[[nodiscard]] const char* WordOf(FaultKind kind);
} // namespace counterpoint::campaign

#endif // VERIFICATION_CAMPAIGN_PLAN_HPP
