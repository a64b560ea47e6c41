// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// The network manager as a device would have it: nothing here but the wire is simulated. Time line of each scene: power
// on of all at 0 ms; what else happens, its step says. [SRS_TGT_010]
#include "verification/target/manager/scenes.hpp"

#include "examples/firmware/common/cell.hpp"
#include "examples/network_manager/network.hpp"
#include "verification/target/manager/drive_node.hpp"
#include "verification/target/manager/manager_node.hpp"
#include "verification/target/target.hpp"

namespace counterpoint::target
{
namespace
{

using cia301::NodeState;

struct Scene
{
    const char* name;
    DriveDifference drive;
    bool has_two_managers;
    std::uint32_t drive_off_ms; ///< 0: never.
    std::uint32_t drive_on_ms;
    std::uint32_t best_off_ms; ///< The second manager, which has the higher priority; 0: never.
    std::uint32_t end_ms;
    NodeState wanted; ///< Of the drive at the end.
};

constexpr Scene kScenes[]{
    {"as_expected", {0U, 0U}, false, 0U, 0U, 0U, 1000U, NodeState::kOperational},
    {"other_sct", {60U, 0U}, false, 0U, 0U, 0U, 1000U, NodeState::kPreOperational},
    {"other_serial", {0U, 34U}, false, 0U, 0U, 0U, 1000U, NodeState::kPreOperational},
    {"drive_lost", {0U, 0U}, false, 500U, 1500U, 0U, 2500U, NodeState::kOperational},
    {"master_lost", {0U, 0U}, true, 0U, 0U, 4000U, 12000U, NodeState::kOperational},
};

firmware::Cell<ManagerNode> first_room;
firmware::Cell<ManagerNode> second_room;
firmware::Cell<DriveNode> drive_room;

void WriteSceneEnd(const Scene& scene, const Wire& wire, const DriveNode& drive, const bool has_passed) noexcept
{
    Write("run=");
    Write(scene.name);
    Write(" frames=");
    WriteNumber(wire.Frames());
    Write(" hash=");
    WriteHex(wire.Hash());
    Write(" drive=");
    WriteNumber(static_cast<std::uint32_t>(drive.State()));
    Write(has_passed ? " failures=0 passed\n" : " failures=1 failed\n");
}

/// No election and no start releases an output: nobody acknowledges here.
bool Play(const Scene& scene) noexcept
{
    constexpr std::uint32_t kDrivePlace = 2U;
    Wire wire{};
    DriveNode* drive = &drive_room.Make(scene.drive);
    wire.Plug(kDrivePlace, drive);
    wire.Plug(0U, &first_room.Make(scene.has_two_managers ? examples::FlyingSettings(examples::kFirstManager)
                                                          : examples::AloneSettings()));
    if (scene.has_two_managers)
    {
        wire.Plug(1U, &second_room.Make(examples::FlyingSettings(examples::kSecondManager)));
    }
    SrdoMask open = 0U;
    for (std::uint32_t ms = 1U; ms <= scene.end_ms; ++ms)
    {
        if (ms == scene.drive_off_ms)
        {
            wire.Plug(kDrivePlace, nullptr);
        }
        if (ms == scene.drive_on_ms)
        {
            drive = &drive_room.Make(scene.drive);
            wire.Plug(kDrivePlace, drive);
        }
        if (ms == scene.best_off_ms)
        {
            wire.Plug(1U, nullptr);
        }
        wire.Pass();
        open |= drive->Open();
    }
    const bool has_passed = (drive->State() == scene.wanted) && (open == 0U);
    WriteSceneEnd(scene, wire, *drive, has_passed);
    return has_passed;
}

} // namespace

std::uint32_t PlayScenes() noexcept
{
    std::uint32_t failures = 0U;
    for (const Scene& scene : kScenes)
    {
        failures += Play(scene) ? 0U : 1U;
    }
    Write("room of a manager: ");
    WriteNumber(sizeof(examples::ManagerDevice));
    Write(" bytes\n");
    return failures;
}

} // namespace counterpoint::target
