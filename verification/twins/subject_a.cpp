// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "channel_a/channel.hpp"
#include "verification/twins/subject.hpp"

counterpoint::Channel* CounterpointSubject()
{
    using namespace counterpoint; // NOLINT(google-build-using-namespace)
    static channel_a::StorageFor<kMaxSrdoCount, kMaxMapEntries> storage;
    static channel_a::Channel channel{storage.Handle()};
    return &channel;
}
