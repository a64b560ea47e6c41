// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_CAMPAIGN_MANAGED_FRAME_FAULT_HPP
#define VERIFICATION_CAMPAIGN_MANAGED_FRAME_FAULT_HPP

#include "hal/host/virtual/bus.hpp"
#include "verification/campaign/managed/plan.hpp"

#include <cstdint>
#include <map>
#include <vector>

namespace counterpoint::campaign::managed
{
constexpr host::NodeIndex kEverybody = ~host::NodeIndex{0U};

/// What happens to one frame on its way to everybody who hears it, or to one of them alone.
struct FrameHit
{
    Fault fault{Fault::kLost};
    std::uint32_t variant{0U};
    host::BusTime start{0}; ///< Of the frame.
    CanFrame frame{};
    host::NodeIndex receiver{kEverybody};
    std::uint64_t drawn{0U}; ///< Data of Fault::kInserted.
};

/// How many variants of a fault a frame has. `identifiers`: how many the recording has.
[[nodiscard]] std::uint64_t VariantsOf(Fault fault, const CanFrame& frame, std::uint64_t reach,
                                       std::size_t identifiers);
/// @brief What a variant is, for people. `identifiers` are those of the recording.
[[nodiscard]] std::string VariantText(const FrameHit& hit, const std::vector<std::uint32_t>& identifiers);
/// @brief Until when a fault of a frame still does something by itself.
[[nodiscard]] Nanoseconds EndOf(const FrameHit& hit);

/// The fault of a frame. Until Arm it leaves everything as it is. [SRS_CMG_071]
class FrameFault final : public host::BusFault
{
  public:
    /// @brief `identifiers` are those of the recording, ascending; they outlive it.
    void Arm(const FrameHit& hit, const std::vector<std::uint32_t>& identifiers)
    {
        hit_ = hit;
        identifiers_ = &identifiers;
    }

    void OnReception(const host::FrameOnBus& sent, host::NodeIndex receiver, host::ReceptionList& receptions) override;

  private:
    void Change(host::ReceptionList& receptions) const;
    void Follow(const host::FrameOnBus& sent, host::NodeIndex receiver, host::ReceptionList& receptions);

    FrameHit hit_{};
    const std::vector<std::uint32_t>* identifiers_{nullptr}; ///< Null: nothing is hit.
    host::BusTime last_{-1};                                 ///< Start of the last frame from the hit one on.
    std::uint32_t frames_{0U};                               ///< From the hit one on.
    std::map<host::NodeIndex, CanFrame> held_{};
};
} // namespace counterpoint::campaign::managed

#endif // VERIFICATION_CAMPAIGN_MANAGED_FRAME_FAULT_HPP
