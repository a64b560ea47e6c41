// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/bench/service_load.hpp"

#include "verification/bench/meter.hpp"
#include "verification/bench/service_node.hpp"

#include <new>

namespace counterpoint::bench
{
namespace
{

/// Takes everything: the simulated bus did, too.
class ReplayPorts final : public hal::CanPorts
{
  public:
    [[nodiscard]] hal::CanGuarantees Guarantees() const noexcept override
    {
        return {hal::Guarantee::kGiven, hal::Guarantee::kGiven, hal::Guarantee::kGiven};
    }

    FrameDigest digest{};

  private:
    [[nodiscard]] hal::TransmitStatus DoTransmit(const CanFrame& frame) noexcept override
    {
        digest.Add(frame);
        return hal::TransmitStatus::kAccepted;
    }
};

// Too large for a stack of a target.
alignas(ServiceNode) std::uint8_t node_storage[sizeof(ServiceNode)];
ReplayPorts ports;

MixKind KindOf(const MixEvent& event) noexcept
{
    return static_cast<MixKind>(event.head >> 24U);
}

StampedFrame FrameOf(const MixEvent& event) noexcept
{
    StampedFrame frame{};
    frame.frame.identifier = event.head & 0xFFFFU;
    frame.frame.kind = FrameKind::kData;
    frame.frame.port = CanPortId::kFirst;
    frame.frame.length_bytes = static_cast<std::uint8_t>(event.head >> 16U);
    for (std::uint32_t i = 0U; i < kMaxPayloadBytes; ++i)
    {
        const std::uint32_t word = (i < 4U) ? event.low : event.high;
        frame.frame.data[i] = static_cast<std::uint8_t>(word >> (8U * (i % 4U)));
    }
    frame.stamp = {Instant{event.time_us}, Instant{event.time_us + 7U}};
    return frame;
}

void Live(ServiceNode& node, const MixEvent& event) noexcept
{
    if (KindOf(event) == MixKind::kCycle)
    {
        node.Prepare(Instant{event.time_us});
        MeterBegin();
        node.Cycle(Instant{event.time_us});
        MeterEnd();
    }
    else
    {
        const StampedFrame frame = FrameOf(event);
        MeterBegin();
        if (KindOf(event) == MixKind::kConfirm)
        {
            node.OnConfirm(frame);
        }
        else
        {
            node.OnFrame(frame);
        }
        MeterEnd();
    }
}

} // namespace

LoadOutcome RunServiceLoad(const Mix& mix) noexcept
{
    constexpr std::uint32_t kBrackets = 64U;
    MeterReset();
    for (std::uint32_t i = 0U; i < kBrackets; ++i)
    {
        MeterBegin();
        MeterEnd();
    }
    MeterReport({"nothing", 0U, kBrackets});
    if (mix.header.magic != kMixMagic)
    {
        return LoadOutcome::kNoMix;
    }
    ServiceNode& node = *new (node_storage) ServiceNode(ports);
    if (!node.Start(Instant{mix.events[0].time_us}))
    {
        return LoadOutcome::kNotStarted;
    }
    std::uint32_t measured = 0U;
    for (std::uint32_t i = 0U; i < mix.header.event_count; ++i)
    {
        if (KindOf(mix.events[i]) == MixKind::kMeasure)
        {
            MeterReset();
            measured = 0U;
        }
        else
        {
            Live(node, mix.events[i]);
            ++measured;
        }
    }
    MeterReport({"service_load", kMaxSrdoCount, measured});
    if (!node.IsWell())
    {
        return LoadOutcome::kFaulted;
    }
    const bool is_same = (ports.digest.Value() == mix.header.digest) && (node.Released() == mix.header.released);
    return is_same ? LoadOutcome::kDone : LoadOutcome::kOther;
}

const char* NameOf(const LoadOutcome outcome) noexcept
{
    switch (outcome)
    {
    case LoadOutcome::kDone:
        return "done";
    case LoadOutcome::kNoMix:
        return "no frame mix was loaded";
    case LoadOutcome::kNotStarted:
        return "the node refused its configuration";
    case LoadOutcome::kOther:
        return "the node did something else than on the simulated bus";
    case LoadOutcome::kFaulted:
        return "the node met a fault";
    case LoadOutcome::kInvalid:
        break;
    }
    return "invalid";
}

} // namespace counterpoint::bench
