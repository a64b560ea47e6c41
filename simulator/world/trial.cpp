// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "simulator/world/trial.hpp"

#include "runtime/yaml/document.hpp"
#include "simulator/journal/journal.hpp"
#include "simulator/world/network.hpp"
#include "simulator/world/node/parts.hpp"

namespace counterpoint::simulator
{
std::optional<cia306::Finding> TrySelfTests(const std::string& file, const std::optional<std::uint8_t> node_id)
{
    Scenario scenario;
    NodeSetup node;
    node.name = "device";
    node.device = node.name;
    node.dcf = file;
    node.node_id = node_id;
    node.start_at = kNever;
    scenario.nodes.push_back(node);
    try
    {
        Journal journal(false);
        const Network network(scenario, journal);
    }
    catch (const SelfTestMisfit& misfit)
    {
        return cia306::Finding{cia306::Severity::kWarning, misfit.Where(), "", "simulated, " + misfit.Message()};
    }
    catch (const cia306::InputError&)
    {
        return std::nullopt; // What it cannot simulate is told otherwise.
    }
    catch (const runtime::YamlError&)
    {
        return std::nullopt;
    }
    return std::nullopt;
}
} // namespace counterpoint::simulator
