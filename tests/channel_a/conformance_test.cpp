// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Every conformance case against channel A; its name and requirements are those of the case.
#include "verification/conformance/suite.hpp"

#include "channel_a/channel.hpp"
#include "channel_a/storage.hpp"

#include <memory>

namespace counterpoint
{
namespace
{

class ChannelAConformance : public ::testing::TestWithParam<const conformance::Case*>
{
};

TEST_P(ChannelAConformance, Case)
{
    const auto storage = std::make_unique<channel_a::StorageFor<kMaxSrdoCount, kMaxMapEntries>>();
    channel_a::Channel channel{storage->Handle()};
    conformance::RunCase(*GetParam(), channel, conformance::Party::kA);
}

INSTANTIATE_TEST_SUITE_P(All, ChannelAConformance, ::testing::ValuesIn(conformance::AllCases()), conformance::CaseName);

} // namespace
} // namespace counterpoint
