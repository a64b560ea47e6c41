// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// A device of two consumers and a producer, whose outputs are pins of a TMS570, driven step by step by the injector.
// Only what is not in namespace injection is faulted.
#include "channel_a/channel.hpp"
#include "channel_b/channel.hpp"
#include "hal/tms570/output/cut_off.hpp"
#include "hal/tms570/output/safety_pins.hpp"
#include "safety_core/kernel/kernel.hpp"
#include "verification/injection/image/mailbox.hpp"

extern "C"
{
    std::uint32_t TargetMain() noexcept;
    /// The injector stops here and goes on at the caller.
    void InjectionStepEnd() noexcept;
    /// Values of the objects in the order normal, inverse: consumer 1, consumer 2, producer.
    std::uint8_t injection_places[6][4]; // MISRA D-001
}

extern "C" [[gnu::noinline]] void InjectionStepEnd() noexcept
{
    // As any call: the compiler looks into functions that it knows, and would keep values in these.
    asm volatile("" ::: "r0", "r1", "r2", "r3", "r12", "d0", "d1", "d2", "d3", "d4", "d5", "d6", "d7", "cc", "memory");
}

namespace counterpoint::injection
{
namespace
{

constexpr std::uint8_t kSrdos = 3U;
constexpr std::uint32_t kCycleUs = 1000U;
constexpr std::uint32_t kLateCycleUs = 1500U;

// Found anew each time: an address that this file kept in a register would be faulted with the registers of what it
// calls.
const volatile Mailbox& Mail() noexcept
{
    std::uint32_t address = kMailboxAddress;
    asm volatile("" : "+r"(address));
    return *reinterpret_cast<const volatile Mailbox*>(address);
}

void Tell(const std::uint32_t port, const std::uint32_t value) noexcept
{
    *reinterpret_cast<volatile std::uint32_t*>(kPortAddress + port) = value;
}

class StepClocks final : public hal::Clocks
{
  public:
    [[nodiscard]] InstantPair Now() noexcept override
    {
        const std::uint32_t now = Mail().now_us;
        return {Instant{now}, Instant{now + 7U}};
    }
};

class StepPorts final : public hal::CanPorts
{
  public:
    [[nodiscard]] hal::CanGuarantees Guarantees() const noexcept override
    {
        return {hal::Guarantee::kGiven, hal::Guarantee::kGiven, hal::Guarantee::kGiven};
    }

  private:
    [[nodiscard]] hal::TransmitStatus DoTransmit(const CanFrame& frame) noexcept override
    {
        std::uint32_t words[2] = {0U, 0U};
        for (std::uint32_t i = 0U; i < kMaxPayloadBytes; ++i)
        {
            words[i / 4U] |= std::uint32_t{frame.data[i]} << (24U - (8U * (i % 4U)));
        }
        Tell(kPortIdentifier, frame.identifier);
        Tell(kPortLength, frame.length_bytes);
        Tell(kPortFirst, words[0]);
        Tell(kPortSecond, words[1]);
        return hal::TransmitStatus::kAccepted;
    }
};

class StepWatchdog final : public hal::Watchdog
{
  public:
    [[nodiscard]] hal::WatchdogQuestion Question() noexcept override
    {
        return {Mail().question};
    }
    void Answer(const hal::WatchdogAnswer& answer) noexcept override
    {
        Tell(kPortAnswer, answer.value);
    }
};

class StepApplication final : public Application
{
  public:
    [[nodiscard]] RefreshAnswer OnRefresh(CommunicationIndex /*index*/) noexcept override
    {
        return RefreshAnswer::kReady;
    }
    void OnSrdoEvent(const CommunicationIndex index) noexcept override
    {
        Tell(kPortEvent, 0x10000U + index.value);
    }
    void OnSrdoError(const CommunicationIndex index, const SrdoCause cause) noexcept override
    {
        Tell(kPortEvent, 0x1000000U + (static_cast<std::uint32_t>(cause) << 16U) + index.value);
    }
    void OnGfc() noexcept override
    {
        Tell(kPortEvent, 0x30000U);
    }
    void OnGfcNotFollowed() noexcept override
    {
        Tell(kPortEvent, 0x40000U);
    }
    void OnConfigurationInvalid(const CommunicationIndex index) noexcept override
    {
        Tell(kPortEvent, 0x50000U + index.value);
    }
    void OnDeviceFault(const DeviceFaultReport& report) noexcept override
    {
        Tell(kPortDeviceFault, static_cast<std::uint32_t>(report.fault));
    }
    void OnFlow(const FlowCount& /*count*/) noexcept override
    {
    }
};

constexpr SrdoSetup SetupOf(const std::uint8_t number, const ReleasePolicy policy) noexcept
{
    return {number, policy, ProducerForm::kApplicationSends, Payload{0U, 0U}, SrvtDetection::kEarly, {nullptr, 0U}};
}

constexpr SrdoSetup kSetups[kSrdos] = {SetupOf(1U, ReleasePolicy::kInterlock), SetupOf(2U, ReleasePolicy::kAutomatic),
                                       SetupOf(3U, ReleasePolicy::kInterlock)};

constexpr MappableObject ObjectOf(const std::uint16_t index, const MapAccess access, std::uint8_t* const place) noexcept
{
    return {index, 1U, 32U, access, place};
}

constexpr MappableObject kObjects[] = {
    ObjectOf(0x6000U, MapAccess::kConsumer, injection_places[0]),
    ObjectOf(0x6001U, MapAccess::kConsumer, injection_places[2]),
    ObjectOf(0x6002U, MapAccess::kProducer, injection_places[4]),
    ObjectOf(0x6100U, MapAccess::kConsumer, injection_places[1]),
    ObjectOf(0x6101U, MapAccess::kConsumer, injection_places[3]),
    ObjectOf(0x6102U, MapAccess::kProducer, injection_places[5]),
};

constexpr DeviceConfig Config() noexcept
{
    DeviceConfig config{};
    config.srdos = kSetups;
    config.objects = kObjects;
    config.object_count = 6U;
    config.srdo_count = kSrdos;
    config.node_id = 4U; // Sends 2 ms after OPERATIONAL for the first time.
    config.granularity_bits = 32U;
    config.map_entries = kUsualMapEntries;
    config.gfc = GfcUse::kPresent;
    config.normal_port = CanPortId::kFirst;
    config.inverse_port = CanPortId::kFirst;
    config.cycle_us = kCycleUs;
    config.cycle_tolerance_us = kLateCycleUs - kCycleUs;
    config.discrepancy_us = 2U * kCycleUs;
    config.acknowledge_window_us = 5U * kCycleUs;
    // The shortest that Start takes: a step of the diagnosis and a test of the comparator in every cycle.
    config.diagnostic_interval_us = 2U * kSrdos * kLateCycleUs;
    config.test_interval_us = 15U * kLateCycleUs;
    config.clock_tolerance_us = 1000U;
    config.clock_interval_us = 100000U;
    config.output_time_us = 100U;
    return config;
}

constexpr DeviceConfig kConfig = Config();

StepClocks clocks{};
StepPorts ports{};
StepWatchdog watchdog{};
StepApplication application{};

} // namespace
} // namespace counterpoint::injection

// The parts that are faulted, each with a name that the linker knows.
counterpoint::channel_a::StorageFor<3U> faulted_storage_a{};
counterpoint::channel_b::StorageFor<3U> faulted_storage_b{};
counterpoint::channel_a::Channel faulted_channel_a{faulted_storage_a.Handle()};
counterpoint::channel_b::Channel faulted_channel_b{faulted_storage_b.Handle()};
counterpoint::tms570::SafetyPins faulted_pins{counterpoint::injection::clocks};
counterpoint::Kernel faulted_kernel{
    counterpoint::KernelParts{faulted_channel_a, faulted_channel_b, counterpoint::injection::ports, faulted_pins,
                              counterpoint::injection::watchdog, counterpoint::injection::application}};

namespace counterpoint::injection
{
namespace
{

bool WriteNumber(const MailWrite& write) noexcept
{
    ObjectData data{};
    data.size_bytes = static_cast<std::uint8_t>(write.size_bytes);
    for (std::uint32_t i = 0U; i < write.size_bytes; ++i)
    {
        data.bytes[i] = static_cast<std::uint8_t>(write.value >> (8U * i));
    }
    const ObjectAddress address{static_cast<std::uint16_t>(write.index), static_cast<std::uint8_t>(write.sub)};
    const bool is_written = faulted_kernel.WriteObject(address, data) == AbortCode::kNone;
    // Who configures reads everything back (safety manual 7).
    const ObjectReading reading = faulted_kernel.ReadObject(address);
    bool is_same = (reading.abort == AbortCode::kNone) && (reading.data.size_bytes == data.size_bytes);
    for (std::uint32_t i = 0U; i < write.size_bytes; ++i)
    {
        is_same = is_same && (reading.data.bytes[i] == data.bytes[i]);
    }
    return is_written && is_same;
}

void SignAll() noexcept
{
    for (std::uint8_t slot = 0U; slot < kSrdos; ++slot)
    {
        const SignReply reply = faulted_kernel.Sign(CommunicationIndex{static_cast<std::uint16_t>(0x1301U + slot)});
        // Who configures has computed it, too (AU-16).
        Tell(kPortEvent, 0x80000U + reply.signature);
        const bool good = WriteNumber(MailWrite{0x13FFU, slot + 1U, reply.signature, 2U});
        Tell(kPortRefused, (good && (reply.result == Result::kSuccessful)) ? 0U : 1U);
    }
    Tell(kPortRefused, WriteNumber(MailWrite{0x13FEU, 0U, kConfigurationValidValue, 1U}) ? 0U : 1U);
}

void Configure(const std::uint8_t slot, const std::uint8_t direction) noexcept
{
    const std::uint32_t communication = 0x1301U + slot;
    const std::uint32_t mapping = 0x1381U + slot;
    const std::uint32_t cob_id = 0x101U + (2U * slot);
    const MailWrite writes[] = {
        {communication, 1U, 0U, 1U},
        {mapping, 0U, 0U, 1U},
        {mapping, 1U, ((0x6000U + slot) << 16U) | 0x0120U, 4U},
        {mapping, 2U, ((0x6100U + slot) << 16U) | 0x0120U, 4U},
        {mapping, 0U, 2U, 1U},
        {communication, 2U, (direction == kDirectionConsumer) ? 6U : 50U, 2U},
        {communication, 3U, (direction == kDirectionConsumer) ? 3U : 20U, 1U},
        {communication, 4U, kTransmissionTypeAsynchronous, 1U},
        {communication, 5U, cob_id, 4U},
        {communication, 6U, cob_id + 1U, 4U},
        {communication, 1U, direction, 1U},
    };
    for (const MailWrite& write : writes)
    {
        Tell(kPortRefused, WriteNumber(write) ? 0U : 1U);
    }
}

void SetUp() noexcept
{
    tms570::SafetyPinsSetup setup{tms570::gio::kPortA, {}, hal::GateLimit{1500U}};
    setup.pins[0].slots = 1U; // Consumer 1, with the interlock.
    setup.pins[1].slots = 2U; // Consumer 2, automatic.
    Tell(kPortRefused, (faulted_pins.Start(setup) == tms570::Outcome::kDone) ? 0U : 1U);
    Tell(kPortRefused, (faulted_kernel.Start(kConfig, FlowCallback::kOff) == StartResult::kStarted) ? 0U : 1U);
    faulted_kernel.SetNmtState(NmtState::kPreOperational);
    Configure(0U, kDirectionConsumer);
    Configure(1U, kDirectionConsumer);
    Configure(2U, kDirectionProducer);
    Tell(kPortRefused, WriteNumber(MailWrite{0x1300U, 0U, 1U, 1U}) ? 0U : 1U);
    SignAll();
}

void Deliver(const volatile MailFrame& mail) noexcept
{
    StampedFrame frame{};
    frame.frame.identifier = mail.identifier;
    frame.frame.kind = FrameKind::kData;
    frame.frame.port = CanPortId::kFirst;
    frame.frame.length_bytes = static_cast<std::uint8_t>(mail.length_bytes);
    const std::uint32_t words[2] = {mail.first, mail.second};
    for (std::uint32_t i = 0U; i < kMaxPayloadBytes; ++i)
    {
        frame.frame.data[i] = static_cast<std::uint8_t>(words[i / 4U] >> (24U - (8U * (i % 4U))));
    }
    const std::uint32_t stamp = mail.stamp_us;
    frame.stamp = {Instant{stamp}, Instant{stamp + 7U}};
    if (mail.is_confirmation != 0U)
    {
        faulted_kernel.OnConfirm(frame);
    }
    else
    {
        faulted_kernel.OnFrame(frame);
    }
}

void FillProducer(const std::uint32_t value) noexcept
{
    for (std::uint32_t i = 0U; i < 4U; ++i)
    {
        injection_places[4][i] = static_cast<std::uint8_t>(value >> (8U * i));
        injection_places[5][i] = static_cast<std::uint8_t>(~value >> (8U * i));
    }
}

void RunRequests() noexcept
{
    for (std::uint32_t i = 0U; i < Mail().write_count; ++i)
    {
        const volatile MailWrite& write = Mail().writes[i];
        Tell(kPortRefused, WriteNumber(MailWrite{write.index, write.sub, write.value, write.size_bytes}) ? 0U : 1U);
    }
    if (Mail().is_signed != 0U)
    {
        SignAll();
    }
    if (Mail().is_checked != 0U)
    {
        Tell(kPortRefused, (faulted_kernel.CheckConfiguration().result == Result::kSuccessful) ? 0U : 1U);
    }
    if (Mail().nmt != 0U)
    {
        faulted_kernel.SetNmtState(static_cast<NmtState>(Mail().nmt));
    }
    if (Mail().send_index != 0U)
    {
        FillProducer(Mail().sent_value);
        (void)faulted_kernel.Send(CommunicationIndex{static_cast<std::uint16_t>(Mail().send_index)});
    }
    if (Mail().is_gfc_sent != 0U)
    {
        (void)faulted_kernel.SendGfc();
    }
    if (Mail().is_demanded != 0U)
    {
        faulted_kernel.DemandSafeState();
    }
}

// As the executive of the firmware does it: outputs examined first, frames, requests, cycle.
void Step() noexcept
{
    if (faulted_pins.Examine() != tms570::Outcome::kDone)
    {
        tms570::CutOffEverything();
        return;
    }
    for (std::uint32_t i = 0U; i < Mail().frame_count; ++i)
    {
        Deliver(Mail().frames[i]);
    }
    RunRequests();
    const std::uint32_t now = Mail().now_us;
    faulted_kernel.Cycle(CycleCall{{Instant{now}, Instant{now + 7U}}, Mail().acknowledge_a, Mail().acknowledge_b});
}

} // namespace
} // namespace counterpoint::injection

extern "C" std::uint32_t TargetMain() noexcept
{
    InjectionStepEnd();
    counterpoint::injection::SetUp();
    for (;;)
    {
        InjectionStepEnd();
        counterpoint::injection::Step();
    }
}
