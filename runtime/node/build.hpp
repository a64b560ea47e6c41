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
/// What the command line says about a live node.
struct NodeSettings
{
    std::string dcf;
    std::optional<std::uint8_t> node_id;
    std::optional<std::uint32_t> cycle_us; ///< Instead of 5F00h:01.
    std::string store;                     ///< File of 1010h; empty: nothing is saved.
    bool has_lss{false};                   ///< LSS gives the node-ID, also where the file does not say so.
    bool has_self_tests{true};
    std::optional<std::uint8_t> lss_node_id{}; ///< Node-ID that LSS gave in this run; counts before all others.
};

/// @brief The node-ID instead of the file's: what LSS gave, else that of the command line; nothing: the file's holds. A
/// device that waits for LSS gets a placeholder. [SRS_NODE_015]
[[nodiscard]] std::optional<std::uint8_t> NodeIdOf(const NodeSettings& settings, const cia306::Device& file,
                                                   bool has_lss);
/// @brief With a second controller the inverse frames are sent and received by it. [SRS_NODE_014]
[[nodiscard]] const runtime::DeviceModel& UseControllers(runtime::DeviceModel& model, NodePorts& ports);
} // namespace counterpoint::runtime

#endif // RUNTIME_NODE_BUILD_HPP
