// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/start_up/cia302/boot_transfer.hpp"

#include "canopen/cia301/base/little_endian.hpp"

namespace counterpoint::cia302
{
namespace
{

void OnHandedOver(const BootJob& job, const ObjectAddress& object) noexcept
{
    NodeStatus& status = job.record.status;
    const bool is_again = (status.object.index == object.index) && (status.object.sub == object.sub);
    job.record.is_transferring = true;
    status.object = object;
    status.abort = is_again ? status.abort : SdoAbort::kNone; // Why it is asked again stays to be told.
}

} // namespace

Got BootTransfer::Fetch(const BootJob& job, const ObjectAddress& object) noexcept
{
    Got got = Got::kNothingYet;
    if (job.record.is_transferring)
    {
        got = Take(job);
    }
    else if (sdo_.Upload(job.node, object, Room{job.record.value, 4U}, SdoMode::kNormal, job.time.now))
    {
        OnHandedOver(job, object);
    }
    if (got == Got::kDone)
    {
        const std::uint32_t size = sdo_.Outcome(job.node).size_bytes;
        job.record.status.read = cia301::FromLittleEndian(job.record.value, (size < 4U) ? size : 4U);
    }
    return got;
}

Got BootTransfer::Put(const BootJob& job, const ObjectAddress& object, const Bytes& value, const SdoMode mode) noexcept
{
    Got got = Got::kNothingYet;
    if (job.record.is_transferring)
    {
        got = Take(job);
    }
    else if (sdo_.Download(job.node, object, value, mode, job.time.now))
    {
        OnHandedOver(job, object);
    }
    return got;
}

Got BootTransfer::PutByte(const BootJob& job, const ObjectAddress& object, const std::uint8_t value) noexcept
{
    job.record.value[0] = value;
    return Put(job, object, Bytes{job.record.value, 1U}, SdoMode::kNormal);
}

Got BootTransfer::Take(const BootJob& job) noexcept
{
    const TransferState state = sdo_.State(job.node);
    Got got = Got::kNothingYet;
    if (state == TransferState::kDone)
    {
        got = Got::kDone;
        job.record.is_transferring = false;
        job.record.status.abort = SdoAbort::kNone;
    }
    else if (state != TransferState::kBusy)
    {
        got = Got::kRefused;
        job.record.is_transferring = false;
        job.record.status.abort = sdo_.Outcome(job.node).abort;
    }
    return got;
}

} // namespace counterpoint::cia302
