// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/bench/mix_bus.hpp"

#include "hal/host/virtual/frame_bits.hpp"

namespace counterpoint::bench
{
namespace
{

using host::BusTime;
using host::kMicrosecond;
using host::kMillisecond;

constexpr BusTime kPartnerStep = 100 * kMicrosecond;
constexpr BusTime kMeasureFrom = 300 * kMillisecond;
constexpr BusTime kEnd = kMeasureFrom + host::kSecond;
constexpr BusTime kOperationalAt = 2 * kMillisecond;
constexpr BusTime kPairDistance = kSrdoPeriodMs * kMillisecond / static_cast<BusTime>(kMaxSrdoCount);
/// So many of 1000 bit times are in use: the SDO transfer takes what the others leave. A little above 90 %,
/// because it waits for its answers now and then.
constexpr std::uint64_t kLoadPermille = 903U;
/// The node's clock at the beginning of the bus's.
constexpr std::uint32_t kBeginUs = 1000000U;

CanFrame MakeFrame(const std::uint32_t identifier, const std::uint8_t length)
{
    return CanFrame{identifier, FrameKind::kData, CanPortId::kFirst, length, {}};
}

MixShare ShareOf(const std::uint32_t identifier)
{
    if (identifier >= kFirstSrdoIdentifier && identifier < kFirstSrdoIdentifier + 2U * kMaxSrdoCount)
    {
        return MixShare::kSrdo;
    }
    switch (identifier & 0x780U)
    {
    case 0x180U:
        return MixShare::kTpdo;
    case 0x580U:
    case 0x600U:
        return MixShare::kSdo;
    case 0x700U:
        return MixShare::kHeartbeat;
    case 0x080U:
        return MixShare::kSync;
    default:
        return MixShare::kOther;
    }
}

} // namespace

MixBus::NodePorts::NodePorts(MixBus& mix) : mix_(mix), node_(mix.bus_.Attach(*this, {CanPortId::kFirst, 8U}))
{
}

hal::CanGuarantees MixBus::NodePorts::Guarantees() const noexcept
{
    return {hal::Guarantee::kGiven, hal::Guarantee::kGiven, hal::Guarantee::kGiven};
}

void MixBus::NodePorts::OnReceived(const CanFrame& frame, const BusTime at)
{
    mix_.Write(MixKind::kFrame, frame, at);
    mix_.node_.OnFrame({frame, {At(at), Instant{At(at).us + 7U}}});
}

void MixBus::NodePorts::OnConfirmed(const CanFrame& frame, const BusTime at)
{
    mix_.Write(MixKind::kConfirm, frame, at);
    mix_.node_.OnConfirm({frame, {At(at), Instant{At(at).us + 7U}}});
}

hal::TransmitStatus MixBus::NodePorts::DoTransmit(const CanFrame& frame) noexcept
{
    digest.Add(frame);
    return mix_.bus_.Submit(node_, frame);
}

MixBus::Partner::Partner(MixBus& mix, const std::size_t mailboxes)
    : mix_(mix), node_(mix.bus_.Attach(*this, {CanPortId::kFirst, mailboxes}))
{
}

bool MixBus::Partner::Send(const CanFrame& frame) noexcept
{
    const bool may_send = !is_paced || (mix_.IsBelowLoad() && mix_.bus_.Pending(node_) == 0U);
    return may_send && mix_.bus_.Submit(node_, frame) == hal::TransmitStatus::kAccepted;
}

void MixBus::Partner::OnReceived(const CanFrame& frame, BusTime /*at*/)
{
    if (is_paced && frame.identifier == 0x580U + kNodeId)
    {
        answers.push_back(frame);
    }
}

void MixBus::Partner::OnConfirmed(const CanFrame& /*frame*/, BusTime /*at*/)
{
}

MixBus::MixBus()
{
    commissioner_.is_paced = true;
    for (std::uint32_t i = 0U; i < kDomainBytes; ++i)
    {
        download_[i] = static_cast<std::uint8_t>((i * 193U) >> 5U);
    }
}

Instant MixBus::At(const BusTime now)
{
    return Instant{kBeginUs + static_cast<std::uint32_t>(now / kMicrosecond)};
}

void MixBus::Write(const MixKind kind, const CanFrame& frame, const BusTime at)
{
    const auto word = [&frame](const std::uint32_t first)
    {
        std::uint32_t value = 0U;
        for (std::uint32_t i = 0U; i < 4U && first + i < frame.length_bytes; ++i)
        {
            value |= static_cast<std::uint32_t>(frame.data[first + i]) << (8U * i);
        }
        return value;
    };
    const std::uint32_t head = (static_cast<std::uint32_t>(kind) << 24U) |
                               (static_cast<std::uint32_t>(frame.length_bytes) << 16U) | frame.identifier;
    words_.insert(words_.end(), {At(at).us, head, word(0U), word(4U)});
}

void MixBus::OnBusRecord(const host::BusRecord& record)
{
    const std::uint32_t bits = host::MeasureFrame(record.sent.frame).WithIntermission();
    bits_ += bits;
    if (is_measuring_)
    {
        const auto share = static_cast<std::size_t>(ShareOf(record.sent.frame.identifier));
        ++sums_.frames.at(share);
        sums_.bits.at(share) += bits;
    }
}

bool MixBus::IsBelowLoad() const
{
    const auto elapsed_bits = static_cast<std::uint64_t>(bus_.Now() / bus_.BitDuration());
    return bits_ * 1000U < elapsed_bits * kLoadPermille;
}

void MixBus::SendSrdo(const std::uint32_t number)
{
    ++pairs_;
    const std::uint32_t identifier = kFirstSrdoIdentifier + 2U * (number % kMaxSrdoCount);
    CanFrame normal = MakeFrame(identifier, kMaxPayloadBytes);
    CanFrame inverse = MakeFrame(identifier + 1U, kMaxPayloadBytes);
    for (std::uint32_t i = 0U; i < kMaxPayloadBytes; ++i)
    {
        normal.data[i] = static_cast<std::uint8_t>((pairs_ * 2654435761U) >> (3U * i));
        inverse.data[i] = static_cast<std::uint8_t>(normal.data[i] ^ 0xFFU);
    }
    static_cast<void>(producers_.Send(normal));
    static_cast<void>(producers_.Send(inverse));
}

void MixBus::RunClient(const BusTime now)
{
    for (const CanFrame& answer : commissioner_.answers)
    {
        client_.OnFrame(answer, At(now));
    }
    commissioner_.answers.clear();
    client_.OnCycle(At(now));
    if (client_.State() != cia301::SdoClientState::kBusy && now > 10 * kMillisecond)
    {
        transferred_ += client_.State() == cia301::SdoClientState::kDone ? kDomainBytes : 0U;
        static_cast<void>(client_.StartDownload({kDomainIndex, 0U}, {download_.data(), kDomainBytes},
                                                cia301::SdoMode::kBlock, At(now)));
    }
}

void MixBus::RunPartners(const BusTime now)
{
    if (now == kOperationalAt)
    {
        CanFrame start = MakeFrame(0U, 2U);
        start.data[0] = 1U;
        start.data[1] = kNodeId;
        static_cast<void>(others_.Send(start));
    }
    if (now % (kTpdoMs * kMillisecond) == 0)
    {
        static_cast<void>(others_.Send(MakeFrame(0x80U, 0U)));
    }
    const BusTime heartbeat_distance = kHeartbeatMs * kMillisecond / 20;
    const auto place = static_cast<std::uint32_t>((now / heartbeat_distance) % 20);
    if (now % heartbeat_distance == 0 && place < kSupervised)
    {
        CanFrame heartbeat = MakeFrame(0x701U + place, 1U);
        heartbeat.data[0] = 5U;
        static_cast<void>(others_.Send(heartbeat));
    }
    // The next pair: SRDOs are spread over their period.
    while (now > 5 * kMillisecond && static_cast<BusTime>(pairs_) * kPairDistance <= now - 5 * kMillisecond)
    {
        SendSrdo(pairs_);
    }
    RunClient(now);
}

bool MixBus::Run()
{
    bool good = node_.Start(At(0));
    for (BusTime now = kPartnerStep; good && now < kEnd; now += kPartnerStep)
    {
        bus_.Advance(now, this);
        if (now == kMeasureFrom)
        {
            Write(MixKind::kMeasure, CanFrame{}, now);
            is_measuring_ = true;
            transferred_ = 0U;
        }
        if (now % kMillisecond == 0)
        {
            Write(MixKind::kCycle, CanFrame{}, now);
            node_.Prepare(At(now));
            node_.Cycle(At(now));
        }
        RunPartners(now);
    }
    const auto count = static_cast<std::uint32_t>(words_.size() / 4U);
    const std::uint32_t header[] = {kMixMagic, count, node_.Released(), ports_.digest.Value()};
    words_.insert(words_.begin(), std::begin(header), std::end(header));
    return good && node_.IsWell() && node_.IsOperational();
}

const std::vector<std::uint32_t>& MixBus::Words() const noexcept
{
    return words_;
}

const MixSums& MixBus::Sums() const noexcept
{
    return sums_;
}

std::uint64_t MixBus::Transferred() const noexcept
{
    return transferred_;
}

} // namespace counterpoint::bench
