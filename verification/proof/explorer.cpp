// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/proof/explorer.hpp"

#include <algorithm>
#include <utility>

namespace counterpoint::proof
{

namespace
{
constexpr std::uint32_t kRoot = 0U;
}

Explorer::Explorer(World& world, const Domain& domain, const Reach& reach)
    : world_{world}, domain_{domain}, reach_{reach}
{
}

std::vector<std::string> Explorer::StoryOf(const std::uint32_t path) const
{
    std::vector<std::string> story;
    for (std::uint32_t at = path; at != kRoot; at = paths_[at].from)
    {
        story.push_back(domain_.letters[paths_[at].letter].text);
    }
    std::reverse(story.begin(), story.end());
    return story;
}

void Explorer::Meet(const Marked& marked, const Standing& from, const std::size_t letter)
{
    const auto [place, is_new] = known_.emplace(marked.key, static_cast<std::uint32_t>(futures_.size()));
    const std::uint32_t state = place->second;
    const std::uint32_t path = static_cast<std::uint32_t>(paths_.size());
    if (is_new)
    {
        twin_counts_.push_back(0U);
        futures_.push_back(0U);
        static_cast<void>(marks_.insert(marked.mark));
        next_.push_back(Standing{state, path, world_.Save()});
    }
    else if ((twin_counts_[state] < reach_.most_twins) && marks_.insert(marked.mark).second)
    {
        ++twin_counts_[state];
        twins_.push_back(Standing{state, path, world_.Save()});
    }
    else
    {
        return;
    }
    paths_.push_back(Origin{from.path, static_cast<std::uint8_t>(letter)});
}

std::uint64_t Explorer::Drive(const Standing& standing, const bool is_twin)
{
    std::uint64_t future = 0U;
    for (std::size_t letter = 0U; letter < domain_.letters.size(); ++letter)
    {
        world_.Restore(standing.snapshot);
        const SrdoState before = world_.Now().state;
        const Answer answer = world_.Apply(domain_.letters[letter]);
        if (!answer.is_possible)
        {
            continue;
        }
        if (!answer.refused.empty())
        {
            result_.refused = answer.refused;
            result_.story = StoryOf(standing.path);
            result_.story.push_back(domain_.letters[letter].text);
            return future;
        }
        const SrdoState now = world_.Now().state;
        result_.transitions += is_twin ? 0U : 1U;
        result_.releases += ((now == SrdoState::kReleased) && (before != now) && !is_twin) ? 1U : 0U;
        result_.faults += ((now == SrdoState::kFaulted) && (before != now) && !is_twin) ? 1U : 0U;
        const Marked marked = image_.MarkedOf(world_, reach_.sight);
        future = (future ^ answer.visible ^ marked.key[0]) * 0x9E3779B97F4A7C15U;
        Meet(marked, standing, letter);
    }
    return future;
}

/// The key leaves out what is said to decide nothing: then whoever shares a key goes on alike.
void Explorer::DriveTwins()
{
    std::vector<Standing> twins;
    std::swap(twins, twins_);
    for (const Standing& twin : twins)
    {
        if (futures_[twin.state] == 0U)
        {
            twins_.push_back(twin); // Its state is driven at the next depth.
            continue;
        }
        const std::uint64_t future = Drive(twin, true);
        ++result_.twins;
        if (result_.refused.empty() && (future != futures_[twin.state]))
        {
            result_.refused = "states under one key go on in two ways";
            result_.story = StoryOf(twin.path);
        }
        if (!result_.refused.empty())
        {
            return;
        }
    }
}

Result Explorer::Run()
{
    result_.refused = image_.Learn(world_, MakeDomains().back().letters, reach_.base_us);
    result_.words = image_.Summary();
    world_.Start(reach_.base_us);
    paths_.push_back(Origin{kRoot, 0U});
    twin_counts_.push_back(0U);
    futures_.push_back(0U);
    known_.emplace(image_.MarkedOf(world_, reach_.sight).key, kRoot);
    next_.push_back(Standing{kRoot, kRoot, world_.Save()});
    while (result_.refused.empty() && (result_.depth < reach_.depth) && (known_.size() < reach_.most_states))
    {
        std::vector<Standing> standing;
        std::swap(standing, next_);
        for (const Standing& one : standing)
        {
            futures_[one.state] = Drive(one, false);
            if (!result_.refused.empty())
            {
                break;
            }
        }
        if (result_.refused.empty())
        {
            DriveTwins();
            ++result_.depth;
        }
        if (next_.empty() && twins_.empty())
        {
            result_.is_closed = true;
            break;
        }
    }
    result_.states = known_.size();
    return result_;
}

} // namespace counterpoint::proof
