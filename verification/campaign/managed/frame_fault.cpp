// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/campaign/managed/frame_fault.hpp"

#include "canopen/cia306/text/input_error.hpp"

#include <algorithm>

namespace counterpoint::campaign::managed
{
namespace
{
constexpr std::uint32_t kByteBits = 8U;
constexpr std::uint32_t kOtherBytes = 255U;
constexpr std::uint32_t kIdentifierBits = 11U;
constexpr std::uint32_t kInARow = 4U;
constexpr std::uint32_t kAllOfIdentifier = kInARow;
constexpr std::uint32_t kLostVariants = kInARow + 2U;
constexpr std::uint32_t kOrderVariants = 4U;
constexpr std::uint32_t kRemoteVariant = kIdentifierBits;

[[nodiscard]] bool IsMoved(const Fault fault)
{
    return fault == Fault::kRepeated || fault == Fault::kInserted || fault == Fault::kDelayed;
}

[[nodiscard]] Nanoseconds DelayOf(const FrameHit& hit)
{
    return (static_cast<Nanoseconds>(hit.variant) + 1) * kStep;
}

/// Either all of its data, or those behind command and multiplexer of an SDO alone.
[[nodiscard]] CanFrame DrawnFrame(const FrameHit& hit)
{
    constexpr std::uint8_t kMultiplexer = 4U;
    CanFrame frame = hit.frame;
    const bool keeps = (hit.drawn & 1U) != 0U && frame.length_bytes > kMultiplexer;
    for (std::uint8_t byte = keeps ? kMultiplexer : 0U; byte < frame.length_bytes; ++byte)
    {
        frame.data[byte] = static_cast<std::uint8_t>((hit.drawn >> (byte * kByteBits)) & 0xFFU);
    }
    return frame;
}

[[nodiscard]] std::string Text(const std::uint64_t number)
{
    return std::to_string(number);
}
} // namespace

std::uint64_t VariantsOf(const Fault fault, const CanFrame& frame, const std::uint64_t reach,
                         const std::size_t identifiers)
{
    switch (fault)
    {
    case Fault::kLost:
        return kLostVariants;
    case Fault::kRepeated:
    case Fault::kDelayed:
        return reach;
    case Fault::kInserted:
        return (frame.length_bytes == 0U) ? 0U : reach;
    case Fault::kWrongOrder:
        return kOrderVariants;
    case Fault::kCorrupted:
        return std::uint64_t{frame.length_bytes} * kByteBits;
    case Fault::kWrongByte:
        return std::uint64_t{frame.length_bytes} * kOtherBytes;
    case Fault::kWrongLength:
        return kMaxPayloadBytes;
    case Fault::kWrongIdentifier:
        return kIdentifierBits + 1U + (identifiers - 1U);
    default:
        return 0U;
    }
}

std::string VariantText(const FrameHit& hit, const std::vector<std::uint32_t>& identifiers)
{
    const std::uint32_t variant = hit.variant;
    switch (hit.fault)
    {
    case Fault::kLost:
        return (variant < kInARow)             ? Text(variant + 1U) + " in a row"
               : (variant == kAllOfIdentifier) ? "all of its identifier from then on"
                                               : "all of the bus from then on";
    case Fault::kWrongOrder:
        return "behind frame " + Text(variant + 1U) + " after it";
    case Fault::kCorrupted:
        return "byte " + Text(variant / kByteBits) + " bit " + Text(variant % kByteBits);
    case Fault::kWrongByte:
        return "byte " + Text(variant / kOtherBytes) + " xor " + cia306::Hex((variant % kOtherBytes) + 1U, 2);
    case Fault::kWrongLength:
        return "length " + Text(variant < hit.frame.length_bytes ? variant : variant + 1U);
    case Fault::kWrongIdentifier:
    {
        if (variant == kRemoteVariant)
        {
            return "as a remote frame";
        }
        const auto own = std::lower_bound(identifiers.begin(), identifiers.end(), hit.frame.identifier);
        const std::size_t place = variant - kIdentifierBits - 1U;
        const bool is_bit = variant < kIdentifierBits;
        const std::uint32_t other =
            is_bit ? hit.frame.identifier ^ (1U << variant)
                   : identifiers.at(place + ((place >= static_cast<std::size_t>(own - identifiers.begin())) ? 1U : 0U));
        return "as " + cia306::Hex(other, 3);
    }
    default:
        return Text((variant + 1U) * 50U) + " us later";
    }
}

Nanoseconds EndOf(const FrameHit& hit)
{
    return hit.start + (IsMoved(hit.fault) ? DelayOf(hit) : 0);
}

void FrameFault::OnReception(const host::FrameOnBus& sent, const host::NodeIndex receiver,
                             host::ReceptionList& receptions)
{
    if (identifiers_ == nullptr || sent.start < hit_.start)
    {
        return;
    }
    frames_ += (sent.start != last_) ? 1U : 0U;
    last_ = sent.start;
    if (hit_.receiver != kEverybody && hit_.receiver != receiver)
    {
        return;
    }
    if (sent.start == hit_.start && hit_.fault != Fault::kLost)
    {
        if (hit_.fault == Fault::kWrongOrder && !receptions.IsEmpty())
        {
            held_[receiver] = receptions[0].frame;
        }
        Change(receptions);
        return;
    }
    Follow(sent, receiver, receptions);
}

/// The hit frame itself.
void FrameFault::Change(host::ReceptionList& receptions) const
{
    if (receptions.IsEmpty())
    {
        return;
    }
    CanFrame& frame = receptions[0].frame;
    const std::uint32_t variant = hit_.variant;
    switch (hit_.fault)
    {
    case Fault::kRepeated:
        static_cast<void>(receptions.Add({frame, DelayOf(hit_)}));
        return;
    case Fault::kInserted:
        static_cast<void>(receptions.Add({DrawnFrame(hit_), DelayOf(hit_)}));
        return;
    case Fault::kDelayed:
        receptions[0].delay += DelayOf(hit_);
        return;
    case Fault::kWrongOrder:
        receptions.Clear();
        return;
    case Fault::kCorrupted:
        frame.data[variant / kByteBits] =
            static_cast<std::uint8_t>(frame.data[variant / kByteBits] ^ (1U << (variant % kByteBits)));
        return;
    case Fault::kWrongByte:
        frame.data[variant / kOtherBytes] =
            static_cast<std::uint8_t>(frame.data[variant / kOtherBytes] ^ ((variant % kOtherBytes) + 1U));
        return;
    case Fault::kWrongLength:
        frame.length_bytes = static_cast<std::uint8_t>((variant < frame.length_bytes) ? variant : variant + 1U);
        return;
    default:
        break;
    }
    if (variant == kRemoteVariant)
    {
        frame.kind = FrameKind::kRemote;
        return;
    }
    const auto own = std::lower_bound(identifiers_->begin(), identifiers_->end(), frame.identifier);
    const std::size_t place = variant - kIdentifierBits - 1U;
    frame.identifier =
        (variant < kIdentifierBits)
            ? frame.identifier ^ (1U << variant)
            : identifiers_->at(place + ((place >= static_cast<std::size_t>(own - identifiers_->begin())) ? 1U : 0U));
}

/// The hit frame where it is lost, and those behind it.
void FrameFault::Follow(const host::FrameOnBus& sent, const host::NodeIndex receiver, host::ReceptionList& receptions)
{
    if (hit_.fault == Fault::kLost)
    {
        const bool is_one = (hit_.variant < kInARow)             ? frames_ <= hit_.variant + 1U
                            : (hit_.variant == kAllOfIdentifier) ? sent.frame.identifier == hit_.frame.identifier
                                                                 : true;
        if (is_one)
        {
            receptions.Clear();
        }
        return;
    }
    const auto held = held_.find(receiver);
    if (held != held_.end() && frames_ > hit_.variant + 1U)
    {
        static_cast<void>(receptions.Add({held->second, 0}));
        held_.erase(held);
    }
}
} // namespace counterpoint::campaign::managed
