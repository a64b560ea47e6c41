// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "channel_b/channel.hpp"
#include "verification/twins/subject.hpp"

counterpoint::Channel* CounterpointSubject()
{
    using namespace counterpoint; // NOLINT(google-build-using-namespace)
    static channel_b::StorageFor<kMaxSrdoCount, kMaxMapEntries> storage;
    static channel_b::Channel channel{storage.Handle()};
    return &channel;
}
