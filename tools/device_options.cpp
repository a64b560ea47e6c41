// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tools/device_options.hpp"

#include "runtime/console/json_text.hpp"

#include <CLI/CLI.hpp>

#include <ostream>

namespace counterpoint::tools
{
namespace
{
constexpr int kMaxNodeId = 127;
}

void DeviceOptions::Describe(CLI::App& app)
{
    app.add_option("FILE", file, "EDS or DCF file")->required()->type_name("");
    app.add_option("--node-id", node_id, "Node-ID for $NODEID (default: the one in the file)")
        ->check(CLI::Validator(ProblemOfNumber, ""))
        ->check(CLI::Range(1, kMaxNodeId));
    app.add_flag("--json", is_json, "Answer as one JSON document");
}

std::string ProblemOfNumber(const std::string& text)
{
    const bool is_hexadecimal = text.size() > 2U && (text[1] == 'x' || text[1] == 'X');
    const bool is_octal = text.size() > 1U && text[0] == '0' && !is_hexadecimal;
    return is_octal ? text + " begins with 0, expected a decimal number, or a hexadecimal one after 0x" : std::string();
}

std::string ProblemOfFileName(const std::string& text)
{
    return text.empty() ? "an empty name, expected the name of a file" : std::string();
}

std::string ProblemOfAddress(const std::string& text)
{
    return text.empty() ? "an empty address, expected a bus such as can0" : std::string();
}

std::optional<std::uint8_t> DeviceOptions::NodeId(const cia306::Device& device) const
{
    return node_id == 0 ? device.node_id : std::optional(static_cast<std::uint8_t>(node_id));
}

ExitStatus RunOnDevice(const DeviceOptions& options, const Streams& streams, const std::function<ExitStatus()>& body)
{
    try
    {
        return body();
    }
    catch (const cia306::InputError& error)
    {
        if (options.is_json)
        {
            const nlohmann::ordered_json answer{
                {"error", {{"file", error.File()}, {"line", error.Line()}, {"message", error.Message()}}}};
            streams.out << runtime::JsonText(answer);
        }
        throw;
    }
}
} // namespace counterpoint::tools
