// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/third_voice/rig.hpp"

#include "safety_core/kernel/variable.hpp"

#include <algorithm>

namespace counterpoint::third_voice
{
namespace
{
std::uint8_t NumberOf(const CommunicationIndex index)
{
    return static_cast<std::uint8_t>(index.value - (kFirstCommunication - 1U));
}
} // namespace

Rig::Rig(DeviceConfig& config, std::vector<MappableObject>& objects, const Counters& counters)
    : config_(config), counters_(counters), a_{storage_a_.Handle()}, b_{storage_b_.Handle()},
      kernel_{KernelParts{a_, b_, *this, *this, *this, *this, nullptr, &windows_[0]}}
{
    for (MappableObject& object : objects)
    {
        object.place = memory_[{object.index, object.sub}].data();
        bits_[{object.index, object.sub}] = object.length_bits;
    }
    config_.objects = objects.data();
    config_.object_count = static_cast<std::uint16_t>(objects.size());
}

StartResult Rig::Start()
{
    watchdog_.Start(hal::WatchdogWindow{1U, config_.cycle_us + config_.cycle_tolerance_us + 1U}, Instant{0U});
    return kernel_.Start(config_, FlowCallback::kOff);
}

AbortCode Rig::Write(const Address address, const std::uint64_t value, const std::size_t size)
{
    ObjectData data{};
    data.size_bytes = static_cast<std::uint8_t>(size);
    for (std::size_t byte = 0U; byte < size; ++byte)
    {
        data.bytes[byte] = static_cast<std::uint8_t>(value >> (8U * byte));
    }
    return kernel_.WriteObject(ObjectAddress{address.first, address.second}, data);
}

std::uint32_t Rig::Read(const Address address)
{
    return ToValue(kernel_.ReadObject(ObjectAddress{address.first, address.second}).data);
}

SrdoObjects ReadObjects(Rig& rig, const std::uint8_t number)
{
    const auto communication = static_cast<std::uint16_t>(0x1300U + number);
    const auto mapping = static_cast<std::uint16_t>(0x1380U + number);
    SrdoObjects objects;
    objects.direction = rig.Read({communication, 1U});
    objects.sct_ms = rig.Read({communication, 2U});
    objects.srvt_ms = rig.Read({communication, 3U});
    objects.transmission_type = rig.Read({communication, 4U});
    objects.cob_id_1 = rig.Read({communication, 5U});
    objects.cob_id_2 = rig.Read({communication, 6U});
    objects.count = rig.Read({mapping, 0U});
    for (std::uint8_t sub = 1U; sub <= Rig::kEntries; ++sub)
    {
        objects.entries.push_back(rig.Read({mapping, sub}));
    }
    objects.signature = rig.Read({0x13FFU, number});
    return objects;
}

InstantPair Rig::At(const Time time) const
{
    return {Instant{counters_.a + static_cast<std::uint32_t>(time)},
            Instant{counters_.b + static_cast<std::uint32_t>(counters_.drift.ByB(time))}};
}

void Rig::SetNmt(const NmtState state, const Time now)
{
    now_ = now;
    kernel_.SetNmtState(state);
}

void Rig::OnFrame(const CanFrame& frame, const Time stamp)
{
    now_ = stamp;
    kernel_.OnFrame({frame, At(stamp)});
}

void Rig::Cycle(const Time now, const SrdoMask acknowledge_a, const SrdoMask acknowledge_b)
{
    now_ = now;
    kernel_.Cycle({At(now), acknowledge_a, acknowledge_b});
}

void Rig::Put(const Address address, const std::uint64_t value)
{
    std::array<std::uint8_t, 8U>& bytes = memory_.at(address);
    for (std::size_t byte = 0U; byte < bytes.size(); ++byte)
    {
        bytes[byte] = static_cast<std::uint8_t>(value >> (8U * byte));
    }
}

void Rig::RefuseNext(const std::optional<SrdoCause> cause)
{
    refused_ = cause;
}

void Rig::OnConfirm(const Sent& frame, const Time stamp)
{
    now_ = stamp;
    CanFrame confirmed{
        frame.identifier, FrameKind::kData, CanPortId::kFirst, static_cast<std::uint8_t>(frame.data.size()), {}};
    std::copy(frame.data.begin(), frame.data.end(), confirmed.data);
    kernel_.OnConfirm({confirmed, At(stamp)});
}

std::uint64_t Rig::Variable(const Address address) const
{
    std::array<std::uint8_t, 8U> bytes = memory_.at(address);
    return ReadVariable({bytes.data(), bits_.at(address)}).bits;
}

SrdoState Rig::StateOf(const std::uint8_t number) const
{
    return kernel_.GetState(CommunicationIndex{static_cast<std::uint16_t>(kFirstCommunication - 1U + number)}).state;
}

Kernel& Rig::Facade()
{
    return kernel_;
}

SrdoMask Rig::Open(const Time now)
{
    return gate_.Open(At(now).a, hal::GateLimit{2U * config_.cycle_us});
}

Seen Rig::TakeSeen()
{
    Seen taken;
    std::swap(taken, seen_);
    return taken;
}

RefreshAnswer Rig::OnRefresh(const CommunicationIndex index) noexcept
{
    seen_.refreshes.push_back(NumberOf(index));
    return RefreshAnswer::kReady;
}

void Rig::OnSrdoEvent(const CommunicationIndex index) noexcept
{
    seen_.events.push_back(NumberOf(index));
}

void Rig::OnSrdoError(const CommunicationIndex index, const SrdoCause cause) noexcept
{
    seen_.signals.emplace_back(NumberOf(index), cause);
}

void Rig::OnGfc() noexcept
{
    ++seen_.gfcs;
}

void Rig::OnGfcNotFollowed() noexcept
{
    ++seen_.unfollowed;
}

void Rig::OnConfigurationInvalid(CommunicationIndex /*index*/) noexcept
{
    seen_.is_configuration_invalid = true;
}

void Rig::OnDeviceFault(const DeviceFaultReport& /*report*/) noexcept
{
    ++seen_.faults;
}

void Rig::OnFlow(const FlowCount& /*count*/) noexcept
{
}

hal::CanGuarantees Rig::Guarantees() const noexcept
{
    return {hal::Guarantee::kGiven, hal::Guarantee::kGiven, hal::Guarantee::kGiven};
}

hal::TransmitStatus Rig::DoTransmit(const CanFrame& frame) noexcept
{
    seen_.frames.push_back({frame.identifier, Bytes(frame.data, frame.data + frame.length_bytes)});
    const std::optional<SrdoCause> refused = refused_;
    refused_.reset();
    if (!refused)
    {
        return hal::TransmitStatus::kAccepted;
    }
    return (*refused == SrdoCause::kBusOff) ? hal::TransmitStatus::kBusOff : hal::TransmitStatus::kQueueFull;
}

std::uint32_t Rig::Challenge() noexcept
{
    return gate_.Challenge();
}

void Rig::Drive(const hal::PermitSet& permits) noexcept
{
    gate_.Drive(permits, At(now_).a);
}

hal::WatchdogQuestion Rig::Question() noexcept
{
    return watchdog_.Question();
}

void Rig::Answer(const hal::WatchdogAnswer& answer) noexcept
{
    watchdog_.Answer(answer, At(now_).a);
}
} // namespace counterpoint::third_voice
