// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_CAMPAIGN_MANAGED_REFERENCE_HPP
#define VERIFICATION_CAMPAIGN_MANAGED_REFERENCE_HPP

#include "hal/host/virtual/bus.hpp"
#include "verification/campaign/managed/memory.hpp"

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace counterpoint::campaign::managed
{
using runtime::Nanoseconds;

/// What must never happen. Outcome::detail of what is silent. [SRS_CMG_072]
enum class Wrong : std::uint8_t
{
    kNothing = 0U,
    kStartOfAll = 1U,    ///< A start to node 0, with a safety slave in the network.
    kUnverified = 2U,    ///< A safety slave is started, and not all of it was read as expected.
    kConfiguration = 3U, ///< A safety slave is started that was changed before it was read.
    kIdentity = 4U,      ///< Another device is started.
    kRunsOn = 5U,        ///< A safety slave with another configuration runs longer than `stop_within`.
    kTwoMasters = 6U,
    kNoLeave = 7U,       ///< Output open outside of OPERATIONAL.
    kNoAcknowledge = 8U, ///< Open again without an acknowledge.
    kData = 9U,
    kIdentifier = 10U,
    kCrash = 11U, ///< The program ended.
};

/// Limits that documents name. Outcome::detail of what is listed. [SRS_CMG_073]
enum class Limit : std::uint8_t
{
    kNothing = 0U,
    kChangedBehind = 1U, ///< A safety configuration changed without a message, behind its last reading.
    kForeignStart = 2U,  ///< A slave runs by a command that no manager gave to it then.
    kApart = 4U,         ///< Slave and managers do not hear each other any more.
    kGfcBehind = 3U,     ///< 1300h was written behind the start, which is possible in every state.
    kOwnRule = 5U,       ///< A manager whose memory or clock is wrong broke a rule; every device is as it has to be.
    kOwnGate = 6U,       ///< Such a manager lets a slave run that holds itself back: 13FEh, or a device fault.
};

constexpr std::size_t kWrongCount = 12U;
constexpr std::size_t kLimitCount = 7U;
[[nodiscard]] const char* TextOf(Wrong wrong);
[[nodiscard]] const char* TextOf(Limit limit);

/// A frame of the run without fault.
struct RecordedFrame
{
    host::BusTime start{0};
    host::BusTime end{0}; ///< When its sender was told of it.
    CanFrame frame{};
    host::NodeIndex sender{0U};
};

/// What is seen of a network each ms.
struct Picture
{
    std::vector<std::uint32_t> words;  ///< States and outputs of the devices, and what the managers know.
    std::vector<std::uint64_t> values; ///< Of each pair of a consumer.

    [[nodiscard]] bool operator==(const Picture& other) const
    {
        return words == other.words && values == other.values;
    }
};

/// The run without fault, which all others are compared with.
struct Reference
{
    std::vector<RecordedFrame> frames;
    std::vector<Picture> pictures; ///< Of each ms.
    std::map<host::NodeIndex, std::set<std::uint32_t>> identifiers;
    std::map<host::NodeIndex, std::uint64_t> hashes;           ///< Of all frames of a sender.
    std::map<std::string, std::uint32_t> told;                 ///< How often.
    std::set<std::pair<std::size_t, std::uint32_t>> automatic; ///< Device and slot that open without an acknowledge.
    std::vector<ManagerMember> memory;                         ///< Of a plan that hits it.
};
} // namespace counterpoint::campaign::managed

#endif // VERIFICATION_CAMPAIGN_MANAGED_REFERENCE_HPP
