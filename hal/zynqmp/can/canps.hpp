// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_ZYNQMP_CAN_CANPS_HPP
#define HAL_ZYNQMP_CAN_CANPS_HPP

#include "hal/api/can_ports.hpp"
#include "hal/api/clocks.hpp"
#include "hal/zynqmp/can/canps_registers.hpp"
#include "hal/zynqmp/can/filters.hpp"
#include "hal/zynqmp/can/frame_queue.hpp"
#include "hal/zynqmp/can/send_queue.hpp"
#include "hal/zynqmp/chip/registers.hpp"

#include <cstdint>

namespace counterpoint::zynqmp
{

/// How a controller is set up.
struct CanpsSetup
{
    RegisterBase base;
    std::uint32_t prescaler;      ///< BRPR: CAN_REF_CLK is divided by one more.
    std::uint32_t bit_timing;     ///< canps::BitTiming
    std::uint32_t reference_mhz;  ///< CAN_REF_CLK, which also clocks the time stamps.
    IdentifierList received;      ///< At least one; outlives the controller.
    std::uint32_t latest_look_us; ///< Between two looks, at most; less than the time stamps take to roll over.
    std::uint16_t urgent_below;   ///< Frames with a lower identifier go before those that wait.
    std::uint8_t pause_cycles;    ///< From bus-off to the way back to the bus.
    std::uint8_t most_returns;    ///< Out of bus-off, until the next start.
};

/// Why a controller is off the bus; the first one stays until Start. [SRS_ZYN_052]
enum class CanFault : std::uint8_t
{
    kInvalid = 0U,      ///< Never started.
    kSetup = 1U,        ///< No identifier, one above 7FFh, or looks that are too rare for the time stamps.
    kRegisters = 2U,    ///< A register reads otherwise than set up, or a state is not reached.
    kBusy = 3U,         ///< A transmit buffer is full although nothing is under way.
    kConfirmation = 4U, ///< A frame was sent although none was handed over.
    kUnderflow = 5U,    ///< The receive FIFO was read while it was empty.
    kNone = 0x5AU,
};

/// One CAN controller of the processing system: four filters, a receive FIFO in the order of the bus with time stamps,
/// one transmission at a time. All functions belong to the program; no interrupt. Source: UG1085, chapter "CAN
/// Controller"; hal/zynqmp/DESIGN.md tells what of it the emulator shows.
///
/// Stamp of a received frame: both counters are read when the frame is, less its age. The age comes from the time stamp
/// of the controller, which counts from `anchor_` on, and is believed only if both counters say that the FIFO was empty
/// before. [SRS_ZYN_046, SRS_ZYN_048]
class Canps
{
  public:
    /// @brief Reset, registers, filters, read back; on the bus if kNone comes back. [SRS_ZYN_044]
    [[nodiscard]] CanFault Start(const CanpsSetup& setup, hal::Clocks& clocks) noexcept;
    /// @brief Takes a data frame; it is sent when those before it are. [SRS_ZYN_049]
    [[nodiscard]] hal::TransmitStatus Send(const CanFrame& frame) noexcept;
    /// @brief Frames and confirmations since the look before go into `queue`, as frames of `port`. At least once in
    /// `latest_look_us`. [SRS_ZYN_046, SRS_ZYN_047, SRS_ZYN_050]
    void Look(hal::Clocks& clocks, FrameQueue& queue, CanPortId port) noexcept;
    /// @brief Once a cycle, right after Look: registers, the way out of bus-off, the time stamps begin anew.
    /// [SRS_ZYN_051, SRS_ZYN_052]
    void OnCycle(hal::Clocks& clocks, FrameQueue& queue, CanPortId port) noexcept;
    /// @brief Off the bus until Start; the first fault stays.
    void Stop(CanFault why) noexcept;

    /// @brief Why the controller is off the bus; kNone: it is not.
    [[nodiscard]] CanFault Fault() const noexcept
    {
        return fault_;
    }
    /// @brief Whether it is bus-off, or waits for its return.
    [[nodiscard]] bool IsBusOff() const noexcept
    {
        return is_bus_off_;
    }
    /// @brief How often it went back to the bus since Start.
    [[nodiscard]] std::uint8_t Returns() const noexcept
    {
        return returns_;
    }
    /// @brief Frames that a filter let pass and that are not of this device. Stays at 2^32 - 1.
    [[nodiscard]] std::uint32_t Foreign() const noexcept
    {
        return foreign_;
    }

  private:
    /// How the stamp of a frame comes about.
    enum class StampSource : std::uint8_t
    {
        kInvalid = 0U,
        kController = 0x69U, ///< Age by the controller's time stamp.
        kMoment = 1U,        ///< The frame came within the last moment: now.
    };
    struct Words
    {
        std::uint32_t identifier;
        std::uint32_t length;
        std::uint32_t data[2]; // MISRA D-001
    };

    [[nodiscard]] Register Place(std::uint32_t offset) const noexcept
    {
        return At(setup_.base, offset);
    }
    [[nodiscard]] bool IsUsable(const CanpsSetup& setup) const noexcept;
    [[nodiscard]] Outcome Configure(hal::Clocks& clocks) noexcept;
    [[nodiscard]] Outcome WriteFilters() const noexcept;
    [[nodiscard]] bool IsSetUp() const noexcept;
    [[nodiscard]] bool AreFiltersSetUp() const noexcept;
    [[nodiscard]] bool IsOurs(std::uint32_t identifier_word) const noexcept;
    void Discard() const noexcept;
    [[nodiscard]] Words ReadFrame() const noexcept;
    [[nodiscard]] std::uint32_t Drain(hal::Clocks& clocks, FrameQueue& queue, CanPortId port,
                                      StampSource source) noexcept;
    [[nodiscard]] InstantPair StampOf(const InstantPair& now, std::uint32_t time_stamp, StampSource source,
                                      FrameQueue& queue) const noexcept;
    void Deliver(const Words& words, const InstantPair& stamp, FrameQueue& queue, CanPortId port) noexcept;
    [[nodiscard]] InstantPair InOrder(const InstantPair& stamp) noexcept;
    void TakeConfirmation(hal::Clocks& clocks, FrameQueue& queue, CanPortId port) noexcept;
    void StartNext() noexcept;
    void EnterBusOff() noexcept;
    void FollowBusOff(hal::Clocks& clocks) noexcept;
    void Anchor(hal::Clocks& clocks) noexcept;

    CanpsSetup setup_{};
    FilterPlan plan_{};
    SendQueue sending_{};
    InstantPair anchor_{};
    InstantPair latest_{};  ///< Stamp of the frame before: none is earlier, or the order of the FIFO would be lost.
    InstantPair emptied_{}; ///< Before a look that found the receive FIFO empty.
    std::uint32_t foreign_{0U};
    CanFault fault_{CanFault::kInvalid};
    bool is_bus_off_{false};
    std::uint8_t paused_{0U};
    std::uint8_t returns_{0U};
};

} // namespace counterpoint::zynqmp

#endif
