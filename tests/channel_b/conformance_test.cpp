// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Every conformance case against channel B; its name and requirements are those of the case.
#include "verification/conformance/suite.hpp"

#include "channel_b/channel.hpp"
#include "channel_b/storage.hpp"

#include <memory>

namespace counterpoint
{
namespace
{

class ChannelBConformance : public ::testing::TestWithParam<const conformance::Case*>
{
};

TEST_P(ChannelBConformance, Case)
{
    const auto storage = std::make_unique<channel_b::StorageFor<kMaxSrdoCount, kMaxMapEntries>>();
    channel_b::Channel channel{storage->Handle()};
    conformance::RunCase(*GetParam(), channel, conformance::Party::kB);
}

INSTANTIATE_TEST_SUITE_P(All, ChannelBConformance, ::testing::ValuesIn(conformance::AllCases()), conformance::CaseName);

} // namespace
} // namespace counterpoint
