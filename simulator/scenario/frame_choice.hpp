// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SIMULATOR_SCENARIO_FRAME_CHOICE_HPP
#define SIMULATOR_SCENARIO_FRAME_CHOICE_HPP

#include "simulator/scenario/values.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace counterpoint::simulator
{
/// Chooses frames. A fault hits the frames that fit, from the `first`-th one on, every `every`-th, at most `count` of
/// them.
struct FrameChoice
{
    std::vector<std::uint32_t> identifiers; ///< None: any.
    std::optional<NodeIndex> srdo_of;       ///< The frames of SRDO `srdo` of this node, both or one of them.
    std::uint8_t srdo{0U};
    bool has_normal{true};
    bool has_inverse{true};
    std::optional<NodeIndex> sender;
    std::optional<NodeIndex> receiver; ///< None: for all receivers.
    std::uint32_t controller{0U};      ///< Controller of the receiver; 0: each.
    Nanoseconds from{0};
    Nanoseconds until{kNever};
    Nanoseconds on{0}; ///< 0: all the time.
    Nanoseconds off{0};
    std::uint32_t first{1U};
    std::uint32_t every{1U};
    std::uint32_t count{1U};
    std::uint32_t probability_ppm{1000000U};
};

/// Whether normal frames, which have odd identifiers, are among the chosen frames.
[[nodiscard]] inline bool ChoosesNormal(const FrameChoice& choice)
{
    bool is_odd = choice.identifiers.empty() && choice.has_normal;
    for (const std::uint32_t identifier : choice.identifiers)
    {
        is_odd = is_odd || (identifier & 1U) != 0U;
    }
    return is_odd;
}
} // namespace counterpoint::simulator

#endif // SIMULATOR_SCENARIO_FRAME_CHOICE_HPP
