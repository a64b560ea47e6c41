// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/proof/protocols/producer_rig.hpp"

#include "channel_a/channel.hpp"
#include "channel_b/channel.hpp"

#include <cstring>
#include <optional>
#include <type_traits>
#include <utility>

namespace counterpoint::protocols
{
namespace
{

constexpr std::uint32_t kCycleUs = 1000U;
constexpr std::uint32_t kNormalIdentifier = 0x111U;
constexpr std::uint32_t kInverseIdentifier = 0x112U;
constexpr std::uint8_t kValid = 0xA5U;
constexpr std::uint8_t kNormalByte = 0x5AU;
constexpr std::uint8_t kInverseByte = 0xA5U;
constexpr std::uint32_t kBegin = 0xFFFF'F000U; ///< The counter turns over on the way.

// Places and values of the input, by Tell of producer.pml.
constexpr std::size_t kAct = 0U;
constexpr std::size_t kFirst = 1U;
constexpr std::size_t kSecond = 2U;
constexpr std::int32_t kCycled = 0;
constexpr std::int32_t kPrepares = 1;
constexpr std::int32_t kConfirms = 2;
constexpr std::int32_t kFails = 3;
constexpr std::int32_t kWrongNormal = 1;
constexpr std::int32_t kRightInverse = 2;
constexpr std::int32_t kWrongInverse = 3;
constexpr std::int32_t kAnother = 4;

// Places of what is shown.
constexpr std::size_t kDue = 1U;
constexpr std::size_t kFaults = 2U;
constexpr std::size_t kReady = 3U;
constexpr std::size_t kStep = 4U;
constexpr std::size_t kWaits = 6U;

/// Both channels with their storage, and the device that they belong to.
class Pair
{
  public:
    Pair()
    {
        srdo_.number = 1U;
        srdo_.form = ProducerForm::kProviderCalled;
        objects_[0] = MappableObject{0x2200U, 1U, 8U, MapAccess::kProducer, &variables_[0]};
        objects_[1] = MappableObject{0x2201U, 1U, 8U, MapAccess::kProducer, &variables_[1]};
        config_.srdos = &srdo_;
        config_.objects = &objects_[0];
        config_.object_count = 2U;
        config_.srdo_count = 1U;
        config_.node_id = 2U;
        config_.granularity_bits = 8U;
        config_.map_entries = 2U;
        config_.gfc = GfcUse::kPresent;
        config_.normal_port = CanPortId::kFirst;
        config_.inverse_port = CanPortId::kFirst;
        config_.cycle_us = kCycleUs;
        config_.cycle_tolerance_us = 1U;
        config_.acknowledge_window_us = kCycleUs;
        config_.diagnostic_interval_us = 1000000U;
        config_.test_interval_us = 1000000U;
        config_.clock_interval_us = 1000000U;
    }

    void Start(const std::uint32_t srvt_ms)
    {
        std::memset(&storage_a_, 0, sizeof(storage_a_));
        std::memset(&storage_b_, 0, sizeof(storage_b_));
        a_.emplace(storage_a_.Handle());
        b_.emplace(storage_b_.Handle());
        Configure(*a_, srvt_ms);
        Configure(*b_, srvt_ms);
    }
    [[nodiscard]] std::vector<std::uint8_t> Save() const
    {
        std::vector<std::uint8_t> bytes(kBytes);
        Move([&bytes](void* const place, const std::size_t at, const std::size_t count)
             { std::memcpy(&bytes[at], place, count); });
        return bytes;
    }
    void Restore(const std::vector<std::uint8_t>& bytes)
    {
        Move([&bytes](void* const place, const std::size_t at, const std::size_t count)
             { std::memcpy(place, &bytes[at], count); });
    }
    [[nodiscard]] Channel& A()
    {
        return *a_;
    }
    [[nodiscard]] Channel& B()
    {
        return *b_;
    }

  private:
    using StorageA = channel_a::StorageFor<1U, 2U>;
    using StorageB = channel_b::StorageFor<1U, 2U>;
    static_assert(std::is_trivially_copyable_v<StorageA>, "saved and put back byte by byte");
    static_assert(std::is_trivially_copyable_v<StorageB>, "saved and put back byte by byte");
    static constexpr std::size_t kBytes =
        sizeof(channel_a::Channel) + sizeof(StorageA) + sizeof(channel_b::Channel) + sizeof(StorageB);

    template <typename Mover> void Move(const Mover& mover) const
    {
        Pair* const self = const_cast<Pair*>(this); // Restore writes through them.
        const std::pair<void*, std::size_t> places[] = {{&*self->a_, sizeof(channel_a::Channel)},
                                                        {&self->storage_a_, sizeof(StorageA)},
                                                        {&*self->b_, sizeof(channel_b::Channel)},
                                                        {&self->storage_b_, sizeof(StorageB)}};
        std::size_t at = 0U;
        for (const auto& [place, count] : places)
        {
            mover(place, at, count);
            at += count;
        }
    }

    /// By the definition, over the bytes that SRS_CFG_010 lists.
    static std::uint16_t Signature(const std::uint32_t srvt_ms)
    {
        const std::uint8_t bytes[] = {1U,    2U,    0U,   static_cast<std::uint8_t>(srvt_ms),
                                      0x11U, 1U,    0U,   0U,
                                      0x12U, 1U,    0U,   0U,
                                      2U,    1U,    8U,   1U,
                                      0U,    0x22U, 2U,   8U,
                                      1U,    1U,    0x22U};
        std::uint32_t crc = 0U;
        for (const std::uint8_t byte : bytes)
        {
            crc ^= static_cast<std::uint32_t>(byte) << 8U;
            for (int bit = 0; bit < 8; ++bit)
            {
                crc = ((crc & 0x8000U) != 0U) ? ((crc << 1U) ^ 0x11021U) : (crc << 1U);
            }
        }
        return static_cast<std::uint16_t>(crc);
    }

    void Configure(Channel& channel, const std::uint32_t srvt_ms)
    {
        const auto store = [&channel](const ConfigField field, const std::uint32_t value, const std::uint8_t sub = 0U)
        { channel.Store(ConfigItem{ConfigAddress{0U, field, sub}, value}); };
        channel.Restart(config_);
        store(ConfigField::kDirection, kDirectionProducer);
        store(ConfigField::kSct, 2U);
        store(ConfigField::kSrvt, srvt_ms);
        store(ConfigField::kTransmissionType, kTransmissionTypeAsynchronous);
        store(ConfigField::kCobId1, kNormalIdentifier);
        store(ConfigField::kCobId2, kInverseIdentifier);
        store(ConfigField::kMapCount, 2U);
        store(ConfigField::kMapEntry, 0x22000108U, 1U);
        store(ConfigField::kMapEntry, 0x22010108U, 2U);
        store(ConfigField::kSignature, Signature(srvt_ms));
        static_cast<void>(channel.Validate(0U));
        store(ConfigField::kConfigurationValid, kValid);
    }

    std::uint8_t variables_[2]{kNormalByte, kInverseByte};
    SrdoSetup srdo_{};
    MappableObject objects_[2]{};
    DeviceConfig config_{};
    StorageA storage_a_{};
    StorageB storage_b_{};
    std::optional<channel_a::Channel> a_{};
    std::optional<channel_b::Channel> b_{};
};

Pair& Both()
{
    static Pair pair{};
    return pair;
}

bool IsFrame(const CanFrame& frame, const std::uint32_t identifier, const std::uint8_t byte)
{
    return (frame.identifier == identifier) && (frame.kind == FrameKind::kData) && (frame.length_bytes == 1U) &&
           (frame.data[0] == byte);
}

CanFrame Confirmed(const std::int32_t which)
{
    const bool is_inverse = (which == kRightInverse) || (which == kWrongInverse);
    CanFrame frame{is_inverse ? kInverseIdentifier : kNormalIdentifier,
                   FrameKind::kData,
                   CanPortId::kFirst,
                   1U,
                   {is_inverse ? kInverseByte : kNormalByte}};
    frame.data[0] ^= ((which == kWrongNormal) || (which == kWrongInverse)) ? 1U : 0U;
    frame.identifier = (which == kAnother) ? 0x113U : frame.identifier;
    return frame;
}

CycleInput InputOf(const Numbers& input, const Instant now, const std::uint32_t cycle)
{
    CycleInput given{};
    given.now = now;
    given.challenge = (cycle * 2654435761U) | 1U;
    given.guard_token = ((given.challenge << 8U) | (given.challenge >> 24U)) ^ 0xA5A5A5A5U;
    given.request = static_cast<SrdoMask>(input[kSecond]);
    given.nmt = (input[kFirst] != 0) ? NmtState::kOperational : NmtState::kPreOperational;
    given.queue = QueueState::kIntact;
    return given;
}

/// What stands in a channel behind a call; the rest is what the call itself brought.
Numbers ShownBy(const Channel& channel)
{
    const bool is_on = channel.View(0U).state == SrdoState::kProducer;
    const bool awaits_inverse = IsFrame(channel.InverseFrame(0U), kInverseIdentifier, kInverseByte);
    return {is_on ? 1 : 0, 0, 0, 0, 0, awaits_inverse ? 1 : 0, 0};
}

} // namespace

ProducerRig::ProducerRig(const ProducerDefect defect) : defect_(defect)
{
    Both().Start((defect == ProducerDefect::kLongerSrvt) ? 2U : 1U);
    bytes_ = Both().Save();
}

Numbers ProducerRig::Apply(const Numbers& input)
{
    Both().Restore(bytes_);
    cycle_ += (input.at(kAct) == kCycled) ? 1U : 0U;
    const Numbers a = Drive(Both().A(), input);
    const bool is_told = (defect_ != ProducerDefect::kForgetsFaults) || (input[kAct] != kFails);
    const Numbers b = is_told ? Drive(Both().B(), input) : ShownBy(Both().B());
    bytes_ = Both().Save();
    return (a == b) ? a : Numbers{-1};
}

Numbers ProducerRig::Drive(Channel& channel, const Numbers& input) const
{
    const Instant now{kBegin + (cycle_ * kCycleUs)};
    const Instant stamp{now.us + static_cast<std::uint32_t>(input[kSecond])};
    const std::uint32_t errors = channel.View(0U).error_count;
    std::int32_t due = 0;
    std::int32_t waits = 0;
    std::int32_t ready = 0;
    std::int32_t step = 0;
    if (input[kAct] == kCycled)
    {
        const CycleOutcome outcome = channel.OnCycle(InputOf(input, now, cycle_));
        due = static_cast<std::int32_t>(outcome.due);
        waits = static_cast<std::int32_t>(outcome.refresh);
    }
    else if (input[kAct] == kPrepares)
    {
        const PreparedPair pair = channel.Prepare(0U);
        const bool is_right = IsFrame(pair.normal, kNormalIdentifier, kNormalByte);
        ready = ((pair.status == PrepareStatus::kReady) && is_right) ? 1 : 0;
    }
    else if (input[kAct] == kConfirms)
    {
        const ConfirmStep reply = channel.OnConfirm(Confirmed(input[kFirst]), stamp).step;
        const bool is_normal = reply == ConfirmStep::kNormal;
        step = is_normal ? 1 : ((reply == ConfirmStep::kPair) ? 2 : 0);
        if (is_normal && (defect_ == ProducerDefect::kConfirmsItself))
        {
            static_cast<void>(channel.OnConfirm(Confirmed(kRightInverse), stamp));
        }
    }
    else
    {
        channel.OnTransmitFault(0U, TransmitFault{static_cast<SrdoCause>(input[kFirst])});
    }
    Numbers shown = ShownBy(channel);
    shown[kDue] = due;
    shown[kWaits] = waits;
    shown[kFaults] = static_cast<std::int32_t>(channel.View(0U).error_count - errors);
    shown[kReady] = ready;
    shown[kStep] = step;
    return shown;
}

} // namespace counterpoint::protocols
