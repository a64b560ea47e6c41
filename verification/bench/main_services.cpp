// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// On the target: RAM of each service, and the load of a whole device.
#include "canopen/cia301/emergency/consumer.hpp"
#include "canopen/cia301/sdo/client.hpp"
#include "canopen/cia301/store/parameter_store.hpp"
#include "canopen/cia301/store/stored_parts.hpp"
#include "canopen/cia301/time/time_stamp.hpp"
#include "canopen/cia305/stored_lss.hpp"
#include "verification/bench/service_load.hpp"
#include "verification/bench/service_node.hpp"
#include "verification/target/target.hpp"

namespace
{
using namespace counterpoint;

struct RamLine
{
    const char* service;
    std::uint32_t bytes;
};

constexpr RamLine kRam[] = {
    {"dictionary", sizeof(cia301::Dictionary)},
    {"sdo_server", sizeof(cia301::SdoServer) + sizeof(cia301::SdoServerPort)},
    {"sdo_client", sizeof(cia301::SdoClient)},
    {"nmt", sizeof(cia301::NmtSlave)},
    {"heartbeat", sizeof(cia301::HeartbeatProducer) + sizeof(cia301::HeartbeatConsumer)},
    {"heartbeat_each", sizeof(cia301::SupervisedNode)},
    {"guarding", sizeof(cia301::NodeGuarding)},
    {"emergency", sizeof(cia301::EmergencyProducer) + sizeof(cia301::EmergencyConsumer) +
                      sizeof(cia301::CommunicationErrors) + sizeof(cia301::ServiceObjects)},
    {"sync", sizeof(cia301::Sync)},
    {"time", sizeof(cia301::TimeStamp)},
    {"pdo", sizeof(cia301::Tpdos) + sizeof(cia301::Rpdos) + sizeof(cia301::PdoObjects)},
    {"pdo_each", (sizeof(cia301::Tpdo) > sizeof(cia301::Rpdo)) ? sizeof(cia301::Tpdo) : sizeof(cia301::Rpdo)},
    {"pdo_field_each", sizeof(cia301::PdoField)},
    {"store", sizeof(cia301::ParameterStore) + sizeof(cia301::StoredSafety)},
    {"lss", sizeof(cia305::LssSlave) + sizeof(cia305::StoredLss)},
    {"device",
     sizeof(device::Device) + sizeof(device::Outbox) + sizeof(device::KernelWatch) + sizeof(device::SafetyObjects)},
    {"device_frame_each", sizeof(device::QueuedFrame)}};

void WriteRam(const RamLine& line) noexcept
{
    target::Write("service_ram=");
    target::Write(line.service);
    target::Write(" bytes=");
    target::WriteNumber(line.bytes);
    target::Write("\n");
}
} // namespace

extern "C" std::uint32_t TargetMain() noexcept;

extern "C" std::uint32_t TargetMain() noexcept
{
    for (const RamLine& line : kRam)
    {
        WriteRam(line);
    }
    target::StartCycles();
    // The emulator put it there.
    const auto& mix = *reinterpret_cast<const bench::Mix*>(bench::kMixAddress);
    const bench::LoadOutcome outcome = bench::RunServiceLoad(mix);
    target::Write("services: ");
    target::Write(bench::NameOf(outcome));
    target::Write("\n");
    return (outcome == bench::LoadOutcome::kDone) ? 0U : 1U;
}
