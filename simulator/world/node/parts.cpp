// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "simulator/world/node/parts.hpp"

#include "safety_core/kernel/limits.hpp"

#include <string>

namespace counterpoint::simulator
{
namespace
{
using runtime::Letter;

/// From the times of the description on there are no pointers and no counts: a flip there is read, and leads nowhere.
MemoryPiece DescribedTimes(const DeviceConfig& config)
{
    const auto* const first = reinterpret_cast<const std::uint8_t*>(&config.cycle_us);
    const auto* const end = reinterpret_cast<const std::uint8_t*>(&config.digest + 1);
    return {const_cast<std::uint8_t*>(first), static_cast<std::size_t>(end - first)};
}
} // namespace

NodeParts::NodeParts(const NodeInside& inside, runtime::DeviceAssembly& assembly) : inside_(inside), assembly_(assembly)
{
    AddPointers();
    if (inside.self_test == nullptr)
    {
        return;
    }
    AddMemory(*inside.self_test);
    // [SRS_SIM_052]
    const DeviceConfig& config = inside.model.Config();
    const std::uint32_t cycles = config.diagnostic_interval_us / LateCycleUs(config);
    if (!inside.self_test->Settle(cycles))
    {
        throw SelfTestMisfit(
            inside.model.File(), inside.model.IntervalPlace(),
            {"the self tests do not fit into the diagnostic interval of " + std::to_string(cycles) + " cycles",
             "a longer one (0x5F00:04), or 'self_tests: false' for this node"});
    }
}

void NodeParts::AddPointers()
{
    NodeImage& image = inside_.processor.Image();
    Channel& channel_a = inside_.channels.Owned(Letter::kA).Voice();
    Channel& channel_b = inside_.channels.Owned(Letter::kB).Voice();
    image.TakeProgram(channel_a, channel_b);
    image.AddPart(&channel_a);
    image.AddPart(&channel_b);
    image.AddPart(&inside_.outputs.Output());
    image.AddPart(&inside_.outputs.Supervision());
    image.AddPart(&assembly_.Told());
    if (Peer* const peer = inside_.channels.Peer(); peer != nullptr)
    {
        image.AddPart(&peer->VoiceA());
        image.AddPart(&peer->VoiceB());
    }
}

void NodeParts::AddMemory(NodeSelfTest& self_test)
{
    for (const Letter letter : {Letter::kA, Letter::kB})
    {
        if (runtime::HasChannel(inside_.setup.role, letter))
        {
            runtime::OwnedChannel& channel = inside_.channels.Owned(letter);
            self_test.AddLive(channel.Bytes(), channel.Size());
            self_test.AddLive(&channel.Voice(), channel.VoiceSize());
        }
    }
    self_test.AddLive(&assembly_.Core(), sizeof(Kernel));
    if (Peer* const peer = inside_.channels.Peer(); peer != nullptr)
    {
        self_test.AddLive(peer, sizeof *peer);
    }
    const DeviceConfig& config = inside_.model.Config();
    self_test.AddConstant(&config, sizeof config);
    self_test.AddConstant(config.srdos, config.srdo_count * sizeof(SrdoSetup));
    if (config.object_count != 0U)
    {
        self_test.AddConstant(config.objects, config.object_count * sizeof(MappableObject));
    }
    for (const runtime::StaticTable& table : inside_.model.StaticTables())
    {
        self_test.AddConstant(table.entries.data(), table.count * sizeof(std::uint32_t));
    }
}

std::vector<MemoryPiece> NodeParts::PiecesOf(const Part part, const std::uint8_t srdo)
{
    switch (part)
    {
    case Part::kChannelA:
    case Part::kChannelB:
    {
        runtime::OwnedChannel& channel = inside_.channels.Owned((part == Part::kChannelA) ? Letter::kA : Letter::kB);
        return {{channel.Bytes(), channel.Size()}};
    }
    case Part::kSetup:
    case Part::kSafeValue:
    case Part::kObjects:
    case Part::kVariables:
        return simulator::PiecesOf(part, inside_.model, srdo);
    case Part::kConstants:
        return {DescribedTimes(inside_.model.Config())};
    case Part::kStackGuard:
        return inside_.processor.Image().Guard();
    case Part::kTablePointer:
        return inside_.processor.Image().Pointers();
    case Part::kProgram:
        return inside_.processor.Image().Program();
    default:
        return simulator::PiecesOf(part, assembly_.Core(), inside_.processor.Flow());
    }
}

void NodeParts::Flip(const Part part, const std::uint8_t srdo, const runtime::BitPlace& place)
{
    if (part == Part::kTablePointer)
    {
        inside_.processor.Image().DoubtPointers();
    }
    FlipIn(PiecesOf(part, srdo), place.offset, place.bit);
}

void NodeParts::Stick(const FaultSetup& fault, const runtime::BitPlace& place, const std::size_t index)
{
    std::size_t offset = place.offset;
    for (const MemoryPiece& piece : PiecesOf(fault.part, 0U))
    {
        if (offset < piece.size)
        {
            inside_.processor.Memory().Stick({piece.bytes + offset, place.bit, fault.level, index});
            inside_.processor.NoteEffects();
            return;
        }
        offset -= piece.size;
    }
}
} // namespace counterpoint::simulator
