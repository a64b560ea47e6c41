// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_ZYNQMP_CAN_CAN_PORTS_HPP
#define HAL_ZYNQMP_CAN_CAN_PORTS_HPP

#include "hal/api/can_ports.hpp"
#include "hal/api/clocks.hpp"
#include "hal/zynqmp/can/canps.hpp"
#include "hal/zynqmp/can/frame_queue.hpp"

#include <cstdint>

namespace counterpoint::zynqmp
{

/// Whether the two controllers hear the same frames.
enum class BusLayout : std::uint8_t
{
    kInvalid = 0U,
    kOneController = 1U, ///< `second` is not used.
    kOneBus = 2U,        ///< Both on one bus: never two frames at a time.
    kTwoBuses = 3U,      ///< Frames may end at the same moment; then those of the first controller come first.
};

/// How the controllers are set up.
struct CanPortsSetup
{
    CanpsSetup first;
    CanpsSetup second;
    BusLayout layout;
};

/// The CAN controllers of a device. The program looks at them between two cycles and before each, and takes frames in
/// the order of the bus. [SRS_ZYN_047, SRS_ZYN_049, SRS_ZYN_052]
class CanPorts final : public hal::CanPorts
{
  public:
    /// @brief `clocks` outlives this.
    explicit CanPorts(hal::Clocks& clocks) noexcept;

    /// @brief Starts the controllers. What it guarantees from now on, Guarantees tells. kNone if all are on the bus.
    [[nodiscard]] CanFault Start(const CanPortsSetup& setup) noexcept;
    [[nodiscard]] hal::CanGuarantees Guarantees() const noexcept override;

    /// @brief Takes frames and confirmations from the controllers; the moment up to which Next has all of them.
    InstantPair Look() noexcept;
    /// @brief Next frame or loss up to the moment of the last Look, oldest first; kind kNothing when there is none.
    [[nodiscard]] QueuedFrame Next() noexcept;
    /// @brief Once a cycle, after a Look: both controllers. The first fault of either.
    [[nodiscard]] CanFault OnCycle() noexcept;
    /// @brief Takes all controllers off the bus.
    void Stop() noexcept;

    /// @brief One of the controllers, to look at.
    [[nodiscard]] const Canps& Controller(CanPortId port) const noexcept
    {
        return (port == CanPortId::kSecond) ? second_ : first_;
    }

  private:
    [[nodiscard]] hal::TransmitStatus DoTransmit(const CanFrame& frame) noexcept override;
    [[nodiscard]] bool HasSecond() const noexcept
    {
        return (layout_ == BusLayout::kOneBus) || (layout_ == BusLayout::kTwoBuses);
    }
    [[nodiscard]] CanFault FirstFault() const noexcept;

    hal::Clocks& clocks_;
    Canps first_{};
    Canps second_{};
    FrameQueue queue_{};
    InstantPair looked_{};
    BusLayout layout_{BusLayout::kInvalid};
};

} // namespace counterpoint::zynqmp

#endif
