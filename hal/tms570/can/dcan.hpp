// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_TMS570_CAN_DCAN_HPP
#define HAL_TMS570_CAN_DCAN_HPP

#include "hal/api/can_ports.hpp"
#include "hal/tms570/can/dcan_registers.hpp"
#include "hal/tms570/chip/registers.hpp"
#include "hal/tms570/chip/shared.hpp"
#include "safety_core/contract/can_frame.hpp"

#include <cstdint>

namespace counterpoint::tms570
{

/// What a message object is for.
enum class ObjectUse : std::uint8_t
{
    kInvalid = 0U,
    kReceive = 1U,
    kTransmit = 2U,
};

/// One message object: a frame of this identifier has a place of its own. [SRS_TMS_010]
struct CanObject
{
    std::uint16_t identifier;
    ObjectUse use;
};

/// How a controller is set up.
struct DcanSetup
{
    RegisterBase base;
    std::uint32_t bit_timing;  ///< dcan::BitTiming
    const CanObject* objects;  ///< Outlives the controller.
    std::uint8_t object_count; ///< 1 to room for objects.
    std::uint8_t object_room;  ///< Message objects of the controller.
    std::uint8_t pause_cycles; ///< From bus-off to the way back to the bus.
    std::uint8_t most_returns; ///< Out of bus-off, until the next start.
};

/// Why a controller is off the bus; the first one stays until Start. [SRS_TMS_019]
enum class CanFault : std::uint8_t
{
    kInvalid = 0U,    ///< Never started.
    kSetup = 1U,      ///< Identifier twice or too large, too many objects.
    kBusy = 2U,       ///< An interface to the message objects stayed busy.
    kParity = 3U,     ///< Parity error of a message object.
    kReadBack = 4U,   ///< An object holds other than it was given.
    kRegisters = 5U,  ///< Control or bit timing read otherwise than set up.
    kInterrupts = 6U, ///< An interrupt of an object that there is not.
    kNone = 0x5AU,
};

/// What a controller asks to be served for.
enum class DcanEventKind : std::uint8_t
{
    kInvalid = 0U,
    kNothing = 1U,
    kReceived = 2U,
    kReceivedAfterLoss = 3U, ///< One frame or more of this object were overwritten before.
    kConfirmed = 4U,
    kStatus = 5U, ///< No frame.
};

/// One event of a controller.
struct DcanEvent
{
    DcanEventKind kind;
    CanFrame frame; ///< Its port is not set.
};

/// How many objects want to be served.
enum class PendingCount : std::uint8_t
{
    kNone = 0U,
    kOne = 1U,
    kMany = 2U,
};

/// One DCAN controller: receive and transmit objects by identifier, parity, bus-off. `Send` and `OnCycle` belong to the
/// program, `Pending` and `Take` to the interrupt; each side has an interface to the objects of its own.
/// Source: facts/tms570 3; reference manual, chapter "Controller Area Network (DCAN)".
class Dcan
{
  public:
    /// @brief All objects and registers, read back; on the bus if kNone comes back. [SRS_TMS_011]
    [[nodiscard]] CanFault Start(const DcanSetup& setup) noexcept;
    /// @brief Puts a data frame into its object, if that is free. [SRS_TMS_015]
    [[nodiscard]] hal::TransmitStatus Send(const CanFrame& frame) noexcept;
    /// @brief Once a cycle: status, registers, the way out of bus-off. [SRS_TMS_018, SRS_TMS_019]
    void OnCycle() noexcept;

    /// @brief Objects that wait for Take. kNone as well if only the status does.
    [[nodiscard]] PendingCount Pending() const noexcept;
    /// @brief Whether Take has something to do.
    [[nodiscard]] bool IsAsking() const noexcept;
    /// @brief Serves one request. A fault of what it reads takes the controller off the bus.
    [[nodiscard]] DcanEvent Take() noexcept;

    /// @brief Why the controller is off the bus; kNone: it is not.
    [[nodiscard]] CanFault Fault() const noexcept
    {
        return fault_.Load();
    }
    /// @brief Whether it is bus-off, or on its way back.
    [[nodiscard]] bool IsBusOff() const noexcept
    {
        return bus_off_.Load() != kOnBus;
    }
    /// @brief How often it went back to the bus since Start.
    [[nodiscard]] std::uint8_t Returns() const noexcept
    {
        return returns_;
    }
    /// @brief Off the bus until Start; the first fault stays.
    void Stop(CanFault why) noexcept;

  private:
    /// What was handed over for an object, to compare with what it holds when it was sent.
    struct Sent
    {
        std::uint32_t data_a;
        std::uint32_t data_b;
        std::uint8_t length;
    };
    struct Content
    {
        std::uint32_t arbitration;
        std::uint32_t control;
        std::uint32_t data_a;
        std::uint32_t data_b;
    };

    [[nodiscard]] Register Place(std::uint32_t offset) const noexcept
    {
        return At(setup_.base, offset);
    }
    [[nodiscard]] bool IsUsable(const DcanSetup& setup) const noexcept;
    [[nodiscard]] Outcome ClearObjects() const noexcept;
    [[nodiscard]] Outcome WriteObject(std::uint32_t number, const CanObject& object) const noexcept;
    [[nodiscard]] Outcome CheckObject(std::uint32_t number, const CanObject& object) const noexcept;
    [[nodiscard]] Outcome Command(std::uint32_t interface, std::uint32_t command) const noexcept;
    [[nodiscard]] std::uint32_t FindTransmit(std::uint32_t identifier) const noexcept;
    [[nodiscard]] DcanEvent TakeObject(std::uint32_t number) noexcept;
    [[nodiscard]] DcanEvent Received(std::uint32_t number, const Content& content) noexcept;
    [[nodiscard]] DcanEvent Confirmed(std::uint32_t number, const Content& content) noexcept;
    /// @brief Reads the status, which clears it, so that nobody else may; the status as it was.
    std::uint32_t ExamineStatus() noexcept;
    void Withdraw() noexcept;
    void FollowBusOff(bool is_off) noexcept;

    static constexpr std::uint8_t kOnBus = 0x69U;
    static constexpr std::uint8_t kBusOff = 1U;
    static constexpr std::uint8_t kReturning = 2U;

    DcanSetup setup_{};
    Sent sent_[dcan::kMostObjects]{};                      // MISRA D-001
    Shared<std::uint8_t> in_flight_[dcan::kMostObjects]{}; // MISRA D-001
    Shared<CanFault> fault_{CanFault::kInvalid};
    Shared<std::uint8_t> bus_off_{kBusOff};
    std::uint8_t paused_{0U};
    std::uint8_t returns_{0U};
};

} // namespace counterpoint::tms570

#endif
