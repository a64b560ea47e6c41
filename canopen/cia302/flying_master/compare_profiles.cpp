// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// What two masters have for the EL6751 and PLC Designer profiles.
#include "canopen/cia302/flying_master/comparison.hpp"

#include "canopen/start_up/plc_designer/setup.hpp"

namespace counterpoint::cia302
{
namespace
{

template <typename Value> constexpr std::uint32_t NumberOf(const Value value) noexcept
{
    return static_cast<std::uint32_t>(value);
}

} // namespace

/// Where both have data, these; else that one of them has none.
void Comparison::CompareProfiles(const NodeId slave) noexcept
{
    const SlaveSetup& first = first_.setup->Slave(slave);
    const SlaveSetup& second = second_.setup->Slave(slave);
    const std::uint32_t first_has = ((first.el6751 != nullptr) ? 1U : 0U) | ((first.plc != nullptr) ? 2U : 0U);
    const std::uint32_t second_has = ((second.el6751 != nullptr) ? 1U : 0U) | ((second.plc != nullptr) ? 2U : 0U);
    ComparePart(slave, El6751Part::kProfiles, first_has, second_has);
    if ((first.el6751 != nullptr) && (second.el6751 != nullptr))
    {
        CompareEl6751(slave, *first.el6751, *second.el6751);
        CompareCoupler(slave, *first.el6751, *second.el6751);
    }
    if ((first.plc != nullptr) && (second.plc != nullptr) && (first.plc->is_optional != second.plc->is_optional))
    {
        Tell(FlyingFindingKind::kPlcOptional, slave,
             Pair{0U, 0U, NumberOf(first.plc->is_optional), NumberOf(second.plc->is_optional)});
    }
    if ((first.plc != nullptr) && (second.plc != nullptr) && (first.plc->is_reset != second.plc->is_reset))
    {
        Tell(FlyingFindingKind::kPlcReset, slave,
             Pair{0U, 0U, NumberOf(first.plc->is_reset), NumberOf(second.plc->is_reset)});
    }
}

void Comparison::ComparePart(const NodeId slave, const El6751Part part, const std::uint32_t first,
                             const std::uint32_t second) noexcept
{
    if (first != second)
    {
        Tell(FlyingFindingKind::kProfile, slave, Pair{0U, static_cast<std::uint8_t>(part), first, second});
    }
}

void Comparison::CompareEl6751(const NodeId slave, const El6751Slave& first, const El6751Slave& second) noexcept
{
    using Part = El6751Part;
    ComparePart(slave, Part::kKind, NumberOf(first.kind), NumberOf(second.kind));
    ComparePart(slave, Part::kDeviceTypeChecked, NumberOf(first.is_device_type_checked),
                NumberOf(second.is_device_type_checked));
    ComparePart(slave, Part::kSyncPeriodWritten, NumberOf(first.is_sync_period_written),
                NumberOf(second.is_sync_period_written));
    ComparePart(slave, Part::kCobIdWritten, NumberOf(first.is_cob_id_written), NumberOf(second.is_cob_id_written));
    ComparePart(slave, Part::kTypeWritten, NumberOf(first.is_type_written), NumberOf(second.is_type_written));
    ComparePart(slave, Part::kStarted, NumberOf(first.is_started), NumberOf(second.is_started));
    ComparePart(slave, Part::kRestartedWithoutPdos, NumberOf(first.is_restarted_without_pdos),
                NumberOf(second.is_restarted_without_pdos));
    ComparePart(slave, Part::kConsumerLiteral, NumberOf(first.is_consumer_literal),
                NumberOf(second.is_consumer_literal));
    ComparePart(slave, Part::kNodeReaction, NumberOf(first.node_reaction), NumberOf(second.node_reaction));
    ComparePart(slave, Part::kRestart, NumberOf(first.restart), NumberOf(second.restart));
    ComparePart(slave, Part::kNetworkReaction, NumberOf(first.network_reaction), NumberOf(second.network_reaction));
}

/// Guarding, the bus coupler's own objects, and the PDOs as far as both have them.
void Comparison::CompareCoupler(const NodeId slave, const El6751Slave& first, const El6751Slave& second) noexcept
{
    using Part = El6751Part;
    constexpr std::uint16_t kFirstRxPdo = 0x1400U;
    constexpr std::uint16_t kFirstTxPdo = 0x1800U;
    ComparePart(slave, Part::kLifeTimeFactor, first.life_time_factor, second.life_time_factor);
    ComparePart(slave, Part::kGuardTime, first.guard_time_ms, second.guard_time_ms);
    ComparePart(slave, Part::kCouplerPdos, first.coupler_pdos, second.coupler_pdos);
    ComparePart(slave, Part::kCouplerInhibit, first.coupler_inhibit_100us, second.coupler_inhibit_100us);
    ComparePart(slave, Part::kCouplerEvent, first.coupler_event_ms, second.coupler_event_ms);
    ComparePart(slave, Part::kRxCount, first.rx_count, second.rx_count);
    ComparePart(slave, Part::kTxCount, first.tx_count, second.tx_count);
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
        if (pair.first != pair.second)
        {
            Tell(FlyingFindingKind::kPdo, slave, pair);
        }
    }
}

} // namespace counterpoint::cia302
