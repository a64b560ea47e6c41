// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/network_plan/loaded_network.hpp"

#include "canopen/cia306/text/input_error.hpp"

#include <limits>
#include <set>

namespace counterpoint::network_plan
{
namespace
{
using cia306::Device;
using cia306::Entry;

constexpr std::uint16_t kStartUp = 0x1F80U;
constexpr std::uint16_t kAssignment = 0x1F81U;
constexpr std::uint32_t kNodeShift = 16U;
constexpr std::uint32_t kReservedShift = 24U;
constexpr std::uint32_t kLowHalf = 0xFFFFU;

/// Object of the manager with a sub-index a node, and the part of the plan it is for.
struct PerNode
{
    std::uint16_t index;
    std::optional<std::uint32_t> SlavePlan::* part;
};
constexpr PerNode kPerNode[] = {{kAssignment, &SlavePlan::assignment}, {0x1F84U, &SlavePlan::device_type},
                                {0x1F85U, &SlavePlan::vendor_id},      {0x1F86U, &SlavePlan::product_code},
                                {0x1F87U, &SlavePlan::revision},       {0x1F88U, &SlavePlan::serial},
                                {0x1F26U, &SlavePlan::date},           {0x1F27U, &SlavePlan::time}};

struct PerFlying
{
    std::uint8_t sub;
    std::optional<std::uint16_t> FlyingPlan::* part;
    std::uint64_t greatest;
};
constexpr PerFlying kPerFlying[] = {{1U, &FlyingPlan::timeout_ms, kLowHalf},
                                    {2U, &FlyingPlan::delay_ms, kLowHalf},
                                    {3U, &FlyingPlan::priority, cia302::kLowestPriority},
                                    {4U, &FlyingPlan::level_slot_ms, kLowHalf},
                                    {5U, &FlyingPlan::node_slot_ms, kLowHalf},
                                    {6U, &FlyingPlan::detect_ms, kLowHalf}};

class Taker
{
  public:
    Taker(const Device& device, NetworkPlan& plan) : device_(device), plan_(plan)
    {
    }

    void Take()
    {
        TakeStartUp();
        Set(plan_.manager.boot_time_ms, 0x1F89U, 0U);
        Set(plan_.manager.inhibit_100us, 0x102AU, 0U);
        Set(plan_.manager.sync_us, 0x1006U, 0U);
        Set(plan_.manager.heartbeat_ms, 0x1017U, 0U);
        TakeFlying();
        for (SlavePlan& slave : plan_.slaves)
        {
            const bool is_assigned = slave.assignment.has_value();
            for (const PerNode& row : kPerNode)
            {
                Set(slave.*row.part, row.index, slave.node);
            }
            RequireListed(slave, is_assigned);
            Set(slave.restore_sub, 0x1F8AU, slave.node);
        }
        TakeConsumers();
    }

  private:
    /// Bits without bit 0 are of a slave that is in no network; 0 says nothing.
    void RequireListed(const SlavePlan& slave, const bool is_of_file) const
    {
        const std::uint32_t bits = slave.assignment.value_or(0U);
        if (!is_of_file && bits != 0U && (bits & cia302::kInNetwork) == 0U)
        {
            throw cia306::InputError(
                device_.file, device_.Find(kAssignment, slave.node)->ValuePlace(),
                {cia306::ObjectName(kAssignment, slave.node) + ": " + cia306::Hex(bits, 1),
                 "bit 0 (in the network), as node " + std::to_string(slave.node) + " is, or 0 for the usual bits"});
        }
    }
    /// A manager cannot be no NMT master, and not all that the bits above 6 may once mean.
    void TakeStartUp()
    {
        const bool is_given = plan_.manager.start_up.has_value();
        Set(plan_.manager.start_up, kStartUp, 0U);
        const std::uint32_t bits = plan_.manager.start_up.value_or(cia302::kIsMaster);
        const bool is_wrong = (bits & cia302::kIsMaster) == 0U || (bits & ~cia302::kKnownStartUpBits) != 0U;
        if (!is_given && is_wrong)
        {
            throw cia306::InputError(device_.file, device_.Find(kStartUp, 0U)->ValuePlace(),
                                     {cia306::ObjectName(kStartUp, 0U) + ": " + cia306::Hex(bits, 1),
                                      "bit 0 (NMT master), and of the others bits 1 to 6 alone"});
        }
    }
    /// 1F80h, or the network file, decides whether it is one: an object dictionary may have 1F90h unused.
    void TakeFlying()
    {
        const bool is_asked = (plan_.manager.start_up.value_or(0U) & cia302::kFlyingMaster) != 0U;
        if (is_asked && !plan_.manager.flying)
        {
            plan_.manager.flying = FlyingPlan{};
        }
        for (const PerFlying& row : kPerFlying)
        {
            if (plan_.manager.flying)
            {
                Set(*plan_.manager.flying.*row.part, cia302::kFlyingMasterIndex, row.sub, row.greatest);
            }
        }
    }
    template <typename Number>
    void Set(std::optional<Number>& part, const std::uint16_t index, const std::uint8_t sub,
             const std::uint64_t greatest = std::numeric_limits<Number>::max()) const
    {
        const std::optional<std::uint64_t> value = NumberAt(index, sub);
        if (!part && value && *value > greatest)
        {
            throw cia306::InputError(device_.file, device_.Find(index, sub)->ValuePlace(),
                                     {cia306::ObjectName(index, sub) + ": " + cia306::Hex(*value, 1),
                                      "at most " + cia306::Hex(greatest, 1)});
        }
        if (!part && value)
        {
            part = static_cast<Number>(*value);
        }
    }
    [[nodiscard]] std::optional<std::uint64_t> NumberAt(const std::uint16_t index, const std::uint8_t sub) const
    {
        const Entry* const entry = device_.Find(index, sub);
        const std::optional<cia306::Value> value =
            (entry == nullptr) ? std::nullopt : cia306::UsableValue(device_.file, *entry, plan_.manager.node);
        return value ? std::optional<std::uint64_t>(value->bits) : std::nullopt;
    }
    /// 1016h: node-ID and time stand in the value, whatever the sub-index.
    void TakeConsumers()
    {
        constexpr std::uint16_t kConsumers = 0x1016U;
        const cia306::Object* const object = device_.Find(kConsumers);
        if (object == nullptr)
        {
            return;
        }
        std::set<std::uint64_t> seen;
        for (const auto& [sub, entry] : object->entries)
        {
            const std::uint64_t value = (sub == 0U) ? 0U : NumberAt(kConsumers, sub).value_or(0U);
            const std::uint64_t node = value >> kNodeShift;
            const bool is_on = (value & kLowHalf) != 0U && node != 0U && node <= cia302::kLastNode;
            if ((value >> kReservedShift) != 0U || (is_on && !seen.insert(node).second))
            {
                throw cia306::InputError(
                    device_.file, entry.ValuePlace(),
                    {cia306::ObjectName(kConsumers, sub) + ": " + cia306::Hex(value, 8),
                     "each node-ID in one entry, in bits 16 to 23, and a time in ms in bits 0 to 15"});
            }
            for (SlavePlan& slave : plan_.slaves)
            {
                const bool is_its = node == slave.node;
                slave.consumer_ms = (is_its && !slave.consumer_ms)
                                        ? std::optional(static_cast<std::uint16_t>(value & kLowHalf))
                                        : slave.consumer_ms;
            }
        }
    }

    const Device& device_;
    NetworkPlan& plan_;
};
} // namespace

void TakeManagerObjects(const Device& device, NetworkPlan& plan)
{
    Taker(device, plan).Take();
}
} // namespace counterpoint::network_plan
