// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_CAMPAIGN_MANAGED_DEVICES_HPP
#define VERIFICATION_CAMPAIGN_MANAGED_DEVICES_HPP

#include "verification/campaign/managed/reference.hpp"
#include "verification/campaign/managed/stage.hpp"

#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>

namespace counterpoint::campaign::managed
{
/// What the judge sees of the devices themselves: what they are, and what their outputs do. [SRS_CMG_072]
class Devices
{
  public:
    /// @brief The stage outlives it.
    explicit Devices(Stage& stage);

    /// @brief What is seen of devices and managers now.
    void Draw(Picture& picture, Nanoseconds now);
    /// @brief Outputs that are open and must not be. Without a reference this is the run without fault, which `made`
    /// learns from.
    [[nodiscard]] Wrong LookAtOutputs(const Reference* reference, Reference& made, Nanoseconds now);
    /// @brief Outputs that are open with data that the run without fault does not have.
    [[nodiscard]] Wrong LookAtValues(const Picture& picture, const Reference& reference, Nanoseconds now);
    /// @brief Whether its configuration is not declared valid, or its kernel is in the safe state. [SRS_CMG_082]
    [[nodiscard]] bool IsHeldByItself(const Slave& slave);

  private:
    struct Output
    {
        bool is_open{false};
        Nanoseconds closed{0};
        Nanoseconds without_leave{0}; ///< Open outside of OPERATIONAL for so long.
    };
    using Key = std::pair<std::size_t, std::uint32_t>; ///< Index of the device, slot.

    static void DrawManager(Picture& picture, const simulator::SimulatedManager& manager);
    [[nodiscard]] Wrong LookAtOutput(const Slave& slave, std::uint32_t slot, const Reference* reference,
                                     Reference& made, Nanoseconds now);
    [[nodiscard]] bool IsKnown(const Reference& reference, std::size_t place, const runtime::PairValue& pair,
                               std::uint64_t value, Nanoseconds now) const;

    Stage& stage_;
    std::map<Key, Output> outputs_{};
    Nanoseconds phase_{0}; ///< Greatest time between two frames of a producer.
    Nanoseconds age_{0};   ///< Greatest age of data along the longest chain.
};
} // namespace counterpoint::campaign::managed

#endif // VERIFICATION_CAMPAIGN_MANAGED_DEVICES_HPP
