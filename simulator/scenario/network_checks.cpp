// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// What does not fit together in a network with managers, and between a device and its DCF: it would do nothing, or
// hold whatever happens. What only the network files tell is checked where they are read. [SRS_MGR_157]
#include "canopen/cia306/file/device_reader.hpp"
#include "runtime/device/model.hpp"
#include "simulator/scenario/checks.hpp"
#include "simulator/scenario/names.hpp"
#include "simulator/scenario/network_names.hpp"

#include <algorithm>

namespace counterpoint::simulator
{
namespace
{
[[noreturn]] void Refuse(const Source& source, const std::string& wrong, const std::string& expected)
{
    throw YamlError(source.file, source.place, wrong, expected);
}

std::string NameOfDevice(const NodeSetup& node)
{
    return "device " + node.name;
}

/// What is asked of one device, against its DCF.
class DeviceCheck
{
  public:
    DeviceCheck(const Scenario& scenario, const NodeIndex node) : scenario_(scenario), node_(node)
    {
    }

    void Objects() const
    {
        constexpr ObjectAddress kSerial{0x1018U, 4U};
        if (Setup().serial)
        {
            RequireObject(kSerial, *Setup().serial, Setup().source);
        }
        for (const Action& action : scenario_.actions)
        {
            if (action.node != node_)
            {
                continue;
            }
            if (action.kind == ActionKind::kReplace)
            {
                RequireObject(kSerial, action.serial, action.source);
            }
            if (action.kind == ActionKind::kStore)
            {
                RequireObject(action.object, action.value, action.source);
            }
            if (action.kind == ActionKind::kAcknowledge)
            {
                RequireConsumed(action.srdo, action.source);
            }
        }
        for (const Expectation& expectation : scenario_.expectations)
        {
            if (expectation.node == node_ && expectation.kind == ExpectationKind::kOutput)
            {
                RequireConsumed(expectation.srdo, expectation.source);
            }
        }
    }

  private:
    [[nodiscard]] const NodeSetup& Setup() const
    {
        return scenario_.nodes[node_];
    }
    void RequireObject(const ObjectAddress& object, const std::uint32_t value, const Source& source) const
    {
        constexpr std::size_t kMostBits = 32U;
        const cia306::Device dcf = cia306::ReadDeviceFile(Setup().dcf);
        const cia306::Entry* const entry = dcf.Find(object.index, object.sub);
        const std::string name = ObjectText(object) + " of " + NameOfDevice(Setup());
        if (entry == nullptr)
        {
            Refuse(source, "object " + name + ", which its DCF does not have",
                   "an object of " + runtime::Shown(Setup().dcf));
        }
        const std::size_t bits = std::min<std::size_t>(entry->type.bits, kMostBits);
        if ((std::uint64_t{value} >> bits) != 0U)
        {
            Refuse(source, "value " + std::to_string(value) + " for object " + name,
                   "one of " + std::to_string(bits) + " bits");
        }
    }
    void RequireConsumed(const std::uint8_t srdo, const Source& source) const
    {
        constexpr std::uint8_t kConsumes = 2U;
        const runtime::DeviceModel model(Setup().dcf, Setup().node_id, runtime::SafetyNeed::kOptional);
        const auto is_it = [srdo](const runtime::SrdoModel& other)
        { return other.number == srdo && other.direction == kConsumes; };
        if (std::none_of(model.Srdos().begin(), model.Srdos().end(), is_it))
        {
            Refuse(source,
                   "SRDO " + std::to_string(srdo) + " of " + NameOfDevice(Setup()) + ", which has no such output",
                   "the number of an SRDO that its DCF consumes");
        }
    }

    const Scenario& scenario_;
    NodeIndex node_;
};

/// [SRS_MGR_586]
void RequireSpan(const Scenario& scenario, const Action& action)
{
    constexpr Nanoseconds kOnce = 1; // No key can say so little.
    const bool is_bus = action.kind == ActionKind::kBusOff || action.kind == ActionKind::kNoController;
    const bool is_single = action.kind == ActionKind::kSend && action.every == kOnce;
    if ((IsStorm(action.kind) || is_bus) && !is_single && action.until <= action.at)
    {
        Refuse(action.source, (action.until < action.at) ? "an end before the beginning" : "an end at the beginning",
               "a time after 'at' behind 'until'");
    }
    if (is_bus && action.until > scenario.duration)
    {
        Refuse(action.source, "an end after that of the scenario", "a time within its duration behind 'until'");
    }
}

/// What needs managers, and what is not there with them.
void RequireManagers(const Scenario& scenario)
{
    if (scenario.managers.empty() && !scenario.actions.empty())
    {
        Refuse(scenario.actions.front().source, "an event without managers", "key 'managers' with at least one");
    }
    for (const Expectation& expectation : scenario.expectations)
    {
        if (IsOfNetwork(expectation.kind) && scenario.managers.empty())
        {
            Refuse(expectation.source,
                   std::string("expectation ") + NameOf(kExpectationWords, expectation.kind) + " without managers",
                   "key 'managers' with at least one");
        }
        if (IsOfEvents(expectation.kind) && expectation.from > expectation.at)
        {
            Refuse(expectation.source, "a window that ends before it begins", "'from' before 'until'");
        }
    }
    for (const NodeSetup& node : scenario.nodes)
    {
        if (scenario.managers.empty() && node.serial)
        {
            Refuse(node.source, "a serial number without managers", "key 'managers' with at least one");
        }
    }
}
} // namespace

void RequireNetwork(const Scenario& scenario)
{
    RequireManagers(scenario);
    if (scenario.managers.empty())
    {
        return;
    }
    for (const Action& action : scenario.actions)
    {
        RequireSpan(scenario, action);
    }
    for (NodeIndex node = 0U; node < scenario.nodes.size(); ++node)
    {
        DeviceCheck(scenario, node).Objects();
    }
}
} // namespace counterpoint::simulator
