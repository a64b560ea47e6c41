// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// What a network scenario asks of a device, against its DCF: what is not there would stay as it is, whatever happens.
#include "canopen/cia306/file/device_reader.hpp"
#include "canopen/cia306/text/input_error.hpp"
#include "runtime/device/model.hpp"
#include "simulator/networks/scenario.hpp"

#include <algorithm>

namespace counterpoint::simulator
{
namespace
{

class DeviceCheck
{
  public:
    DeviceCheck(const NetworkScenario& scenario, const ScenarioDevice& device) : scenario_(scenario), device_(device)
    {
    }

    void Serial() const
    {
        constexpr ObjectAddress kSerial{0x1018U, 4U};
        if (device_.serial)
        {
            RequireObject(kSerial, *device_.serial, device_.place);
        }
        for (const NetworkAction& action : scenario_.actions)
        {
            if (action.node == device_.node && action.kind == NetworkActionKind::kReplace)
            {
                RequireObject(kSerial, action.serial, action.place);
            }
        }
    }
    void Stores() const
    {
        for (const NetworkAction& action : scenario_.actions)
        {
            if (action.node == device_.node && action.kind == NetworkActionKind::kStore)
            {
                RequireObject(action.object, action.value, action.place);
            }
        }
    }
    void Srdos() const
    {
        for (const NetworkAction& action : scenario_.actions)
        {
            if (action.node == device_.node && action.kind == NetworkActionKind::kAcknowledge)
            {
                RequireConsumed(action.srdo, action.place);
            }
        }
        for (const NetworkExpectation& expectation : scenario_.expectations)
        {
            if (expectation.node == device_.node && expectation.kind == NetworkExpectationKind::kOutput)
            {
                RequireConsumed(expectation.srdo, expectation.place);
            }
        }
    }

  private:
    void RequireObject(const ObjectAddress& object, const std::uint32_t value, const Place& place) const
    {
        constexpr std::size_t kMostBits = 32U;
        const cia306::Device dcf = cia306::ReadDeviceFile(device_.dcf);
        const cia306::Entry* const entry = dcf.Find(object.index, object.sub);
        const std::string name =
            cia306::ObjectName(object.index, object.sub) + " of device " + std::to_string(device_.node);
        if (entry == nullptr)
        {
            throw YamlError(scenario_.file, place, "object " + name + ", which its DCF does not have",
                            "an object of " + runtime::Shown(device_.dcf));
        }
        const std::size_t bits = std::min<std::size_t>(entry->type.bits, kMostBits);
        if ((std::uint64_t{value} >> bits) != 0U)
        {
            throw YamlError(scenario_.file, place, "value " + std::to_string(value) + " for object " + name,
                            "one of " + std::to_string(bits) + " bits");
        }
    }
    void RequireConsumed(const std::uint8_t srdo, const Place& place) const
    {
        constexpr std::uint8_t kConsumes = 2U;
        const runtime::DeviceModel model(device_.dcf, device_.node, runtime::SafetyNeed::kOptional);
        const auto is_it = [srdo](const runtime::SrdoModel& other)
        { return other.number == srdo && other.direction == kConsumes; };
        if (std::none_of(model.Srdos().begin(), model.Srdos().end(), is_it))
        {
            throw YamlError(scenario_.file, place,
                            "SRDO " + std::to_string(srdo) + " of device " + std::to_string(device_.node) +
                                ", which has no such output",
                            "the number of an SRDO that its DCF consumes");
        }
    }

    const NetworkScenario& scenario_;
    const ScenarioDevice& device_;
};
} // namespace

void RequireObjects(const NetworkScenario& scenario, const ScenarioDevice& device)
{
    const DeviceCheck check(scenario, device);
    check.Serial();
    check.Stores();
    check.Srdos();
}
} // namespace counterpoint::simulator
