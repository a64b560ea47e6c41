// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/device/services.hpp"

#include "canopen/device/kernel_watch.hpp"

#include "canopen/cia301/objects/service_table.hpp"
#include "canopen/cia301/pdo/settings.hpp"

namespace counterpoint::device
{
namespace
{

using cia301::CommunicationError;
using cia301::GuardEvent;
using cia301::Service;

constexpr std::uint32_t kEmergenciesOfRpdo = 3U; ///< Too short, too long, too late.
/// Safe state, 6300h, overrun twice, passive, life guarding, bus-off, an identifier in use twice, SYNC; the rest is for
/// errors of the application.
constexpr std::uint32_t kEmergenciesOfDevice = 32U;

constexpr std::uint32_t kSdoTimeOutUs = 1000000U;
constexpr std::uint8_t kSdoBlock = 64U;
constexpr std::uint16_t kStartUpIndex = 0x1F80U;
constexpr std::uint16_t kConfigurationValidIndex = 0x13FEU;
constexpr std::uint16_t kServiceQueue = 1U;  ///< Source of an overrun.
constexpr std::uint16_t kOwnController = 0U; ///< Source of what is wrong with the bus.
constexpr std::uint16_t kGuardTimeIndex = 0x100CU;
constexpr std::uint16_t kLifeFactorIndex = 0x100DU;

constexpr std::uint32_t kLssCommands = 0x7E5U;
constexpr std::uint32_t kSdoAnswers = 0x580U;
constexpr std::uint32_t kSdoRequests = 0x600U;
constexpr std::uint32_t kSdoLast = 0x67FU;
constexpr std::uint32_t kErrorControl = 0x700U;
constexpr std::uint32_t kErrorControlLast = 0x77FU;
constexpr std::uint16_t kFirstRpdo = 0x1400U;
constexpr std::uint16_t kLastRpdo = 0x15FFU;
constexpr std::uint16_t kFirstTpdo = 0x1800U;
constexpr std::uint16_t kLastTpdo = 0x19FFU;
constexpr std::uint16_t kSyncCobId = 0x1005U;
constexpr std::uint16_t kEmergencyCobId = 0x1014U;
constexpr std::uint16_t kEmergencySources = 0x1028U;
constexpr std::uint32_t kStandard = 0x7FFU;
constexpr std::uint32_t kTimeRoles = cia301::kCobOff | cia301::kCobBit30; ///< Bit 31 of 1012h: consumes.

bool IsIn(const std::uint16_t index, const std::uint16_t first, const std::uint16_t last) noexcept
{
    return (index >= first) && (index <= last);
}

bool IsPdo(const std::uint16_t index) noexcept
{
    return IsIn(index, kFirstRpdo, kLastRpdo) || IsIn(index, kFirstTpdo, kLastTpdo);
}

/// Whether this value gives a service, but not a PDO, an identifier.
bool IsIdentifierOfService(const ObjectAddress& object, const std::uint32_t value) noexcept
{
    const bool is_on = (value & cia301::kCobOff) == 0U;
    bool is_identifier =
        is_on && ((object.index == kEmergencyCobId) || ((object.index == kEmergencySources) && (object.sub > 0U)));
    is_identifier = is_identifier || (is_on && IsIn(object.index, 0x1201U, 0x12FFU) && IsIn(object.sub, 1U, 2U));
    is_identifier = is_identifier || (object.index == kSyncCobId);
    return is_identifier || ((object.index == 0x1012U) && ((value & kTimeRoles) != 0U));
}

/// Whether a service that is no PDO uses this identifier: another one than that of `index`. Those that are neither SYNC
/// nor emergency producer are not told from each other, and 1028h may name the own emergency.
bool IsOfService(const Services& services, const std::uint32_t identifier, const std::uint16_t index) noexcept
{
    const bool is_sync = (index != kSyncCobId) && services.sync.Uses(identifier);
    const bool is_emergency = (services.emergency.CobId() == identifier);
    const bool is_of_emergency = (index == kEmergencyCobId) || (index == kEmergencySources);
    const bool is_known = IsPdo(index) || (index == kSyncCobId) || ((index == kEmergencyCobId) && !is_emergency);
    bool is_used = is_sync || (is_emergency && !is_of_emergency);
    for (std::uint8_t place = 0U; is_known && (place < services.further.count); ++place)
    {
        is_used = is_used || services.further.list[place]->Uses(identifier);
    }
    return is_used;
}

} // namespace

std::uint16_t EmergencyPlaces(const std::uint8_t srdo_count, const ServiceRooms& rooms) noexcept
{
    const std::uint32_t of_srdos = static_cast<std::uint32_t>(srdo_count) * kEmergenciesOfSrdo;
    const std::uint32_t of_rpdos = rooms.rpdos.count * kEmergenciesOfRpdo;
    return static_cast<std::uint16_t>(of_srdos + of_rpdos + rooms.supervised.count + kEmergenciesOfDevice);
}

Services::Services(const cia301::NodeId own_node, const ServiceParts& parts) noexcept
    : ServiceSet(own_node, &parts.can), supervised(parts.rooms.supervised), outbox(parts.can), process(outbox),
      emergency(parts.emergency), errors(emergency, slave), consumer(supervised, errors), producer(own_node),
      guarding(own_node), objects({emergency, consumer, producer, guarding, supervised.count}),
      tpdos({process, parts.dictionary, parts.rooms.tpdos}),
      rpdos({errors, parts.dictionary, parts.rooms.rpdos, nullptr}), pdos(tpdos, rpdos), sync({process, errors, pdos}),
      sdo({parts.dictionary, parts.rooms.sdo_buffer, kSdoTimeOutUs, kSdoBlock}), sdo_port(sdo, outbox, own_node),
      lss(nullptr), further{nullptr, 0U}, watch(nullptr), dictionary(nullptr)
{
}

void Services::PowerOff() noexcept
{
    ServiceSet::PowerOff();
    outbox.Clear();
}

bool Services::MayBoot() const noexcept
{
    return lss->MayBoot();
}

void Services::OnResetNode() noexcept
{
    watch->OnRestart();
}

bool Services::TakeNodeId() noexcept
{
    if (lss != nullptr)
    {
        node = lss->TakeNodeId();
    }
    return ServiceSet::TakeNodeId();
}

void Services::BeginConfiguration() noexcept
{
    emergency.ResetCommunication(node);
    errors.Reset();
    for (std::uint8_t place = 0U; place < supervised.count; ++place)
    {
        supervised.nodes[place] = cia301::SupervisedNode{};
    }
    producer = cia301::HeartbeatProducer{node};
    guarding = cia301::NodeGuarding{node};
    constexpr std::uint8_t kZero[2] = {0U, 0U};
    static_cast<void>(objects.OnWrite({kGuardTimeIndex, 0U}, {kZero, 2U}));
    static_cast<void>(objects.OnWrite({kLifeFactorIndex, 0U}, {kZero, 1U}));
    sync.Reset();
    tpdos.Reset();
    rpdos.Reset();
    sdo_port.ResetCommunication(node);
    for (std::uint8_t place = 0U; place < further.count; ++place)
    {
        further.list[place]->ResetCommunication(node);
        if (cia301::NumberHook* const hook = further.list[place]->Objects())
        {
            hook->BeginConfiguration();
        }
    }
    sync.BeginConfiguration();
    objects.BeginConfiguration();
    pdos.BeginConfiguration();
    tpdos.BeginConfiguration();
    rpdos.BeginConfiguration();
}

void Services::EndConfiguration() noexcept
{
    consumer.EndLoad();
    for (std::uint8_t place = 0U; place < further.count; ++place)
    {
        if (cia301::NumberHook* const hook = further.list[place]->Objects())
        {
            hook->EndConfiguration(this);
        }
    }
    sync.EndConfiguration(this);
    objects.EndConfiguration(this);
    rpdos.EndConfiguration();
    tpdos.EndConfiguration();
    tpdos.TurnOffShared(*this);
    rpdos.TurnOffShared(*this);
    pdos.EndConfiguration(this);
    const cia301::NumberReading start_up = dictionary->ReadNumber({kStartUpIndex, 0U});
    Rejoin({start_up.abort == cia301::SdoAbort::kNone, static_cast<std::uint32_t>(start_up.value)});
}

void Services::OnState(const NmtState left, const NmtState entered) noexcept
{
    dictionary->SetNmtState(entered);
    if (left == NmtState::kOperational)
    {
        outbox.ForgetPdos(sync);
        watch->OnOperationalLeft();
    }
}

void Services::OnOperational() noexcept
{
    const cia301::NumberReading valid = dictionary->ReadNumber({kConfigurationValidIndex, 0U});
    const bool is_there = valid.abort == cia301::SdoAbort::kNone; // A plain device has none. [SRS_DEV_021]
    if (is_there && (valid.value != kConfigurationValidValue))
    {
        watch->OnNotConfigured();
    }
}

bool Services::Wants(const CanFrame& frame) const noexcept
{
    const std::uint32_t identifier = frame.identifier;
    const bool is_sdo = (identifier > kSdoAnswers) && (identifier <= kSdoLast);
    bool is_own_sdo = (identifier == (kSdoRequests + node.value)) || (identifier == (kSdoAnswers + node.value));
    for (std::uint8_t place = 0U; is_sdo && (place < further.count); ++place)
    {
        is_own_sdo = is_own_sdo || further.list[place]->Wants(identifier);
    }
    return is_sdo ? is_own_sdo : ((identifier <= kErrorControlLast) || (identifier == kLssCommands));
}

void Services::OnConfirm() noexcept
{
    outbox.OnConfirm();
}

void Services::OnOverrun(const bool has_lost) noexcept
{
    if (has_lost)
    {
        errors.Raise(CommunicationError::kOverrun, kServiceQueue);
    }
    else
    {
        errors.Clear(CommunicationError::kOverrun, kServiceQueue);
    }
}

void Services::OnFrame(const CanFrame& frame, const cia301::Moment& moment) noexcept
{
    if (lss != nullptr)
    {
        lss->OnFrame(frame, moment);
    }
    sdo_port.OnFrame(frame, moment);
    sync.OnFrame(frame, moment);
    tpdos.OnFrame(frame, moment);
    rpdos.OnFrame(frame, moment);
    for (std::uint8_t place = 0U; place < further.count; ++place)
    {
        further.list[place]->OnFrame(frame, moment);
    }
    if (cia301::IsAllowed(Service::kErrorControl, moment.state))
    {
        consumer.OnFrame(frame, moment.now);
        const cia301::GuardMoment guard_moment{moment.state, producer.PeriodMs(), moment.now};
        const cia301::GuardReply reply = guarding.OnFrame(frame, guard_moment);
        // Questions of a master without an end leave places for emergencies, too.
        Send(outbox.HasOwnRoom() ? reply.reply : cia301::FrameToSend{false, {}});
        if (reply.event == GuardEvent::kResumed)
        {
            errors.Clear(CommunicationError::kLifeGuard, 0U);
        }
    }
    // Nobody else may send what only this node sends.
    const bool is_own =
        (frame.identifier == (kSdoAnswers + node.value)) || (frame.identifier == (kErrorControl + node.value));
    if (is_own && (frame.kind == FrameKind::kData))
    {
        errors.Raise(CommunicationError::kCollision, static_cast<std::uint16_t>(frame.identifier));
    }
}

void Services::OnCycle(const cia301::Moment& moment) noexcept
{
    consumer.Poll(moment.now);
    if (guarding.Poll({moment.state, producer.PeriodMs(), moment.now}) == GuardEvent::kLost)
    {
        errors.Raise(CommunicationError::kLifeGuard, 0U);
    }
    if (!guarding.IsLost())
    {
        errors.Clear(CommunicationError::kLifeGuard, 0U); // Heartbeats, or 100Ch and 100Dh anew: nobody else ends it.
    }
    sync.OnCycle(moment);
    rpdos.OnCycle(moment);
    tpdos.OnCycle(moment);
    // Both forget what they hand out: only with room.
    if (outbox.HasOwnRoom())
    {
        const cia301::FrameToSend heartbeat = producer.Poll(moment.state, moment.now);
        // Many that leave at once, when the bus is back, look like those of two devices.
        if (heartbeat.is_present && !outbox.Waits(heartbeat.frame.identifier, heartbeat.frame.data[0]))
        {
            Send(heartbeat);
        }
    }
    if (outbox.HasOwnRoom())
    {
        Send(emergency.Poll(moment.state, moment.now));
    }
    // A reset that waits for a store ends transfers without a word.
    const bool is_up = cia301::StateByte(moment.state) != 0U;
    if (is_up)
    {
        sdo_port.OnCycle(moment);
    }
    for (std::uint8_t place = 0U; is_up && (place < further.count); ++place)
    {
        further.list[place]->OnCycle(moment);
    }
    if (lss != nullptr)
    {
        lss->OnCycle(moment);
    }
    Flush(moment.now);
}

void Services::OnBus(const BusCondition left, const BusCondition entered) noexcept
{
    const bool was_off = left == BusCondition::kOff;
    const bool is_off = entered == BusCondition::kOff;
    if (entered == BusCondition::kPassive)
    {
        errors.Raise(CommunicationError::kPassive, kOwnController);
    }
    if (entered == BusCondition::kActive)
    {
        errors.Clear(CommunicationError::kPassive, kOwnController);
    }
    if (is_off && !was_off)
    {
        outbox.Clear();
        sdo_port.ResetCommunication(node);
        errors.Raise(CommunicationError::kBusOff, kOwnController);
    }
    if (was_off && !is_off)
    {
        errors.Clear(CommunicationError::kBusOff, kOwnController);
    }
}

void Services::Flush(const Instant now) noexcept
{
    if ((lss == nullptr) || !lss->IsSilent())
    {
        outbox.Poll(now);
    }
}

bool Services::Allows(const ObjectAddress& object, const std::uint32_t value) const noexcept
{
    const std::uint32_t identifier = value & kStandard;
    const bool is_on = ((value & cia301::kCobOff) == 0U) && (object.sub == cia301::kCobIdSub);
    const bool is_tpdo = is_on && IsIn(object.index, kFirstTpdo, kLastTpdo);
    const bool is_rpdo = is_on && IsIn(object.index, kFirstRpdo, kLastRpdo);
    bool is_shared = false;
    if (is_tpdo || is_rpdo)
    {
        const auto own = static_cast<std::uint16_t>((object.index - kFirstTpdo) + 1U);
        const bool is_sent = tpdos.Uses(identifier, is_tpdo ? own : std::uint16_t{0U});
        is_shared = IsOfService(*this, identifier, object.index) || is_sent || (is_tpdo && rpdos.Uses(identifier, 0U));
    }
    else if (IsIdentifierOfService(object, value))
    {
        is_shared =
            IsOfService(*this, identifier, object.index) || tpdos.Uses(identifier, 0U) || rpdos.Uses(identifier, 0U);
    }
    else
    {
        // No identifier.
    }
    return !is_shared;
}

void Services::Send(const cia301::FrameToSend& frame) noexcept
{
    if (frame.is_present)
    {
        static_cast<void>(outbox.SendOwn(frame.frame));
    }
}

} // namespace counterpoint::device
