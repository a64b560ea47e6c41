// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Expectations of a network scenario, each judged at its time.
#include "simulator/networks/simulation.hpp"

#include "canopen/cia306/text/input_error.hpp"
#include "runtime/manager/report/words.hpp"

#include <algorithm>

namespace counterpoint::simulator
{
namespace
{
using Expected = NetworkExpectationKind;

constexpr std::uint64_t kNsPerUs = 1000U;

std::string NameOf(const NetworkExpectation& expectation)
{
    const std::string node = " of node " + std::to_string(expectation.node);
    switch (expectation.kind)
    {
    case Expected::kState:
        return "state" + node + " for the manager";
    case Expected::kDevice:
        return "state" + node;
    case Expected::kLetter:
        return "letter" + node;
    case Expected::kCode:
        return "code" + node;
    case Expected::kGate:
        return "gate" + node;
    case Expected::kFinding:
        return "finding" + node;
    case Expected::kOutput:
        return "output of SRDO " + std::to_string(expectation.srdo) + node;
    case Expected::kEvent:
    case Expected::kNoEvent:
        return "event" + ((expectation.node == 0U) ? std::string{} : node);
    case Expected::kActive:
        return "active master";
    case Expected::kFlying:
    default:
        return "flying master events";
    }
}

/// Numbers of the events of the flying master, in order: "3 4".
std::string FlyingEvents(const SimulatedManager& manager)
{
    std::string numbers;
    for (const runtime::ManagerEvent& event : manager.events)
    {
        if (event.kind == "flying_master")
        {
            numbers += (numbers.empty() ? "" : " ") + event.word;
        }
    }
    return numbers.empty() ? "none" : numbers;
}

/// The word of the expectation if such an event was there, else none.
std::string EventIn(const SimulatedManager& manager, const NetworkExpectation& expectation)
{
    for (const runtime::ManagerEvent& event : manager.events)
    {
        const std::uint64_t at_ns = event.at_us * kNsPerUs;
        const bool is_node = expectation.node == 0U || event.node == expectation.node;
        if (is_node && event.kind == expectation.is && at_ns >= expectation.from_ns && at_ns <= expectation.at_ns)
        {
            return event.kind;
        }
    }
    return "none";
}
} // namespace

void NetworkSimulation::Judge(const std::uint64_t now_ns)
{
    for (; next_expectation_ < expectations_.size() && expectations_[next_expectation_].at_ns <= now_ns;
         ++next_expectation_)
    {
        verdicts_.push_back(VerdictOf(expectations_[next_expectation_]));
    }
}

NetworkVerdict NetworkSimulation::VerdictOf(const NetworkExpectation& expectation)
{
    constexpr double kNsPerSecond = 1e9;
    const SimulatedManager& manager = ManagerOf(expectation.manager, expectation.place);
    const bool is_of_device = expectation.kind == Expected::kDevice || expectation.kind == Expected::kOutput;
    const std::string found = is_of_device ? FoundAtDevice(expectation) : Found(expectation, manager);
    const bool is_equal = found == expectation.is;
    NetworkVerdict verdict;
    verdict.holds = (expectation.kind == Expected::kNoEvent) ? !is_equal : is_equal;
    const std::string seconds = std::to_string(static_cast<double>(expectation.at_ns) / kNsPerSecond);
    verdict.text = scenario_.file + ":" + std::to_string(expectation.place.line) + ": " +
                   seconds.substr(0U, seconds.find('.') + 4U) + " s: " + NameOf(expectation) + " is " + found +
                   (verdict.holds                              ? ""
                    : (expectation.kind == Expected::kNoEvent) ? ", expected none"
                                                               : ", expected " + expectation.is);
    return verdict;
}

std::string NetworkSimulation::Found(const NetworkExpectation& expectation, const SimulatedManager& manager)
{
    if (manager.station == nullptr)
    {
        return "no manager yet";
    }
    const cia302::Manager& core = manager.station->Host().Core();
    const cia302::NodeId node{expectation.node};
    const cia302::NodeStatus status = core.Status(node);
    const cia302::GateFinding gate = core.Gate().Finding(node);
    const bool is_refused =
        core.Gate().State(node) == cia302::GateState::kDiffers || core.Gate().State(node) == cia302::GateState::kFailed;
    const ObjectAddress object = is_refused ? gate.object : status.object;
    const bool has_finding = is_refused || !runtime::FindingText(manager.net->Plan().manager.profile, status).empty();
    switch (expectation.kind)
    {
    case Expected::kState:
        return runtime::WordOf(core.Table().Record(node).state);
    case Expected::kLetter:
        return (status.letter == 0) ? "none" : std::string(1U, status.letter);
    case Expected::kCode:
        return std::to_string(status.code);
    case Expected::kGate:
        return runtime::WordOf(core.Gate().State(node));
    case Expected::kFinding:
        return has_finding ? cia306::ObjectName(object.index, object.sub) : "none";
    case Expected::kEvent:
    case Expected::kNoEvent:
        return EventIn(manager, expectation);
    case Expected::kActive:
        return (manager.port != nullptr && core.IsActive()) ? "true" : "false";
    case Expected::kFlying:
        return FlyingEvents(manager);
    case Expected::kDevice:
    case Expected::kOutput:
    default:
        return "unknown";
    }
}

std::string NetworkSimulation::FoundAtDevice(const NetworkExpectation& expectation)
{
    SimulatedDevice* const device = DeviceOf(expectation.node);
    if (device == nullptr)
    {
        return "absent";
    }
    if (expectation.kind == Expected::kDevice)
    {
        return runtime::WordOf(device->Device().Services().State());
    }
    const std::optional<SlotIndex> slot = device->Device().Model().SlotOf(expectation.srdo);
    const bool is_open = slot && ((device->Device().Open() >> *slot) & 1U) != 0U;
    return is_open ? "open" : "closed";
}
} // namespace counterpoint::simulator
