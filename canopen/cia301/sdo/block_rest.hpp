// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA301_SDO_BLOCK_REST_HPP
#define CANOPEN_CIA301_SDO_BLOCK_REST_HPP

#include "safety_core/contract/time.hpp"

#include <cstdint>

namespace counterpoint::cia301
{

/// The rest of a sub-block of a download that was ended within it: a client sends its sub-block without waiting, and
/// what is still under way looks like requests. Its numbers grow, and one may come twice; a client that sends its
/// sub-block anew begins with small ones, with which no transfer begins. So a client that gave up, and asks for the
/// same again and again, is no rest for ever. [SRS_SDO_019]
class BlockRest
{
  public:
    /// @brief Segments 1 to `block_size` may still come. Time counts from the next call of Poll or Takes on.
    void Await(std::uint8_t block_size) noexcept;
    /// @brief Whether a frame with this first byte is one of them. The last one ends the rest, and so does any other
    /// frame, one with a number out of order among them. O(1)
    [[nodiscard]] bool Takes(std::uint8_t head, Instant now) noexcept;
    /// @brief Ends the rest after a pause. Once a cycle. O(1)
    void Poll(Instant now, std::uint32_t pause_us) noexcept;

  private:
    std::uint8_t block_size_{0U}; ///< 0: nothing is awaited.
    std::uint8_t number_{0U};     ///< Of the last one.
    bool is_doubled_{false};      ///< That one came twice.
    bool is_timed_{false};        ///< `last_` counts.
    Instant last_{0U};
};

/// The segment that ends a sub-block, once more: an error in the last bit of its end lets a frame come twice. It is
/// none of what follows, whatever that is. Not for sub-blocks of one segment, where the same frame is the next segment.
/// [SRS_SDO_151, SRS_SDO_152]
class DoubledSegment
{
  public:
    /// @brief This frame of 8 bytes may come again as the next one.
    void Await(const std::uint8_t* bytes) noexcept;
    /// @brief Whether this frame of 8 bytes is that one. It ends the waiting, and so does any other. O(1)
    [[nodiscard]] bool Takes(const std::uint8_t* bytes) noexcept;

  private:
    bool is_awaited_{false};
    std::uint8_t bytes_[8]{};
};

} // namespace counterpoint::cia301

#endif
