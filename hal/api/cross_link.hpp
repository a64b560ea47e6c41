// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_API_CROSS_LINK_HPP
#define HAL_API_CROSS_LINK_HPP

#include <cstdint>

namespace counterpoint::hal
{

/// What fits into one transfer; safety_core/crosslink/link_message.hpp gives the bytes their meaning.
constexpr std::uint16_t kLinkFrameBytes = 188U;

/// The bytes of one transfer over the link between the two CPUs. Bytes behind `length` have no meaning.
struct LinkFrame
{
    std::uint8_t bytes[kLinkFrameBytes]; // MISRA D-001
    std::uint16_t length;
};

/// What a transfer over the link came to.
enum class LinkStatus : std::uint8_t
{
    kInvalid = 0U,
    kDone = 0x69U, ///< Handed to the wire, or one frame was received.
    kNothing = 1U, ///< Receive: there is none. Send: no room, the frame is lost.
};

/// The wire to the other CPU. It may lose, delay, repeat, reorder and change frames; its user has to detect that. Never
/// blocks. The caller stamps what it receives by its own clock, as soon as it can: the time between arrival and stamp
/// counts as delay of the link. [SRS_LNK_020]
class CrossLink
{
  public:
    /// @brief Hands a frame to the wire.
    [[nodiscard]] virtual LinkStatus Send(const LinkFrame& frame) noexcept = 0;
    /// @brief The next frame that arrived, in the order of arrival.
    [[nodiscard]] virtual LinkStatus Receive(LinkFrame& frame) noexcept = 0;

    CrossLink(const CrossLink&) = delete;
    CrossLink(CrossLink&&) = delete;
    CrossLink& operator=(const CrossLink&) = delete;
    CrossLink& operator=(CrossLink&&) = delete;

  protected:
    CrossLink() noexcept = default;
    ~CrossLink() noexcept = default;
};

} // namespace counterpoint::hal

#endif
