// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TOOLS_DEVICE_OPTIONS_HPP
#define TOOLS_DEVICE_OPTIONS_HPP

#include "canopen/cia306/file/device.hpp"
#include "canopen/cia306/text/input_error.hpp"
#include "tools/command_line/command.hpp"
#include "tools/command_line/options.hpp"

#include <cstdint>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace counterpoint::tools
{
/// The options that every command on one device file takes: FILE, --node-id, --json.
struct DeviceOptions
{
    std::string file;
    int node_id{0}; ///< 0: not given.
    bool is_json{false};

    /// Adds them to a command.
    void Describe(Options& options);
    /// The node-ID of the command line, else that of the file; nothing if neither has one.
    [[nodiscard]] std::optional<std::uint8_t> NodeId(const cia306::Device& device) const;
};

/// Findings as JSON.
[[nodiscard]] nlohmann::ordered_json ToJson(const std::vector<cia306::Finding>& findings);

/// Runs `body`. With --json an InputError is told as a JSON document too. [SRS_CLI_008]
[[nodiscard]] ExitStatus RunOnDevice(const DeviceOptions& options, const Streams& streams,
                                     const std::function<ExitStatus()>& body);
} // namespace counterpoint::tools

#endif // TOOLS_DEVICE_OPTIONS_HPP
