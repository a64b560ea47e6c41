// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_PROOF_PLANTED_HPP
#define VERIFICATION_PROOF_PLANTED_HPP

#include "verification/conformance/forwarding.hpp"
#include "verification/proof/world.hpp"

#include <cstdint>
#include <optional>

// Defects that the proof has to refuse. Each stands between the world and a channel that ships.
namespace counterpoint::proof
{

/// Makes a channel `Defect` around the one that ships; `Defect` keeps all it remembers in one word, `notes`.
template <typename Defect> class Planted final : public Between
{
  public:
    Channel& Around(Channel& inner) override
    {
        notes_ = 0U;
        return defect_.emplace(inner, notes_);
    }
    Region Notes() override
    {
        return Region{&notes_, sizeof(notes_)};
    }

  private:
    std::uint32_t notes_{0U};
    std::optional<Defect> defect_;
};

/// Every inverse frame came with its normal frame: SRVT between the two is not looked at.
class SkipsSrvt final : public conformance::Forwarding
{
  public:
    SkipsSrvt(Channel& inner, std::uint32_t& notes) noexcept : Forwarding{inner}, inner_{inner}, stamp_us_{notes}
    {
    }
    void OnFrame(const CanFrame& frame, const Instant stamp) noexcept override
    {
        const bool is_inverse = (frame.identifier % 2U) == 0U;
        stamp_us_ = is_inverse ? stamp_us_ : stamp.us;
        inner_.OnFrame(frame, Instant{is_inverse ? stamp_us_ : stamp.us});
    }

  private:
    Channel& inner_;
    std::uint32_t& stamp_us_;
};

/// Presses its own button: releases without anybody's acknowledge.
class ReleasesAlone final : public conformance::Forwarding
{
  public:
    ReleasesAlone(Channel& inner, std::uint32_t& notes) noexcept : Forwarding{inner}, inner_{inner}, calls_{notes}
    {
    }
    CycleOutcome OnCycle(const CycleInput& input) noexcept override
    {
        CycleInput changed{input};
        calls_ = (calls_ + 1U) % 4U;
        changed.acknowledge |= ((calls_ == 3U) || (calls_ == 0U)) ? SrdoMask{1U} : SrdoMask{0U};
        return inner_.OnCycle(changed);
    }

  private:
    Channel& inner_;
    std::uint32_t& calls_;
};

/// A remote frame, which changes nothing that is shown, makes it deaf to the next normal frame.
class RemembersRemote final : public conformance::Forwarding
{
  public:
    RemembersRemote(Channel& inner, std::uint32_t& notes) noexcept : Forwarding{inner}, inner_{inner}, is_deaf_{notes}
    {
    }
    void OnFrame(const CanFrame& frame, const Instant stamp) noexcept override
    {
        const bool is_remote = frame.kind == FrameKind::kRemote;
        const bool is_lost = (is_deaf_ != 0U) && !is_remote;
        is_deaf_ = is_remote ? 1U : 0U;
        if (!is_lost)
        {
            inner_.OnFrame(frame, stamp);
        }
    }

  private:
    Channel& inner_;
    std::uint32_t& is_deaf_;
};

} // namespace counterpoint::proof

#endif
