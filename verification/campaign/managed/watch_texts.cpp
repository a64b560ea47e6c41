// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/campaign/managed/watch.hpp"

namespace counterpoint::campaign::managed
{
namespace
{
constexpr std::array<const char*, kWrongCount> kWrongTexts{
    "",
    "a start of all, with a safety slave in the network",
    "a safety slave was started before its verification had succeeded",
    "a safety slave was started with another configuration than was expected",
    "another device than was expected was started",
    "a safety slave with another configuration runs on",
    "two active managers",
    "output open outside of OPERATIONAL",
    "output open again without an acknowledge",
    "output open with data that are too old or nobody's",
    "a frame under a foreign identifier",
    "the program ended"};
constexpr std::array<const char*, kLimitCount> kLimitTexts{
    "",
    "a safety configuration changed without a message, behind its last reading",
    "a slave runs by a command that no manager gave to it then",
    "1300h was written by somebody else behind the start",
    "between a slave with another configuration and the managers, or between these, there is no bus",
    "a manager whose memory or clock is wrong broke a rule of its own; each safety slave is as it has to be",
    "a manager whose memory or clock is wrong lets a safety slave with another configuration run; its own signature "
    "(13FFh, 13FEh) keeps it from its SRDOs"};
} // namespace

const char* TextOf(const Wrong wrong)
{
    return kWrongTexts.at(static_cast<std::size_t>(wrong));
}

const char* TextOf(const Limit limit)
{
    return kLimitTexts.at(static_cast<std::size_t>(limit));
}
} // namespace counterpoint::campaign::managed
