// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef RUNTIME_NODE_BUILD_HPP
#define RUNTIME_NODE_BUILD_HPP

#include "runtime/node/ports.hpp"

#include "canopen/cia306/file/device.hpp"
#include "runtime/device/model.hpp"

#include <cstdint>
#include <optional>
#include <string>

// How a live node is made of its file and its command line. Each may throw cia306::InputError.
namespace counterpoint::runtime
{
/// What a live node is built from.
struct NodeSettings
{
    std::string dcf;
    std::optional<std::uint8_t> node_id;
    std::optional<std::uint32_t> cycle_us; ///< Instead of 5F00h:01.
    std::string store;                     ///< File of 1010h; empty: nothing is saved.
    bool has_lss{false};                   ///< Also where the file does not say so.
    bool has_self_tests{true};
    std::optional<std::uint8_t> lss_node_id{}; ///< LSS gave it in this run: before all others.
};

/// @brief What LSS gave comes first; a device that waits for it has a placeholder. [SRS_NODE_015]
[[nodiscard]] std::optional<std::uint8_t> NodeIdOf(const NodeSettings& settings, const cia306::Device& file,
                                                   bool has_lss);
/// @brief With a second controller the inverse frames are its own. [SRS_NODE_014]
[[nodiscard]] const runtime::DeviceModel& UseControllers(runtime::DeviceModel& model, NodePorts& ports);
} // namespace counterpoint::runtime

#endif // RUNTIME_NODE_BUILD_HPP
