// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_TMS570_CAN_CAN_PORTS_HPP
#define HAL_TMS570_CAN_CAN_PORTS_HPP

#include "hal/api/can_ports.hpp"
#include "hal/api/clocks.hpp"
#include "hal/tms570/can/dcan.hpp"
#include "hal/tms570/can/frame_queue.hpp"

#include <cstdint>

namespace counterpoint::tms570
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
    DcanSetup first;
    DcanSetup second;
    BusLayout layout;
};

/// The CAN controllers of a device. The interrupt puts frames with their stamps into a queue, the program takes them
/// out before each cycle. [SRS_TMS_012, SRS_TMS_013, SRS_TMS_014, SRS_TMS_015, SRS_TMS_016]
class CanPorts final : public hal::CanPorts
{
  public:
    /// @brief `clocks` outlives this.
    explicit CanPorts(hal::Clocks& clocks) noexcept;

    /// @brief Starts the controllers. What it guarantees from now on, Guarantees tells. kNone if all are on the bus.
    [[nodiscard]] CanFault Start(const CanPortsSetup& setup) noexcept;
    [[nodiscard]] hal::CanGuarantees Guarantees() const noexcept override;

    /// @brief The interrupt of either controller; not nested with itself.
    void OnInterrupt() noexcept;
    /// @brief Next frame or loss, oldest first; kind kNothing when there is none.
    [[nodiscard]] QueuedFrame Next() noexcept;
    /// @brief Once a cycle: both controllers. The first fault of either.
    [[nodiscard]] CanFault OnCycle() noexcept;
    /// @brief Takes all controllers off the bus.
    void Stop() noexcept;

    /// @brief One of the controllers, to look at.
    [[nodiscard]] const Dcan& Controller(CanPortId port) const noexcept
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
    [[nodiscard]] bool IsOrderKnown() const noexcept;
    void Serve(Dcan& controller, CanPortId port, const InstantPair& stamp) noexcept;

    hal::Clocks& clocks_;
    Dcan first_{};
    Dcan second_{};
    FrameQueue queue_{};
    BusLayout layout_{BusLayout::kInvalid};
};

} // namespace counterpoint::tms570

#endif
