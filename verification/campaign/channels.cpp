// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/campaign/channels.hpp"

#include "channel_a/channel.hpp"
#include "channel_a/storage.hpp"
#include "channel_b/channel.hpp"
#include "channel_b/storage.hpp"

#include <stdexcept>

namespace counterpoint::campaign
{
namespace
{
template <typename Member>
void Add(MadeChannel& made, const Part part, const Region& region, const char* const name, const Member& member)
{
    const std::string prefix = (part == Part::kChannelA) ? "channel_a." : "channel_b.";
    made.places.push_back({part, prefix + name, region.OffsetOf(&member), sizeof(member)});
}

template <std::uint8_t kSlots, std::uint8_t kEntries> MadeChannel MakeA(Region& region)
{
    MadeChannel made;
    auto& memory = region.Make<channel_a::StorageFor<kSlots, kEntries>>();
    auto& voice = region.Make<channel_a::Channel>(memory.Handle());
    made.voice = &voice;
    const auto add = [&made, &region](const char* const name, const auto& member)
    { Add(made, Part::kChannelA, region, name, member); };
    add("records", memory.records);
    add("entries", memory.entries);
    add("steps", memory.steps);
    add("counts", memory.counts);
    add("look_up", memory.look_up);
    add("object", voice);
    return made;
}

template <std::uint8_t kSlots, std::uint8_t kEntries> MadeChannel MakeB(Region& region)
{
    MadeChannel made;
    auto& memory = region.Make<channel_b::StorageFor<kSlots, kEntries>>();
    auto& voice = region.Make<channel_b::Channel>(memory.Handle());
    made.voice = &voice;
    const auto add = [&made, &region](const char* const name, const auto& member)
    { Add(made, Part::kChannelB, region, name, member); };
    add("data", memory.data);
    add("pending", memory.pending);
    add("mapped", memory.mapped);
    add("fields", memory.fields);
    add("entries", memory.entries);
    add("left", memory.left);
    add("limit", memory.limit);
    add("srvt_left", memory.srvt_left);
    add("srvt_limit", memory.srvt_limit);
    add("phase_left", memory.phase_left);
    add("ordinal", memory.ordinal);
    add("causes", memory.causes);
    add("signals", memory.signals);
    add("error_count", memory.error_count);
    add("places", memory.places);
    add("image", memory.image);
    add("length_bytes", memory.length_bytes);
    add("first_cause", memory.first_cause);
    add("held", memory.held);
    add("granted", memory.granted);
    add("edge", memory.edge);
    add("valid", memory.valid);
    add("resolved", memory.resolved);
    add("stage", memory.stage);
    add("policy", memory.policy);
    add("form", memory.form);
    add("detection", memory.detection);
    add("slot_of", memory.slot_of);
    add("device", memory.device);
    add("object", voice);
    return made;
}

/// The least room that is enough, of those that are compiled.
template <typename Small, typename Two, typename Eight>
MadeChannel Least(const ChannelRoom& room, const Small& small, const Two& two, const Eight& eight)
{
    if (room.slots > 8U || room.map_entries > kUsualMapEntries)
    {
        throw std::runtime_error("a device with more than 8 SRDOs or 16 entries in a mapping is not hit yet");
    }
    if (room.slots == 1U)
    {
        return small();
    }
    return (room.slots == 2U) ? two() : eight();
}
} // namespace

MadeChannel MakeChannelA(Region& region, const ChannelRoom& room)
{
    return Least(
        room, [&region]() { return MakeA<1U, kUsualMapEntries>(region); }, [&region]()
        { return MakeA<2U, kUsualMapEntries>(region); }, [&region]() { return MakeA<8U, kUsualMapEntries>(region); });
}

MadeChannel MakeChannelB(Region& region, const ChannelRoom& room)
{
    return Least(
        room, [&region]() { return MakeB<1U, kUsualMapEntries>(region); }, [&region]()
        { return MakeB<2U, kUsualMapEntries>(region); }, [&region]() { return MakeB<8U, kUsualMapEntries>(region); });
}
} // namespace counterpoint::campaign
