// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_HOST_VIRTUAL_BUS_FAULT_HPP
#define HAL_HOST_VIRTUAL_BUS_FAULT_HPP

#include "hal/host/virtual/bit_rate.hpp"
#include "safety_core/contract/can_frame.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace counterpoint::host
{

/// Number of a node on its bus, in the order of attachment from 0.
using NodeIndex = std::size_t;

/// One attempt to send one frame.
struct FrameOnBus
{
    CanFrame frame;
    NodeIndex sender;
    BusTime start;         ///< First edge of SOF.
    std::uint32_t attempt; ///< 1 for the first; one more after each error frame.
};

/// What one node gets of one frame, and how much later than the end of the frame.
struct Reception
{
    CanFrame frame;
    BusTime delay;
};

/// The receptions that one frame causes in one node. It holds the true one (delay 0) when a fault gets it. The fault
/// leaves in it what the node shall receive: nothing (loss), the frame with other bytes, length, identifier or kind
/// (corruption, masquerade, addressing), with a delay, several times (repetition), or with others beside it
/// (insertion).
class ReceptionList
{
  public:
    static constexpr std::size_t kCapacity = 16U;

    /// @brief Whether the node receives nothing.
    [[nodiscard]] bool IsEmpty() const
    {
        return size_ == 0U;
    }
    /// @brief A reception by its place, below Size().
    [[nodiscard]] Reception& operator[](const std::size_t place)
    {
        return list_[place];
    }
    [[nodiscard]] Reception* begin()
    {
        return list_.data();
    }
    [[nodiscard]] Reception* end()
    {
        return list_.data() + size_;
    }
    /// @brief The node receives nothing.
    void Clear()
    {
        size_ = 0U;
    }
    /// @brief False, and nothing done, when kCapacity is used up.
    bool Add(const Reception& reception)
    {
        const bool fits = size_ < kCapacity;
        if (fits)
        {
            list_[size_] = reception;
            ++size_;
        }
        return fits;
    }

  private:
    std::array<Reception, kCapacity> list_;
    std::size_t size_{0U};
};

/// Where the wire is hit by a disturbance that all nodes see.
struct WireHit
{
    static constexpr std::uint16_t kNone = 0xFFFFU;
    std::uint16_t bit; ///< 0 is SOF; kNone: not hit. A bit behind the frame's EOF counts as its last one.
};

/// What happens to a frame between application and transmit queue.
enum class SubmitFate : std::uint8_t
{
    kQueued = 0U,
    kSwallowed = 1U, ///< Accepted, but never sent (a stuck mailbox).
    kQueueFull = 2U, ///< Refused with kQueueFull.
};

/// Faults of the bus and of controllers. They change frames and nothing else. Several may be installed; each sees what
/// the one before left. All calls are deterministic in number and order; none may call back into the bus except Plan.
/// [SRS_BUS_010]
class BusFault
{
  public:
    virtual ~BusFault() = default;

    /// @brief Once for each frame given to Submit; may change the frame before it gets its CRC.
    virtual SubmitFate OnSubmit(CanFrame& frame, NodeIndex sender, BusTime now)
    {
        static_cast<void>(frame);
        static_cast<void>(sender);
        static_cast<void>(now);
        return SubmitFate::kQueued;
    }
    /// @brief Once for each attempt, when the frame has won the bus.
    virtual WireHit OnWire(const FrameOnBus& sent)
    {
        static_cast<void>(sent);
        return WireHit{WireHit::kNone};
    }
    /// @brief Once for each complete frame and node that hears it, at the end of the frame, before acceptance filters.
    virtual void OnReception(const FrameOnBus& sent, NodeIndex receiver, ReceptionList& receptions)
    {
        static_cast<void>(sent);
        static_cast<void>(receiver);
        static_cast<void>(receptions);
    }
    /// @brief Once for each complete frame, for the confirmation that its sender gets (false echo, no or late
    /// confirmation).
    virtual void OnConfirmation(const FrameOnBus& sent, ReceptionList& receptions)
    {
        static_cast<void>(sent);
        static_cast<void>(receptions);
    }
};

} // namespace counterpoint::host

#endif
