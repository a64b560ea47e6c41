// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia302/flying_master/compare.hpp"

#include "canopen/cia302/safety_gate/safety_check.hpp"
#include "canopen/start_up/el6751/setup.hpp"
#include "canopen/start_up/plc_designer/setup.hpp"

namespace counterpoint::cia302
{
namespace
{

constexpr std::uint32_t kNoKey = 0xFFFFFFFFU; ///< Behind every object.

constexpr std::uint32_t OrderOf(const ObjectAddress& address) noexcept
{
    return (static_cast<std::uint32_t>(address.index) << 8U) | address.sub;
}

template <typename Value> constexpr std::uint32_t NumberOf(const Value value) noexcept
{
    return static_cast<std::uint32_t>(value);
}

/// Data of a slave for the EL6751 profile, by El6751Part; the first place is not one slave's own.
struct El6751Values
{
    std::uint32_t values[kEl6751Parts];
};

El6751Values ValuesOf(const El6751Slave& slave) noexcept
{
    return El6751Values{
        {0U, NumberOf(slave.kind), NumberOf(slave.is_device_type_checked), NumberOf(slave.is_sync_period_written),
         NumberOf(slave.is_cob_id_written), NumberOf(slave.is_type_written), NumberOf(slave.is_started),
         NumberOf(slave.is_restarted_without_pdos), NumberOf(slave.is_consumer_literal), NumberOf(slave.node_reaction),
         NumberOf(slave.restart), NumberOf(slave.network_reaction), slave.life_time_factor, slave.guard_time_ms,
         slave.coupler_pdos, slave.coupler_inhibit_100us, slave.coupler_event_ms, slave.rx_count, slave.tx_count}};
}

/// The values that one object has in the two masters.
struct Pair
{
    std::uint16_t index;
    std::uint8_t sub;
    std::uint64_t first;
    std::uint64_t second;
};

/// Two masters that are compared, and where findings go.
class Comparison
{
  public:
    Comparison(const FlyingMasterView* const masters, const std::uint8_t count,
               FlyingFindingListener& listener) noexcept
        : masters_(masters), count_(count), listener_(listener), first_place_(0U), second_place_(0U),
          first_(masters[0]), second_(masters[0]), found_(0U)
    {
    }

    /// @brief What is wrong with one master by itself, by its place in the list.
    void CheckAlone(std::uint8_t place) noexcept;
    /// @brief Node-IDs that two masters have, and masters that do not list each other.
    void CheckNodes() noexcept;
    /// @brief Compares the master at this place with the first one.
    void CompareWithFirst(std::uint8_t place) noexcept;
    /// @brief How many findings were told.
    [[nodiscard]] std::uint32_t Found() const noexcept
    {
        return found_;
    }

  private:
    void Tell(FlyingFindingKind kind, NodeId slave, const Pair& pair) noexcept;
    void CompareValue(NodeId slave, const Pair& pair, FlyingFindingKind kind = FlyingFindingKind::kValue) noexcept;
    void CompareBytes(NodeId slave, std::uint16_t index, const Bytes& first, const Bytes& second) noexcept;
    void CompareTimes() noexcept;
    void CompareNetwork() noexcept;
    void CompareIdentity(NodeId slave) noexcept;
    void CompareSupervision(NodeId slave) noexcept;
    void CompareContents(NodeId slave) noexcept;
    void CompareProfiles(NodeId slave) noexcept;
    void CompareEl6751(NodeId slave, const El6751Slave& first, const El6751Slave& second) noexcept;
    void ComparePdo(NodeId slave, std::uint16_t base, const El6751Pdo& first, const El6751Pdo& second) noexcept;
    void CompareSafety(NodeId slave) noexcept;
    void Pick(std::uint8_t first, std::uint8_t second) noexcept;
    [[nodiscard]] bool IsMaster(NodeId node) const noexcept;

    const FlyingMasterView* masters_;
    std::uint8_t count_;
    FlyingFindingListener& listener_;
    std::uint8_t first_place_;
    std::uint8_t second_place_;
    FlyingMasterView first_;
    FlyingMasterView second_;
    std::uint32_t found_;
};

void Comparison::Tell(const FlyingFindingKind kind, const NodeId slave, const Pair& pair) noexcept
{
    ++found_;
    listener_.OnFinding(
        FlyingFinding{kind, first_place_, second_place_, slave, pair.index, pair.sub, pair.first, pair.second});
}

void Comparison::Pick(const std::uint8_t first, const std::uint8_t second) noexcept
{
    first_place_ = first;
    second_place_ = second;
    first_ = masters_[first];
    second_ = masters_[second];
}

void Comparison::CompareValue(const NodeId slave, const Pair& pair, const FlyingFindingKind kind) noexcept
{
    if (pair.first != pair.second)
    {
        Tell(kind, slave, pair);
    }
}

void Comparison::CompareBytes(const NodeId slave, const std::uint16_t index, const Bytes& first,
                              const Bytes& second) noexcept
{
    const std::uint32_t first_size = (first.data != nullptr) ? first.size_bytes : 0U;
    const std::uint32_t second_size = (second.data != nullptr) ? second.size_bytes : 0U;
    std::uint32_t place = 0U;
    while ((place < first_size) && (place < second_size) && (first.data[place] == second.data[place]))
    {
        ++place;
    }
    if (first_size != second_size)
    {
        Tell(FlyingFindingKind::kContent, slave, Pair{index, slave.value, first_size, second_size});
    }
    else if (place < first_size)
    {
        Tell(FlyingFindingKind::kContent, slave, Pair{index, slave.value, place, place});
    }
    else
    {
        // Alike.
    }
}

bool Comparison::IsMaster(const NodeId node) const noexcept
{
    bool is_master = false;
    for (std::uint8_t i = 0U; i < count_; ++i)
    {
        is_master = is_master || (masters_[i].setup->own.value == node.value);
    }
    return is_master;
}

void Comparison::CheckAlone(const std::uint8_t place) noexcept
{
    Pick(place, place);
    const FlyingMasterTimes& times = *first_.times;
    if (!first_.setup->Has(kFlyingMaster))
    {
        Tell(FlyingFindingKind::kNotFlying, kAllNodes,
             Pair{0x1F80U, 0U, first_.setup->start_up, first_.setup->start_up});
    }
    if (times.priority > kLowestPriority)
    {
        Tell(FlyingFindingKind::kPriority, kAllNodes, Pair{kFlyingMasterIndex, 3U, times.priority, times.priority});
    }
    if (!HasSeparateSlots(times))
    {
        Tell(FlyingFindingKind::kSlots, kAllNodes,
             Pair{kFlyingMasterIndex, 4U, times.priority_slot, times.device_slot});
    }
}

/// Each has a node-ID of its own, and lists all others.
void Comparison::CheckNodes() noexcept
{
    for (std::uint8_t i = 0U; i < count_; ++i)
    {
        const NodeId node = masters_[i].setup->own;
        bool is_bad = (node.value == 0U) || (node.value > kLastNode);
        for (std::uint8_t other = 0U; other < count_; ++other)
        {
            const bool is_same = (other != i) && (masters_[other].setup->own.value == node.value);
            is_bad = is_bad || (is_same && (other < i));
            if ((other != i) && !is_same && !is_bad && !masters_[other].setup->IsListed(node))
            {
                Pick(other, i);
                Tell(FlyingFindingKind::kUnknown, node, Pair{0x1F81U, node.value, 0U, 0U});
            }
        }
        if (is_bad)
        {
            Pick(i, i);
            Tell(FlyingFindingKind::kSameNode, kAllNodes, Pair{0U, 0U, node.value, node.value});
        }
    }
}

void Comparison::CompareWithFirst(const std::uint8_t place) noexcept
{
    Pick(0U, place);
    CompareTimes();
    CompareNetwork();
    for (std::uint8_t node = 1U; node <= kLastNode; ++node)
    {
        const NodeId slave{node};
        const bool has_first = first_.setup->Slave(slave).IsListed();
        const bool has_second = second_.setup->Slave(slave).IsListed();
        if (IsMaster(slave))
        {
            // See CheckNodes.
        }
        else if (has_first != has_second)
        {
            Tell(FlyingFindingKind::kMissing, slave,
                 Pair{0x1F81U, node, has_first ? std::uint32_t{1U} : std::uint32_t{0U},
                      has_second ? std::uint32_t{1U} : std::uint32_t{0U}});
        }
        else if (has_first)
        {
            CompareIdentity(slave);
            CompareSupervision(slave);
            CompareContents(slave);
            CompareProfiles(slave);
            CompareSafety(slave);
        }
        else
        {
            // In neither list: what is said of it has no effect.
        }
    }
}

void Comparison::CompareTimes() noexcept
{
    const FlyingMasterTimes& first = *first_.times;
    const FlyingMasterTimes& second = *second_.times;
    CompareValue(kAllNodes, Pair{kFlyingMasterIndex, 1U, first.timeout, second.timeout});
    CompareValue(kAllNodes, Pair{kFlyingMasterIndex, 2U, first.delay, second.delay});
    CompareValue(kAllNodes, Pair{kFlyingMasterIndex, 4U, first.priority_slot, second.priority_slot});
    CompareValue(kAllNodes, Pair{kFlyingMasterIndex, 5U, first.device_slot, second.device_slot});
}

void Comparison::CompareNetwork() noexcept
{
    const NetworkSetup& first = *first_.setup;
    const NetworkSetup& second = *second_.setup;
    CompareValue(kAllNodes, Pair{0x1F80U, 0U, first.start_up, second.start_up});
    CompareValue(kAllNodes, Pair{0x1F89U, 0U, first.boot_time_ms, second.boot_time_ms});
    CompareValue(kAllNodes, Pair{0x102AU, 0U, first.inhibit_100us, second.inhibit_100us});
    CompareValue(kAllNodes, Pair{0x1006U, 0U, first.sync_period_us, second.sync_period_us});
}

void Comparison::CompareIdentity(const NodeId slave) noexcept
{
    const SlaveSetup& first = first_.setup->Slave(slave);
    const SlaveSetup& second = second_.setup->Slave(slave);
    const std::uint8_t sub = slave.value;
    CompareValue(slave, Pair{0x1F81U, sub, first.assignment, second.assignment});
    CompareValue(slave, Pair{0x1F84U, sub, first.device_type, second.device_type});
    CompareValue(slave, Pair{0x1F85U, sub, first.vendor_id, second.vendor_id});
    CompareValue(slave, Pair{0x1F86U, sub, first.product_code, second.product_code});
    CompareValue(slave, Pair{0x1F87U, sub, first.revision_number, second.revision_number});
    CompareValue(slave, Pair{0x1F88U, sub, first.serial_number, second.serial_number});
    CompareValue(slave, Pair{0x1F8AU, sub, first.restore_sub, second.restore_sub});
    CompareValue(slave, Pair{0x1F26U, sub, first.configuration_date, second.configuration_date});
    CompareValue(slave, Pair{0x1F27U, sub, first.configuration_time, second.configuration_time});
    CompareValue(slave, Pair{0x1F55U, sub, first.software.identification, second.software.identification});
    CompareValue(slave, Pair{0x1F53U, sub, first.software.date, second.software.date});
    CompareValue(slave, Pair{0x1F54U, sub, first.software.time, second.software.time});
}

void Comparison::CompareSupervision(const NodeId slave) noexcept
{
    const HeartbeatSetup& first = first_.setup->Slave(slave).heartbeat;
    const HeartbeatSetup& second = second_.setup->Slave(slave).heartbeat;
    const Pair arming{0x1016U, slave.value, static_cast<std::uint32_t>(first.arming),
                      static_cast<std::uint32_t>(second.arming)};
    CompareValue(slave, Pair{0x1016U, slave.value, first.consumer_ms, second.consumer_ms});
    CompareValue(slave, arming, FlyingFindingKind::kArming);
    CompareValue(slave, Pair{0x1017U, slave.value, first.producer_ms, second.producer_ms});
}

void Comparison::CompareContents(const NodeId slave) noexcept
{
    const SlaveSetup& first = first_.setup->Slave(slave);
    const SlaveSetup& second = second_.setup->Slave(slave);
    CompareBytes(slave, 0x1F20U, first.dcf, second.dcf);
    CompareBytes(slave, 0x1F22U, first.concise_dcf, second.concise_dcf);
    CompareBytes(slave, 0x1F58U, first.software.program, second.software.program);
}

/// Both are ascending: each step passes the lower one, or both.
void Comparison::CompareSafety(const NodeId slave) noexcept
{
    const SafetyExpectation none{nullptr, 0U};
    const SafetyExpectation* const of_first = first_.setup->Slave(slave).safety;
    const SafetyExpectation* const of_second = second_.setup->Slave(slave).safety;
    const SafetyExpectation& first = (of_first != nullptr) ? *of_first : none;
    const SafetyExpectation& second = (of_second != nullptr) ? *of_second : none;
    std::uint16_t i = 0U;
    std::uint16_t j = 0U;
    while ((i < first.count) || (j < second.count))
    {
        const std::uint32_t first_key = (i < first.count) ? OrderOf(first.objects[i].address) : kNoKey;
        const std::uint32_t second_key = (j < second.count) ? OrderOf(second.objects[j].address) : kNoKey;
        const bool has_first = first_key <= second_key;
        const bool has_second = second_key <= first_key;
        const ExpectedObject& object = has_first ? first.objects[i] : second.objects[j];
        const Pair pair{object.address.index, object.address.sub, has_first ? first.objects[i].value : 0U,
                        has_second ? second.objects[j].value : 0U};
        const bool is_fixed_alike =
            !has_first || !has_second || (first.objects[i].is_fixed == second.objects[j].is_fixed);
        if (!has_first || !has_second)
        {
            Tell(has_first ? FlyingFindingKind::kOnlyFirst : FlyingFindingKind::kOnlySecond, slave, pair);
        }
        else if ((pair.first != pair.second) || !is_fixed_alike)
        {
            Tell(FlyingFindingKind::kSafety, slave, pair);
        }
        else
        {
            // Alike.
        }
        i = static_cast<std::uint16_t>(i + (has_first ? 1U : 0U));
        j = static_cast<std::uint16_t>(j + (has_second ? 1U : 0U));
    }
}

/// Where both have data, these; else that one of them has none.
void Comparison::CompareProfiles(const NodeId slave) noexcept
{
    const SlaveSetup& first = first_.setup->Slave(slave);
    const SlaveSetup& second = second_.setup->Slave(slave);
    const std::uint32_t first_has = ((first.el6751 != nullptr) ? 1U : 0U) | ((first.plc != nullptr) ? 2U : 0U);
    const std::uint32_t second_has = ((second.el6751 != nullptr) ? 1U : 0U) | ((second.plc != nullptr) ? 2U : 0U);
    CompareValue(slave, Pair{0U, static_cast<std::uint8_t>(El6751Part::kProfiles), first_has, second_has},
                 FlyingFindingKind::kProfile);
    if ((first.el6751 != nullptr) && (second.el6751 != nullptr))
    {
        CompareEl6751(slave, *first.el6751, *second.el6751);
    }
    if ((first.plc != nullptr) && (second.plc != nullptr))
    {
        CompareValue(slave, Pair{0U, 0U, NumberOf(first.plc->is_optional), NumberOf(second.plc->is_optional)},
                     FlyingFindingKind::kPlcOptional);
        CompareValue(slave, Pair{0U, 0U, NumberOf(first.plc->is_reset), NumberOf(second.plc->is_reset)},
                     FlyingFindingKind::kPlcReset);
    }
}

/// Its data, and the PDOs as far as both have them.
void Comparison::CompareEl6751(const NodeId slave, const El6751Slave& first, const El6751Slave& second) noexcept
{
    constexpr std::uint16_t kFirstRxPdo = 0x1400U;
    constexpr std::uint16_t kFirstTxPdo = 0x1800U;
    const El6751Values of_first = ValuesOf(first);
    const El6751Values of_second = ValuesOf(second);
    for (std::uint8_t part = 1U; part < kEl6751Parts; ++part)
    {
        CompareValue(slave, Pair{0U, part, of_first.values[part], of_second.values[part]}, FlyingFindingKind::kProfile);
    }
    for (std::uint8_t i = 0U; (i < first.rx_count) && (i < second.rx_count); ++i)
    {
        ComparePdo(slave, kFirstRxPdo, first.rx_pdos[i], second.rx_pdos[i]);
    }
    for (std::uint8_t i = 0U; (i < first.tx_count) && (i < second.tx_count); ++i)
    {
        ComparePdo(slave, kFirstTxPdo, first.tx_pdos[i], second.tx_pdos[i]);
    }
}

/// By the objects that are written to the slave; sub-index 0 stands for the number, of 1600h and 1A00h for the length.
void Comparison::ComparePdo(const NodeId slave, const std::uint16_t base, const El6751Pdo& first,
                            const El6751Pdo& second) noexcept
{
    constexpr std::uint16_t kToMapping = 0x200U;
    const auto index = static_cast<std::uint16_t>((base + first.number) - 1U);
    const Pair pairs[6] = {
        {index, 0U, first.number, second.number},
        {index, 1U, first.cob_id, second.cob_id},
        {index, 2U, first.type, second.type},
        {index, 3U, first.inhibit_100us, second.inhibit_100us},
        {index, 5U, first.event_ms, second.event_ms},
        {static_cast<std::uint16_t>(index + kToMapping), 0U, first.length_bytes, second.length_bytes}};
    for (const Pair& pair : pairs)
    {
        CompareValue(slave, pair, FlyingFindingKind::kPdo);
    }
}

} // namespace

std::uint32_t CompareFlyingMasters(const FlyingMasterView* const masters, const std::uint8_t count,
                                   FlyingFindingListener& listener) noexcept
{
    if ((masters == nullptr) || (count == 0U))
    {
        return 0U;
    }
    Comparison comparison(masters, count, listener);
    comparison.CheckNodes();
    for (std::uint8_t i = 0U; i < count; ++i)
    {
        comparison.CheckAlone(i);
    }
    for (std::uint8_t i = 1U; i < count; ++i)
    {
        comparison.CompareWithFirst(i);
    }
    return comparison.Found();
}

} // namespace counterpoint::cia302
