// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SIMULATOR_JUDGE_VERDICTS_HPP
#define SIMULATOR_JUDGE_VERDICTS_HPP

#include "simulator/journal/journal.hpp"
#include "simulator/scenario/scenario.hpp"
#include "simulator/world/network.hpp"

#include <optional>
#include <string>
#include <vector>

namespace counterpoint::simulator
{
/// Who found first that something is wrong at a node, by what, and when.
struct Detection
{
    Party party{Party::kNobody};
    std::string cause; ///< A word of the scenario format, such as sct or disagreement.
    Nanoseconds at{-1};
    std::uint8_t srdo{0U}; ///< 0: the whole device.

    /// @brief Whether the same party found the same thing, of the same SRDO.
    [[nodiscard]] bool IsLike(const Detection& other) const noexcept
    {
        return party == other.party && cause == other.cause && srdo == other.srdo;
    }
};
/// @brief As people read it: "channels (sct)".
[[nodiscard]] std::string DetectionText(const Detection& detection);

/// In place of a limit: there is none by the times of the device.
constexpr Nanoseconds kNoLimit{-1};
/// @brief A limit as people read it: "53 ms" or "none".
[[nodiscard]] std::string LimitText(Nanoseconds limit);

/// Time from the first effect of a fault to the safe output of one SRDO, and its limit. [SRS_SIM_031,
/// SRS_SIM_213, SRS_SIM_217]
struct Measurement
{
    std::size_t fault{0U};
    NodeIndex node{kNoNode};
    std::string place; ///< Name of the node, or of a device whose two outputs are in series.
    std::uint8_t srdo{0U};
    FaultClass fault_class{FaultClass::kInvalid};
    Nanoseconds effect{-1};    ///< When the fault first changed something; -1: never.
    Nanoseconds reference{-1}; ///< What the limit counts from.
    Nanoseconds closed{-1};    ///< When the output stage closed; -1: never.
    Nanoseconds elapsed{-1};   ///< With the time that the output needs after that; -1: never safe.
    Nanoseconds limit{0};
    bool was_open{false};      ///< The output was on when the fault came.
    bool is_commanded{false};  ///< It was an NMT command, or the loss of its supply, that closed the output.
    bool is_of_another{false}; ///< It was another fault that closed the output. [SRS_SIM_068]
    Detection detection;

    /// @brief Whether the output was open before and closed, by no command, in time or late.
    [[nodiscard]] bool IsClosedByAFault() const noexcept
    {
        return was_open && !is_commanded && closed >= 0;
    }
    /// @brief Whether the output was open before and safe within the limit.
    [[nodiscard]] bool Holds() const noexcept
    {
        return was_open && !is_commanded && !is_of_another && elapsed >= 0 && elapsed <= limit;
    }
};

/// @brief What somebody stores, as people read it: "0x1301:02 = 99", with the abort code of a device that refuses it.
[[nodiscard]] std::string StoreText(const Event& event);

/// In place of an expectation's number: those that every scenario has unwritten, that each fault which is not optional
/// has an effect, and that each store is taken. [SRS_SIM_015, SRS_SIM_480]
constexpr std::size_t kOfItself = static_cast<std::size_t>(-1);

/// Whether an expectation holds, what it wanted, and what was seen.
struct ExpectationVerdict
{
    std::size_t expectation{0U}; ///< In Scenario::expectations, or kOfItself.
    bool holds{false};
    std::string wanted;
    std::string seen;
    std::optional<Measurement> measurement; ///< Of kSafeWithin.
    std::optional<Detection> detection{};   ///< Of kDetectedBy, where the fault had an effect.
    Nanoseconds effect{-1};                 ///< When that was.
};

/// @brief The verdict of each expectation after a run. `found` has, for each expectation, what managers and
/// devices said at the instant it asks for. [SRS_SIM_030]
[[nodiscard]] std::vector<ExpectationVerdict> Judge(const Scenario& scenario, const Journal& journal, Network& network,
                                                    const std::vector<std::string>& found);
/// @brief When the output of the expectation closed first at or after `from`; -1: never.
[[nodiscard]] Nanoseconds ClosedAt(const Journal& journal, const Expectation& expectation, Nanoseconds from);
/// @brief The limit of a fault at this output, kNoLimit if there is none; it is known before the run, but that of the
/// bus may become that of `bus_next_normal`.
[[nodiscard]] Nanoseconds LimitOf(const Scenario& scenario, const Expectation& expectation,
                                  const runtime::DeviceModel& model);
/// @brief Whether at that time the last command for this node took it out of OPERATIONAL, after the output of the SRDO
/// had opened. [SRS_SIM_067]
[[nodiscard]] bool IsCommanded(const Journal& journal, NodeIndex node, std::uint8_t srdo, Nanoseconds at);
/// @brief The first detection at a node at or after `from`; not what follows from a command.
[[nodiscard]] Detection DetectionAt(const Journal& journal, NodeIndex node, Nanoseconds from);
/// @brief All detections at the node of the expectation, or at the two whose outputs are in series, in the order of
/// their times: for each instant first the one that is told, then whatever else was noticed then. [SRS_SIM_073]
[[nodiscard]] std::vector<Detection> DetectionsOf(const Journal& journal, const Expectation& expectation,
                                                  Nanoseconds from);
} // namespace counterpoint::simulator

#endif // SIMULATOR_JUDGE_VERDICTS_HPP
