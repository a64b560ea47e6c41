// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "runtime/node/build.hpp"

#include "canopen/cia306/text/input_error.hpp"

#include <string>

namespace counterpoint::runtime
{
namespace
{
/// Of a device that waits for its node-ID: nobody sees it.
constexpr std::uint8_t kPlaceholder = 127U;
} // namespace

const runtime::DeviceModel& UseControllers(runtime::DeviceModel& model, NodePorts& ports)
{
    const bool has_second = ports.Inverse() != nullptr;
    if (has_second)
    {
        model.UseTwoControllers();
    }
    else if (model.ControllerCount() != 1U)
    {
        throw cia306::InputError(model.File(), 0U,
                                 {"a device with two controllers, 0x5F00:10 = 2", "--can2 for the second one"});
    }
    return model;
}

std::optional<std::uint8_t> NodeIdOf(const NodeSettings& settings, const cia306::Device& file, const bool has_lss)
{
    const std::optional<std::uint8_t> wanted = settings.lss_node_id ? settings.lss_node_id : settings.node_id;
    const bool is_waiting = has_lss && !wanted && !file.node_id;
    return is_waiting ? std::optional(kPlaceholder) : wanted;
}
} // namespace counterpoint::runtime
