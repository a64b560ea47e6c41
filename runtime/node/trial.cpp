// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "runtime/node/trial.hpp"

#include "canopen/cia306/text/input_error.hpp"
#include "runtime/node/device.hpp"

#include <algorithm>
#include <memory>
#include <sstream>

namespace counterpoint::runtime
{
namespace
{
constexpr std::uint8_t kAnyNode = 127U;

/// A bus on which nobody is, and which takes what it gets.
class SilentBus final : public host::LiveBus
{
  public:
    [[nodiscard]] host::SendResult Send(const host::LiveFrame& frame) override
    {
        static_cast<void>(frame);
        return host::SendResult::kSent;
    }
    [[nodiscard]] bool Receive(host::LiveFrame& frame) override
    {
        static_cast<void>(frame);
        return false;
    }
    [[nodiscard]] int Descriptor() const override
    {
        return -1;
    }
    [[nodiscard]] host::BusHealth Health() const override
    {
        return {host::BusState::kActive};
    }
    [[nodiscard]] std::string Name() const override
    {
        return "none";
    }
    [[nodiscard]] bool Restart() override
    {
        return false;
    }
};

/// What the device refuses that is built and switched on with these settings.
std::vector<cia306::Finding> RefusedWith(NodeSettings settings, const cia306::Device& device)
{
    std::vector<cia306::Finding> refused;
    settings.refused = &refused;
    try
    {
        const std::uint8_t any = device.node_id.value_or(kAnyNode);
        const DeviceModel model(device.file, settings.node_id.value_or(any), SafetyNeed::kOptional);
        const bool has_second = model.ControllerCount() != 1U;
        NodePorts ports(std::make_unique<SilentBus>(), std::make_unique<SilentBus>(),
                        has_second ? std::make_unique<SilentBus>() : nullptr);
        std::ostringstream unread;
        NodeReport report(unread, ReportForm::kText, 0U);
        NodeDevice node(settings, ports, report);
        static_cast<void>(node.PowerOn({Instant{0U}, Instant{0U}}, 0U));
    }
    catch (const cia306::InputError& error)
    {
        refused.push_back({cia306::Severity::kError, error.Where(), "", error.Message()});
    }
    return refused;
}

bool IsError(const cia306::Finding& finding)
{
    return finding.severity == cia306::Severity::kError;
}
} // namespace

std::vector<cia306::Finding> TryDevice(const cia306::Device& device, const std::optional<std::uint8_t> node_id)
{
    const bool has_id = node_id || device.node_id || device.is_lss_supported;
    NodeSettings settings;
    settings.dcf = device.file;
    settings.node_id = has_id ? node_id : std::optional(kAnyNode);
    settings.has_self_tests = false;
    std::vector<cia306::Finding> findings = RefusedWith(settings, device);
    if (std::none_of(findings.begin(), findings.end(), IsError))
    {
        // Those of this program: another one may be done in less time, so this is no error of the file.
        settings.has_self_tests = true;
        for (cia306::Finding finding : RefusedWith(settings, device))
        {
            if (IsError(finding))
            {
                finding.severity = cia306::Severity::kWarning;
                findings.push_back(finding);
            }
        }
    }
    return findings;
}
} // namespace counterpoint::runtime
