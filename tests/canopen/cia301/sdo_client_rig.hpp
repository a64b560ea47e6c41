// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TESTS_CANOPEN_CIA301_SDO_CLIENT_RIG_HPP
#define TESTS_CANOPEN_CIA301_SDO_CLIENT_RIG_HPP

#include "canopen/cia301/sdo/client.hpp"
#include "canopen/cia301/sdo/server_port.hpp"
#include "tests/canopen/cia301/keeping_sink.hpp"
#include "tests/canopen/cia301/sdo_rig.hpp"

#include <array>
#include <cstdint>

namespace counterpoint::cia301
{

/// A client (time-out 1000 us, blocks of 5 segments) and the server of SdoRig as node 5, with a wire between them that
/// the test pulls.
class SdoClientRig : public SdoRig
{
  public:
    [[nodiscard]] Moment Now() const
    {
        return Moment{NodeState::kPreOperational, Instant{now_us}};
    }
    /// Carries frames both ways until nobody sends any more.
    void Carry()
    {
        for (int i = 0; i < 2000; ++i)
        {
            client.OnCycle(Instant{now_us});
            port.OnCycle(Now());
            if (requests.frames.empty() && answers.frames.empty())
            {
                break;
            }
            while (!requests.frames.empty())
            {
                port.OnFrame(requests.frames.front(), Now());
                requests.frames.erase(requests.frames.begin());
            }
            while (!answers.frames.empty())
            {
                client.OnFrame(answers.frames.front(), Instant{now_us});
                answers.frames.erase(answers.frames.begin());
            }
        }
    }
    void Answer(const Octets& bytes)
    {
        CanFrame frame{0x585U, FrameKind::kData, CanPortId::kFirst, 8U, {}};
        std::copy(bytes.begin(), bytes.end(), frame.data);
        client.OnFrame(frame, Instant{now_us});
    }
    bool Upload(std::uint16_t index, SdoMode mode, std::uint32_t size = 2000U)
    {
        return client.StartUpload({index, 0U}, Room{got.data(), size}, mode, Instant{now_us});
    }
    bool Download(std::uint16_t index, const Octets& value, SdoMode mode)
    {
        given = value;
        return client.StartDownload({index, 0U}, {given.data(), static_cast<std::uint32_t>(given.size())}, mode,
                                    Instant{now_us});
    }
    /// The outcome's code, with the busy bit pattern FFFFFFFFh while a transfer runs.
    [[nodiscard]] std::uint32_t Result() const
    {
        const bool is_busy = (client.State() == SdoClientState::kBusy);
        return is_busy ? 0xFFFFFFFFU : static_cast<std::uint32_t>(client.Outcome().abort);
    }

    KeepingSink requests{};
    KeepingSink answers{};
    std::array<std::uint8_t, 2100> got{};
    Octets given{};
    SdoServerPort port{server, answers, NodeId{5U}};
    SdoClient client{SdoClientParts{requests, NodeId{5U}, 1000U, 5U}};
};

} // namespace counterpoint::cia301

#endif
