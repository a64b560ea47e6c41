// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TESTS_CANOPEN_CIA301_KEEPING_SINK_HPP
#define TESTS_CANOPEN_CIA301_KEEPING_SINK_HPP

#include "canopen/cia301/nmt/frame_sink.hpp"

#include <cstdint>
#include <vector>

namespace counterpoint::cia301
{

using Octets = std::vector<std::uint8_t>;

/// Keeps what is sent; takes `room` frames.
class KeepingSink final : public FrameSink
{
  public:
    bool Send(const CanFrame& frame) noexcept override
    {
        const bool is_taken = room > 0;
        if (is_taken)
        {
            --room;
            frames.push_back(frame);
        }
        return is_taken;
    }
    /// Identifier and bytes of the oldest frame; empty: there is none.
    Octets Next()
    {
        Octets bytes{};
        if (!frames.empty())
        {
            const CanFrame frame = frames.front();
            bytes.assign(frame.data, frame.data + frame.length_bytes);
            identifier = frame.identifier;
            frames.erase(frames.begin());
        }
        return bytes;
    }

    std::vector<CanFrame> frames{};
    std::uint32_t identifier{0U};
    int room{1000000};
};

} // namespace counterpoint::cia301

#endif
