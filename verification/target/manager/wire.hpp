// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_TARGET_MANAGER_WIRE_HPP
#define VERIFICATION_TARGET_MANAGER_WIRE_HPP

#include "safety_core/contract/can_frame.hpp"
#include "safety_core/contract/time.hpp"

#include <cstdint>

namespace counterpoint::target
{

/// A device on the wire.
class WireNode
{
  public:
    virtual void Cycle(Instant now) noexcept = 0;
    /// @brief The oldest frame that is not sent yet; kind kInvalid if there is none.
    [[nodiscard]] virtual CanFrame Waiting() const noexcept = 0;
    /// @brief That frame was on the bus.
    virtual void Sent(Instant now) noexcept = 0;
    virtual void Hear(const CanFrame& frame, Instant now) noexcept = 0;

  protected:
    WireNode() noexcept = default;
    ~WireNode() noexcept = default;
    WireNode(const WireNode&) = default;
    WireNode& operator=(const WireNode&) = default;
};

/// The bus between devices: the lowest identifier first, four frames a millisecond (500 kbit/s). Keeps count and hash
/// of what was on it: the same on every processor, or bytes stand in another order.
class Wire
{
  public:
    /// @brief Null: that place is empty.
    void Plug(std::uint32_t place, WireNode* node) noexcept;
    /// @brief One millisecond: each device's cycle, then frames.
    void Pass() noexcept;
    [[nodiscard]] Instant Now() const noexcept
    {
        return Instant{now_us_};
    }
    [[nodiscard]] std::uint32_t Frames() const noexcept
    {
        return frames_;
    }
    [[nodiscard]] std::uint32_t Hash() const noexcept
    {
        return hash_;
    }

    static constexpr std::uint32_t kPlaces = 3U;

  private:
    [[nodiscard]] WireNode* Next() const noexcept;
    void Count(const CanFrame& frame) noexcept;
    void Mix(std::uint32_t value, std::uint32_t bytes) noexcept;

    WireNode* nodes_[kPlaces]{};
    std::uint32_t now_us_{0U};
    std::uint32_t frames_{0U};
    std::uint32_t hash_{0x811C9DC5U};
};

} // namespace counterpoint::target

#endif
