// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TESTS_CANOPEN_NETWORK_PLAN_PLAN_RIG_HPP
#define TESTS_CANOPEN_NETWORK_PLAN_PLAN_RIG_HPP

#include "canopen/cia306/text/input_error.hpp"
#include "canopen/network_plan/concise_maker.hpp"
#include "canopen/network_plan/loaded_network.hpp"
#include "tests/canopen/cia306/device_text.hpp"
#include "tests/canopen/cia306/folder_of_files.hpp"
#include "verification/trace/ids/manager.hpp"
#include "verification/trace/verifies.hpp"

#include <algorithm>
#include <string>
#include <vector>

/// DCFs of a few lines, and networks of them: the manager is node 127, the slave node 5.
namespace counterpoint::network_plan::test
{
inline std::string Entry(const std::string& section, const int type, const std::string& access,
                         const std::string& values)
{
    return "[" + section + "]\nParameterName=x\nObjectType=7\nDataType=" + std::to_string(type) +
           "\nAccessType=" + access + "\n" + values + "\n\n";
}

/// An entry of an unsigned number of 32 bits with a ParameterValue.
inline std::string Number(const std::string& section, const std::string& value)
{
    return Entry(section, 7, "rw", "ParameterValue=" + value);
}

inline std::string Record(const std::string& section, const int count)
{
    return "[" + section + "]\nParameterName=x\nObjectType=9\nSubNumber=" + std::to_string(count) + "\n\n";
}

/// "1017:00=64 00" for each entry.
inline std::vector<std::string> TextsOf(const std::vector<ConciseEntry>& entries)
{
    std::vector<std::string> texts;
    for (const ConciseEntry& entry : entries)
    {
        std::string text = cia306::Hex(entry.index, 4).substr(2U) + ":" + cia306::Hex(entry.sub, 2).substr(2U) + "=";
        for (const std::uint8_t byte : entry.value)
        {
            text += (text.back() == '=' ? "" : " ") + cia306::Hex(byte, 2).substr(2U);
        }
        texts.push_back(text);
    }
    return texts;
}

class PlanTest : public cia306::test::FolderTest
{
  protected:
    /// A network of the manager and of node 5 with this DCF; no DCF where it is empty.
    [[nodiscard]] NetworkPlan PlanOf(const std::string& dcf) const
    {
        NetworkPlan plan;
        plan.file = "net.yaml";
        plan.manager.node = std::uint8_t{127U};
        plan.manager.place = {1U, 1U};
        plan.slaves.push_back(SlaveOf(5U, dcf));
        return plan;
    }
    [[nodiscard]] SlavePlan SlaveOf(const std::uint8_t node, const std::string& dcf) const
    {
        SlavePlan slave;
        slave.node = node;
        slave.place = {2U, 1U};
        slave.dcf = dcf.empty() ? "" : File("slave" + std::to_string(node) + ".dcf", dcf);
        return slave;
    }
    [[nodiscard]] static std::string RefusalOf(const NetworkPlan& plan)
    {
        try
        {
            const LoadedNetwork network(plan);
        }
        catch (const cia306::InputError& error)
        {
            return error.what();
        }
        return "";
    }
    /// But for what is told of files that list none of their objects.
    [[nodiscard]] static std::vector<std::string> WarningsOf(const NetworkPlan& plan)
    {
        std::vector<std::string> told = LoadedNetwork(plan).Warnings();
        const auto is_of_lists = [](const std::string& text)
        {
            return text.find(" is in none of the lists ") != std::string::npos ||
                   text.find(": SubNumber is ") != std::string::npos;
        };
        told.erase(std::remove_if(told.begin(), told.end(), is_of_lists), told.end());
        return told;
    }
};
} // namespace counterpoint::network_plan::test

#endif // TESTS_CANOPEN_NETWORK_PLAN_PLAN_RIG_HPP
