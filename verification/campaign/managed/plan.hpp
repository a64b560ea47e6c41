// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_CAMPAIGN_MANAGED_PLAN_HPP
#define VERIFICATION_CAMPAIGN_MANAGED_PLAN_HPP

#include "runtime/yaml/value.hpp"
#include "verification/campaign/outcome.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

/// Faults of a network with managers.
namespace counterpoint::campaign::managed
{
using runtime::Nanoseconds;

constexpr Nanoseconds kStep = 50 * runtime::kNanosecondsPerMicrosecond; ///< Faults move in time by this.

/// What is hit. Frames are of a service. [SRS_CMG_071]
enum class Target : std::uint8_t
{
    kNmt = 0U,
    kSdo = 1U,
    kLife = 2U,     ///< Boot-up, heartbeat, guarding.
    kElection = 3U, ///< 071h to 076h.
    kSrdo = 4U,
    kOther = 5U,    ///< PDO, SYNC, emergency.
    kWrites = 6U,   ///< Objects of a safety configuration.
    kSlaves = 7U,   ///< Whole devices.
    kManagers = 8U, ///< Whole managers.
    kMemory = 9U,   ///< Of managers. [SRS_CMG_080]
    kClocks = 10U,  ///< Of managers. [SRS_CMG_081]
};
constexpr std::size_t kTargetCount = 11U;

/// What goes wrong with it. [SRS_CMG_071]
enum class Fault : std::uint8_t
{
    kLost = 0U,
    kRepeated = 1U, ///< Comes again, later.
    kInserted = 2U, ///< One with its identifier and drawn data, later.
    kWrongOrder = 3U,
    kDelayed = 4U,
    kCorrupted = 5U, ///< A bit of its data.
    kWrongByte = 6U, ///< Each other value of a byte.
    kWrongLength = 7U,
    kWrongIdentifier = 8U,
    kForeign = 9U,    ///< Somebody else on the bus writes the object.
    kStored = 10U,    ///< The object is another one, by no message of the bus.
    kRestarted = 11U, ///< Its supply goes, and comes back.
    kPulled = 12U,    ///< Its supply goes for good.
    kExchanged = 13U, ///< A device with another serial number stands in its place.
    kKilled = 14U,
    kBack = 15U,   ///< Killed, and comes back.
    kOffBus = 16U, ///< Its controller is not on the bus for a time.
    kFlip = 17U,
    kStopped = 18U, ///< Stands still.
    kFast = 19U,
    kSlow = 20U,
    kJump = 21U,
};
constexpr std::size_t kFaultCount = 22U;

[[nodiscard]] constexpr bool IsOfFrames(const Target target) noexcept
{
    return target < Target::kWrites;
}
[[nodiscard]] constexpr bool IsInManagers(const Target target) noexcept
{
    return target >= Target::kMemory;
}
[[nodiscard]] bool IsOf(Target target, Fault fault) noexcept;

/// Findings that somebody outside of the manager answers for, by the first words of their place.
struct Known
{
    std::string place;
    std::string reason;
};

/// Who told of a fault first. A value of Outcome::detector. [SRS_CMG_074]
enum class Teller : std::uint8_t
{
    kNobody = 0U,
    kSafetyGate = 1U,
    kStatus = 2U, ///< Letter or code of the start-up.
    kErrorControl = 3U,
    kBootUp = 4U,
    kDuplicate = 5U,
    kElection = 6U,
    kEmergency = 7U,
    kDevice = 8U,     ///< A device's kernel: a cause of an SRDO, a device fault, an invalid configuration.
    kController = 9U, ///< The manager knows that its bus was away.
    kCommand = 10U,   ///< A command of a manager that it does not give without the fault.
    kException = 11U, ///< The processor or the system ended the program of a manager.
};
constexpr std::size_t kTellerCount = 12U;

/// A plan for a network, as its file says. [SRS_CMG_070]
struct Plan
{
    std::string file;
    std::string title;
    std::string scenario;
    std::string profile; ///< Empty: the first one of the scenario.
    runtime::Source scenario_source;
    Nanoseconds from{0};
    Nanoseconds until{0}; ///< 0: the end of the scenario.
    std::vector<Target> parts;
    std::vector<runtime::Source> part_sources;
    std::vector<Fault> kinds;
    std::vector<runtime::Source> kind_sources;
    std::vector<std::string> members; ///< Of the memory of managers, whole names or their first words; empty: all.
    std::vector<runtime::Source> member_sources;
    std::vector<Teller> detectors;
    std::vector<Known> known;
    Nanoseconds reach{0};
    Nanoseconds settle{0};         ///< As without the fault for so long: it is over.
    Nanoseconds stop_within{0};    ///< A safety slave that must not run is stopped.
    Nanoseconds masters_within{0}; ///< Of two active managers one remains.
    std::uint64_t seed{1U};
    std::uint64_t sample{0U}; ///< Of each part and kind; 0: all.
    std::uint32_t confidence_percent{99U};
    std::uint64_t digest{0U};
};

/// @brief Whether a file is a plan for a network: it has the key `network`. Throws YamlError.
[[nodiscard]] bool IsManagedPlan(const std::string& file);
/// @brief Throws YamlError.
[[nodiscard]] Plan ReadManagedPlan(const std::string& file);

[[nodiscard]] const char* WordOf(Target target);
[[nodiscard]] const char* WordOf(Fault fault);
[[nodiscard]] const char* WordOf(Teller teller);
} // namespace counterpoint::campaign::managed

#endif // VERIFICATION_CAMPAIGN_MANAGED_PLAN_HPP
