// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_HOST_FRAME_QUEUE_HPP
#define HAL_HOST_FRAME_QUEUE_HPP

#include "hal/host/can_ports.hpp"
#include "safety_core/contract/can_frame.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace counterpoint::host
{

/// Queue between the controllers of a device and a kernel that polls: keeps stamped frames in bus order until Drain.
/// [SRS_HAL_015]
class FrameQueue final : public FrameSink
{
  public:
    /// @brief Holds `capacity` frames, at least 1.
    explicit FrameQueue(std::size_t capacity);

    void OnFrame(const StampedFrame& frame) override;
    void OnConfirm(const StampedFrame& frame) override;
    void OnOverflow() override;
    /// @brief Hands everything over: first OnOverflow if a frame was lost since the last Drain, then all frames in
    /// order.
    void Drain(FrameSink& sink);
    /// @brief How many frames wait.
    [[nodiscard]] std::size_t Size() const
    {
        return count_;
    }

  private:
    enum class ItemKind : std::uint8_t
    {
        kFrame,
        kConfirmation,
    };
    struct Item
    {
        StampedFrame frame;
        ItemKind kind;
    };

    void Put(const StampedFrame& frame, ItemKind kind);

    std::vector<Item> ring_;
    std::size_t first_{0U};
    std::size_t count_{0U};
    bool overflowed_{false};
};

} // namespace counterpoint::host

#endif
