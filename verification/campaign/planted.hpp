// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_CAMPAIGN_PLANTED_HPP
#define VERIFICATION_CAMPAIGN_PLANTED_HPP

#include "verification/campaign/surroundings.hpp"
#include "verification/conformance/forwarding.hpp"

/// Parts with a defect, for positive controls. What ships is not changed: each stands in front of a shipped part.
/// [SRS_CMG_011]
namespace counterpoint::campaign
{
/// Channel B as a comparator sees it that compares all bytes of the held pair but one.
class HalfSeenChannel final : public conformance::Forwarding
{
  public:
    HalfSeenChannel(Channel& seen, const Channel& other) noexcept : Forwarding(seen), other_(other)
    {
    }

    /// Byte 0 is the other channel's. The defect.
    [[nodiscard]] HeldPair Held(SlotIndex slot) const noexcept override
    {
        constexpr std::uint32_t kByte = 0xFFU;
        HeldPair held = Forwarding::Held(slot);
        held.data.low = (held.data.low & ~kByte) | (other_.Held(slot).data.low & kByte);
        return held;
    }

  private:
    const Channel& other_;
};

/// A flow monitor that is always content.
class ContentFlow final : public TappedFlow
{
  public:
    [[nodiscard]] hal::WatchdogAnswer End(const hal::WatchdogQuestion& question) noexcept override
    {
        return {(hal::kFlowReference + question.value) * hal::kWatchdogConstant};
    }
    [[nodiscard]] DeviceFault Finding() const noexcept override
    {
        return DeviceFault::kNone;
    }
};

/// An output that looks at the masks of the permits and not at their answers.
class LooseOutput final : public FlatOutput
{
  public:
    [[nodiscard]] std::uint32_t Challenge() noexcept override;
    void Drive(const hal::PermitSet& permits) noexcept override;

  private:
    std::uint32_t issued_{0U};
};
/// An output that stays open, once it was: wrong permits change nothing.
class HeldOutput final : public FlatOutput
{
  public:
    [[nodiscard]] std::uint32_t Challenge() noexcept override;
    void Drive(const hal::PermitSet& permits) noexcept override;

  private:
    std::uint32_t issued_{0U};
    hal::PermitSet last_{}; ///< The last right ones with an open output.
};
} // namespace counterpoint::campaign

#endif // VERIFICATION_CAMPAIGN_PLANTED_HPP
