// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia302/flying_master_compare.hpp"

#include "canopen/cia302/safety_check.hpp"

namespace counterpoint::cia302
{
namespace
{

/// One object of both, by its number.
struct Pair
{
    std::uint16_t index;
    std::uint8_t sub;
    std::uint32_t first;
    std::uint32_t second;
};

/// Two masters that are compared, and where findings go.
class Comparison
{
  public:
    Comparison(const FlyingMasterView* const masters, const std::uint8_t count,
               FlyingFindingListener& listener) noexcept
        : masters_(masters), count_(count), listener_(listener), first_(masters[0]), second_(masters[0]), found_(0U)
    {
    }

    void CheckAlone(const FlyingMasterView& master) noexcept;
    void CheckNodes() noexcept;
    void CompareWithFirst(const FlyingMasterView& other) noexcept;
    [[nodiscard]] std::uint32_t Found() const noexcept
    {
        return found_;
    }

  private:
    void Tell(FlyingFindingKind kind, NodeId slave, const Pair& pair) noexcept;
    void CompareValue(NodeId slave, const Pair& pair) noexcept;
    void CompareBytes(NodeId slave, std::uint16_t index, const Bytes& first, const Bytes& second) noexcept;
    void CompareTimes() noexcept;
    void CompareNetwork() noexcept;
    void CompareIdentity(NodeId slave) noexcept;
    void CompareSupervision(NodeId slave) noexcept;
    void CompareContents(NodeId slave) noexcept;
    void CompareProfiles(NodeId slave) noexcept;
    void CompareSafety(NodeId slave) noexcept;
    [[nodiscard]] bool IsMaster(NodeId node) const noexcept;

    const FlyingMasterView* masters_;
    std::uint8_t count_;
    FlyingFindingListener& listener_;
    FlyingMasterView first_;
    FlyingMasterView second_;
    std::uint32_t found_;
};

void Comparison::Tell(const FlyingFindingKind kind, const NodeId slave, const Pair& pair) noexcept
{
    ++found_;
    listener_.OnFinding(FlyingFinding{kind, first_.setup->own, second_.setup->own, slave, pair.index, pair.sub,
                                      pair.first, pair.second});
}

void Comparison::CompareValue(const NodeId slave, const Pair& pair) noexcept
{
    if (pair.first != pair.second)
    {
        Tell(FlyingFindingKind::kValue, slave, pair);
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

void Comparison::CheckAlone(const FlyingMasterView& master) noexcept
{
    const FlyingMasterTimes& times = *master.times;
    first_ = master;
    second_ = master;
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

void Comparison::CheckNodes() noexcept
{
    for (std::uint8_t i = 0U; i < count_; ++i)
    {
        const std::uint8_t node = masters_[i].setup->own.value;
        bool is_bad = (node == 0U) || (node > kLastNode);
        for (std::uint8_t other = 0U; other < i; ++other)
        {
            is_bad = is_bad || (masters_[other].setup->own.value == node);
        }
        if (is_bad)
        {
            first_ = masters_[i];
            second_ = masters_[i];
            Tell(FlyingFindingKind::kSameNode, kAllNodes, Pair{0U, 0U, node, node});
        }
    }
}

void Comparison::CompareWithFirst(const FlyingMasterView& other) noexcept
{
    first_ = masters_[0];
    second_ = other;
    CompareTimes();
    CompareNetwork();
    for (std::uint8_t node = 1U; node <= kLastNode; ++node)
    {
        const NodeId slave{node};
        if (!IsMaster(slave))
        {
            CompareIdentity(slave);
            CompareSupervision(slave);
            CompareContents(slave);
            CompareProfiles(slave);
            CompareSafety(slave);
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
    constexpr std::uint32_t kArmingShift = 24U; // Above the time, where 1016h has reserved bits.
    const std::uint32_t first_arming = static_cast<std::uint32_t>(first.arming) << kArmingShift;
    const std::uint32_t second_arming = static_cast<std::uint32_t>(second.arming) << kArmingShift;
    CompareValue(slave,
                 Pair{0x1016U, slave.value, first.consumer_ms | first_arming, second.consumer_ms | second_arming});
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

void Comparison::CompareProfiles(const NodeId slave) noexcept
{
    const SlaveSetup& first = first_.setup->Slave(slave);
    const SlaveSetup& second = second_.setup->Slave(slave);
    const std::uint32_t first_has = ((first.el6751 != nullptr) ? 1U : 0U) | ((first.plc != nullptr) ? 2U : 0U);
    const std::uint32_t second_has = ((second.el6751 != nullptr) ? 1U : 0U) | ((second.plc != nullptr) ? 2U : 0U);
    if (first_has != second_has)
    {
        Tell(FlyingFindingKind::kProfile, slave, Pair{0U, 0U, first_has, second_has});
    }
}

void Comparison::CompareSafety(const NodeId slave) noexcept
{
    const SafetyExpectation* const first = first_.setup->Slave(slave).safety;
    const SafetyExpectation* const second = second_.setup->Slave(slave).safety;
    const std::uint16_t first_count = (first != nullptr) ? first->count : std::uint16_t{0U};
    const std::uint16_t second_count = (second != nullptr) ? second->count : std::uint16_t{0U};
    if (first_count != second_count)
    {
        Tell(FlyingFindingKind::kSafety, slave, Pair{0U, 0U, first_count, second_count});
        return;
    }
    bool is_same = true;
    for (std::uint16_t i = 0U; is_same && (i < first_count); ++i)
    {
        const ExpectedObject& one = first->objects[i];
        const ExpectedObject& other = second->objects[i];
        const bool is_object = (one.address.index == other.address.index) && (one.address.sub == other.address.sub);
        is_same = is_object && (one.value == other.value) && (one.is_fixed == other.is_fixed);
        if (!is_same)
        {
            Tell(FlyingFindingKind::kSafety, slave, Pair{one.address.index, one.address.sub, one.value, other.value});
        }
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
        comparison.CheckAlone(masters[i]);
    }
    for (std::uint8_t i = 1U; i < count; ++i)
    {
        comparison.CompareWithFirst(masters[i]);
    }
    return comparison.Found();
}

} // namespace counterpoint::cia302
