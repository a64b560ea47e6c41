// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "simulator/world/node.hpp"

#include "canopen/cia306/text/input_error.hpp"

#include <string>

// What the self tests of a node watch, and the faults of it. [SRS_SIM_052, SRS_SIM_053, SRS_SIM_055]
namespace counterpoint::simulator
{
namespace
{
/// From the times of the description on there are no pointers and no counts: a flip there is read, and leads nowhere.
MemoryPiece DescribedTimes(const DeviceConfig& config)
{
    const auto* const first = reinterpret_cast<const std::uint8_t*>(&config.cycle_us);
    const auto* const end = reinterpret_cast<const std::uint8_t*>(&config.digest + 1);
    return {const_cast<std::uint8_t*>(first), static_cast<std::size_t>(end - first)};
}
} // namespace

void Node::FurnishSelfTest()
{
    image_.TakeProgram(channel_a_->Voice(), channel_b_->Voice());
    image_.AddPart(&channel_a_->Voice());
    image_.AddPart(&channel_b_->Voice());
    image_.AddPart(static_cast<hal::SafetyOutput*>(&output_tap_));
    image_.AddPart(static_cast<hal::Watchdog*>(&watchdog_tap_));
    image_.AddPart(&assembly_.Told());
    if (peer_ != nullptr)
    {
        image_.AddPart(&peer_->VoiceA());
        image_.AddPart(&peer_->VoiceB());
    }
    if (self_test_ == nullptr)
    {
        return;
    }
    for (runtime::OwnedChannel* const channel : {channel_a_.get(), channel_b_.get()})
    {
        const runtime::Letter letter = (channel == channel_a_.get()) ? runtime::Letter::kA : runtime::Letter::kB;
        if (runtime::HasChannel(setup_.role, letter))
        {
            self_test_->AddLive(channel->Bytes(), channel->Size());
            self_test_->AddLive(&channel->Voice(), channel->VoiceSize());
        }
    }
    self_test_->AddLive(&assembly_.Core(), sizeof(Kernel));
    if (peer_ != nullptr)
    {
        self_test_->AddLive(peer_.get(), sizeof *peer_);
    }
    const DeviceConfig& config = model_.Config();
    self_test_->AddConstant(&config, sizeof config);
    self_test_->AddConstant(config.srdos, config.srdo_count * sizeof(SrdoSetup));
    if (config.object_count != 0U)
    {
        self_test_->AddConstant(config.objects, config.object_count * sizeof(MappableObject));
    }
    for (const runtime::StaticTable& table : model_.StaticTables())
    {
        self_test_->AddConstant(table.entries.data(), table.count * sizeof(std::uint32_t));
    }
    const std::uint32_t cycles = config.diagnostic_interval_us / config.cycle_us;
    if (!self_test_->Settle(cycles))
    {
        throw cia306::InputError(
            model_.File(), 0U,
            {"the self tests do not fit into the diagnostic interval of " + std::to_string(cycles) + " cycles",
             "a longer one (0x5F00:04), or 'self_tests: false' for this node"});
    }
}

std::vector<MemoryPiece> Node::WatchedPieces(const Part part)
{
    switch (part)
    {
    case Part::kConstants:
        return {DescribedTimes(model_.Config())};
    case Part::kStackGuard:
        return image_.Guard();
    case Part::kTablePointer:
        return image_.Pointers();
    default:
        return image_.Program();
    }
}

void Node::FlipBit(const Part part, const std::uint8_t srdo, const runtime::BitPlace& place)
{
    FlipIn(PiecesOfPart(part, srdo), place.offset, place.bit);
    may_be_wild_ = may_be_wild_ || part == Part::kTablePointer;
}

void Node::StickBit(const FaultSetup& fault, const runtime::BitPlace& place, const std::size_t index)
{
    std::size_t offset = place.offset;
    for (const MemoryPiece& piece : PiecesOfPart(fault.part, 0U))
    {
        if (offset < piece.size)
        {
            memory_.Stick({piece.bytes + offset, place.bit, fault.level, index});
            NoteEffects();
            return;
        }
        offset -= piece.size;
    }
}

void Node::StandStill()
{
    is_hung_ = true;
    SettleNextEvent();
    journal_.Note({Now(), EventKind::kHung, place_.index, 0U, 2U, 0U});
}

void Node::RequireSound()
{
    if (may_be_wild_ && image_.IsWild())
    {
        faults_.Trap();
    }
}

// A cycle that ended before any part was called told nobody.
void Node::NoteSelfTest()
{
    application_.NoteUntold(assembly_.Core().DeviceState());
    const bool has_failed = self_test_ != nullptr && self_test_->FirstFailed() != selftest::TestId::kNone;
    if (has_failed && !has_told_test_)
    {
        journal_.Tell(
            {Now(), EventKind::kSelfTest, place_.index, 0U, static_cast<std::uint64_t>(self_test_->FirstFailed()), 0U});
    }
    has_told_test_ = has_failed;
}
} // namespace counterpoint::simulator
