// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tools/device_options.hpp"

#include "runtime/console/json_text.hpp"

#include <ostream>

namespace counterpoint::tools
{
namespace
{
constexpr int kMaxNodeId = 127;
}

void DeviceOptions::Describe(Options& options)
{
    options.Add("FILE", &file, "EDS or DCF file").Required().Type("").Check(ProblemOfFileName);
    options.Add("--node-id", &node_id, "Node-ID for $NODEID (default: the one in the file)").Range(1, kMaxNodeId);
    options.Add("--json", &is_json, "Answer as one JSON document");
}

std::optional<std::uint8_t> DeviceOptions::NodeId(const cia306::Device& device) const
{
    return node_id == 0 ? device.node_id : std::optional(static_cast<std::uint8_t>(node_id));
}

nlohmann::ordered_json ToJson(const std::vector<cia306::Finding>& findings)
{
    nlohmann::ordered_json rows = nlohmann::ordered_json::array();
    for (const cia306::Finding& finding : findings)
    {
        rows.push_back({{"severity", finding.severity == cia306::Severity::kError ? "error" : "warning"},
                        {"line", finding.place.line},
                        {"column", finding.place.column},
                        {"object", finding.object},
                        {"message", finding.text}});
    }
    return rows;
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
            const nlohmann::ordered_json answer{{"format", "counterpoint-error-1"},
                                                {"error",
                                                 {{"file", error.File()},
                                                  {"line", error.Where().line},
                                                  {"column", error.Where().column},
                                                  {"message", error.Message()}}}};
            streams.out << runtime::JsonText(answer);
        }
        throw;
    }
}
} // namespace counterpoint::tools
