// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tools/manager_check.hpp"

#include "canopen/cia306/input_error.hpp"
#include "tools/manager_host.hpp"

#include <map>

namespace counterpoint::tools
{
namespace
{
using cia302::SlaveSetup;
using network::LoadedNetwork;
using network::LoadedSlave;

class Comparison
{
  public:
    Comparison(const LoadedNetwork& first, const LoadedNetwork& second) : first_(first), second_(second)
    {
    }

    std::vector<std::string> Make()
    {
        const cia302::NetworkSetup& one = first_.Setup();
        const cia302::NetworkSetup& other = second_.Setup();
        Compare("0x1F80:00", one.start_up, other.start_up);
        Compare("0x1F89:00", one.boot_time_ms, other.boot_time_ms);
        Compare("0x102A:00", one.inhibit_100us, other.inhibit_100us);
        Compare("0x1006:00", one.sync_period_us, other.sync_period_us);
        Compare("profile", static_cast<std::uint64_t>(first_.Plan().manager.profile),
                static_cast<std::uint64_t>(second_.Plan().manager.profile));
        CompareFlying();
        for (std::uint8_t node = 1U; node <= cia302::kLastNode; ++node)
        {
            const bool is_master = node == one.own.value || node == other.own.value;
            is_master ? CompareMaster(node) : CompareSlave(node);
        }
        return lines_;
    }

  private:
    void Tell(const std::string& object, const std::string& one, const std::string& other)
    {
        lines_.push_back(cia306::Printable(second_.Plan().file) + ": " + object + " is " + other + ", expected " + one +
                         " as in " + cia306::Printable(first_.Plan().file));
    }
    void Compare(const std::string& object, const std::uint64_t one, const std::uint64_t other)
    {
        if (one != other)
        {
            Tell(object, cia306::Hex(one, 1), cia306::Hex(other, 1));
        }
    }
    void CompareFlying()
    {
        if (first_.Plan().manager.flying.has_value() != second_.Plan().manager.flying.has_value())
        {
            return; // 1F80h bit 5 tells it.
        }
        const cia302::FlyingMasterTimes one = FlyingTimesOf(first_.Plan());
        const cia302::FlyingMasterTimes other = FlyingTimesOf(second_.Plan());
        Compare("0x1F90:01", one.timeout, other.timeout);
        Compare("0x1F90:02", one.delay, other.delay);
        Compare("0x1F90:04", one.priority_slot, other.priority_slot);
        Compare("0x1F90:05", one.device_slot, other.device_slot);
    }
    /// A master is no slave of itself; the other one has to know it.
    void CompareMaster(const std::uint8_t node)
    {
        const bool is_first = node == first_.Setup().own.value;
        const LoadedNetwork& knows = is_first ? second_ : first_;
        const bool are_both = first_.Setup().own.value == second_.Setup().own.value;
        if (are_both)
        {
            Tell("node-ID of the manager", "another one", std::to_string(node));
        }
        else if (knows.Find(node) == nullptr)
        {
            lines_.push_back(cia306::Printable(knows.Plan().file) + ": no node " + std::to_string(node) +
                             ", expected the other master in the network list");
        }
    }
    void CompareSlave(const std::uint8_t node)
    {
        const LoadedSlave* const one = first_.Find(node);
        const LoadedSlave* const other = second_.Find(node);
        if ((one == nullptr) != (other == nullptr))
        {
            const LoadedNetwork& lacks = (one == nullptr) ? first_ : second_;
            const LoadedNetwork& has = (one == nullptr) ? second_ : first_;
            lines_.push_back(cia306::Printable(lacks.Plan().file) + ": no node " + std::to_string(node) +
                             ", expected it as in " + cia306::Printable(has.Plan().file));
        }
        else if (one != nullptr)
        {
            CompareSetups(node, first_.Setup().slaves[node], second_.Setup().slaves[node]);
            CompareConcise(node, *one, *other);
            CompareProgram(node, *one, *other);
            CompareSafety(node, *one, *other);
        }
    }
    void CompareSetups(const std::uint8_t node, const SlaveSetup& one, const SlaveSetup& other)
    {
        const auto name = [node](const std::uint16_t index) { return cia306::ObjectName(index, node); };
        const std::string heartbeat = "heartbeat consumer (0x1016) of node " + std::to_string(node);
        Compare(name(0x1F81U), one.assignment, other.assignment);
        Compare(name(0x1F84U), one.device_type, other.device_type);
        Compare(name(0x1F85U), one.vendor_id, other.vendor_id);
        Compare(name(0x1F86U), one.product_code, other.product_code);
        Compare(name(0x1F87U), one.revision_number, other.revision_number);
        Compare(name(0x1F88U), one.serial_number, other.serial_number);
        Compare(name(0x1F8AU), one.restore_sub, other.restore_sub);
        Compare(name(0x1F55U), one.software.identification, other.software.identification);
        Compare(name(0x1F53U), one.software.date, other.software.date);
        Compare(name(0x1F54U), one.software.time, other.software.time);
        Compare(name(0x1F26U), one.configuration_date, other.configuration_date);
        Compare(name(0x1F27U), one.configuration_time, other.configuration_time);
        Compare(heartbeat, one.heartbeat.consumer_ms, other.heartbeat.consumer_ms);
        Compare("heartbeat (0x1017) of node " + std::to_string(node), one.heartbeat.producer_ms,
                other.heartbeat.producer_ms);
        Compare("arming of node " + std::to_string(node), static_cast<std::uint64_t>(one.heartbeat.arming),
                static_cast<std::uint64_t>(other.heartbeat.arming));
    }
    void CompareConcise(const std::uint8_t node, const LoadedSlave& one, const LoadedSlave& other)
    {
        if (one.concise != other.concise)
        {
            Tell(cia306::ObjectName(0x1F22U, node), std::to_string(one.concise.size()) + " bytes",
                 std::to_string(other.concise.size()) + " bytes with other contents");
        }
    }
    void CompareProgram(const std::uint8_t node, const LoadedSlave& one, const LoadedSlave& other)
    {
        if (one.program != other.program)
        {
            Tell(cia306::ObjectName(0x1F58U, node), std::to_string(one.program.size()) + " bytes",
                 std::to_string(other.program.size()) + " bytes with other contents");
        }
    }
    void CompareSafety(const std::uint8_t node, const LoadedSlave& one, const LoadedSlave& other)
    {
        std::map<std::uint32_t, std::uint32_t> values;
        for (const cia302::ExpectedObject& object : one.objects)
        {
            values[KeyOf(object.address).value] = object.value;
        }
        const std::string where = " of node " + std::to_string(node) + " (safety)";
        for (const cia302::ExpectedObject& object : other.objects)
        {
            const std::string name = cia306::ObjectName(object.address.index, object.address.sub) + where;
            const auto found = values.find(KeyOf(object.address).value);
            if (found == values.end())
            {
                Tell(name, "absent", cia306::Hex(object.value, 1));
            }
            else
            {
                Compare(name, found->second, object.value);
                values.erase(found);
            }
        }
        for (const auto& [key, value] : values)
        {
            Tell(cia306::ObjectName(static_cast<std::uint16_t>(key >> 8U), static_cast<std::uint8_t>(key & 0xFFU)) +
                     where,
                 cia306::Hex(value, 1), "absent");
        }
    }

    const LoadedNetwork& first_;
    const LoadedNetwork& second_;
    std::vector<std::string> lines_;
};
} // namespace

std::vector<std::string> DifferencesOf(const LoadedNetwork& first, const LoadedNetwork& second)
{
    return Comparison(first, second).Make();
}
} // namespace counterpoint::tools
