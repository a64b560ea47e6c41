// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/start_up/cia302/boot_configuration.hpp"

#include "canopen/cia301/base/little_endian.hpp"
#include "canopen/cia302/network/text_dcf.hpp"

namespace counterpoint::cia302
{
namespace
{

constexpr ObjectAddress kDate{0x1020U, 1U};
constexpr ObjectAddress kTime{0x1020U, 2U};
constexpr std::uint16_t kRestoreIndex = 0x1011U;
constexpr std::uint16_t kTextIndex = 0x1F20U;
constexpr std::uint16_t kConciseIndex = 0x1F22U;
constexpr std::uint8_t kLoad[4] = {0x6CU, 0x6FU, 0x61U, 0x64U}; ///< "load"
constexpr std::uint8_t kCommunicationSub = 2U;

/// What an SDO of the configuration came to, if it leads to `done`.
BootFinding Written(const Got got, const BootEvent done) noexcept
{
    return (got == Got::kRefused) ? Failed('J') : Found((got == Got::kDone) ? done : BootEvent::kNone);
}

/// The domain of the master, not the slave, is wrong: its own object is named.
BootFinding RefuseDomain(const BootJob& job, const std::uint16_t index) noexcept
{
    job.record.status.object = ObjectAddress{index, job.node.value};
    job.record.status.abort = SdoAbort::kNoDictionary;
    return Failed('J');
}

} // namespace

BootFinding BootConfiguration::Work(const BootJob& job) noexcept
{
    const BootState state = job.record.state;
    BootFinding finding = Found(BootEvent::kNone);
    if (state == BootState::kRestore)
    {
        finding = Restore(job);
    }
    else if (state == BootState::kRestoreReset)
    {
        finding = ResetRestored(job);
    }
    else if (state == BootState::kText)
    {
        finding = WriteText(job);
    }
    else if (state == BootState::kConcise)
    {
        finding = WriteConcise(job);
    }
    else
    {
        finding = CompareDate(job);
    }
    return finding;
}

/// A slave that does not tell them is configured.
BootFinding BootConfiguration::CompareDate(const BootJob& job) noexcept
{
    const std::uint32_t date = job.setup.configuration_date;
    const std::uint32_t time = job.setup.configuration_time;
    const bool is_date = (job.record.state == BootState::kConfigurationDate);
    BootEvent event = BootEvent::kSkip;
    if ((date != 0U) && (time != 0U))
    {
        const Got got = transfer_.Fetch(job, is_date ? kDate : kTime);
        const bool is_same = (got == Got::kDone) && (job.record.status.read == (is_date ? date : time));
        event = is_same ? BootEvent::kDone : BootEvent::kNone;
        if (!is_same && (got != Got::kNothingYet))
        {
            job.record.status.abort = SdoAbort::kNone;
            event = BootEvent::kElse;
        }
    }
    return Found(event);
}

BootFinding BootConfiguration::Restore(const BootJob& job) noexcept
{
    BootFinding finding = Found(BootEvent::kSkip);
    if (!IsRestoreUnasked(job))
    {
        const ObjectAddress object{kRestoreIndex, job.setup.restore_sub};
        finding = Written(transfer_.Put(job, object, Bytes{kLoad, 4U}, SdoMode::kNormal), BootEvent::kDone);
    }
    return finding;
}

BootFinding BootConfiguration::ResetRestored(const BootJob& job) noexcept
{
    const bool is_communication = (job.setup.restore_sub == kCommunicationSub);
    const NmtCommand command = is_communication ? NmtCommand::kResetCommunication : NmtCommand::kResetNode;
    BootEvent event = BootEvent::kNone;
    if (IsRestoreUnasked(job))
    {
        event = BootEvent::kSkip;
    }
    else if (parts_.nmt.Request(command, job.node, job.time.now) == NmtAnswer::kTaken)
    {
        event = BootEvent::kDone;
    }
    return Found(event);
}

/// Object by object. The text is read once for each: what runs needs to know only where it goes on.
BootFinding BootConfiguration::WriteText(const BootJob& job) noexcept
{
    BootFinding finding = Found(BootEvent::kNone);
    if (job.record.is_transferring)
    {
        finding = Written(transfer_.Take(job), BootEvent::kElse);
        job.record.offset = (finding.event == BootEvent::kElse) ? job.record.next : job.record.offset;
    }
    else
    {
        const TextReading entry = ReadTextDcf(job.setup.dcf, job.record.offset, job.node);
        if (entry.state == TextState::kMalformed)
        {
            finding = RefuseDomain(job, kTextIndex);
        }
        else if ((entry.state == TextState::kEnd) && !IsConcise(job.setup.concise_dcf))
        {
            finding = RefuseDomain(job, kConciseIndex); // Before any of it is written.
        }
        else if (entry.state == TextState::kEnd)
        {
            finding = Found(BootEvent::kDone);
        }
        else
        {
            cia301::ToLittleEndian(entry.number, job.record.value, sizeof(job.record.value));
            const Bytes number{job.record.value, entry.size_bytes};
            const Bytes value = (entry.text == nullptr) ? number : Bytes{entry.text, entry.size_bytes};
            job.record.next = entry.next;
            static_cast<void>(transfer_.Put(job, entry.object, value, SdoMode::kNormal));
        }
    }
    return finding;
}

/// Entry by entry. The position is moved when an entry was taken.
BootFinding BootConfiguration::WriteConcise(const BootJob& job) noexcept
{
    const ConciseReading entry = ReadConcise(job.setup.concise_dcf, job.record.position);
    BootFinding finding = Found(BootEvent::kNone);
    if (entry.state == ConciseState::kMalformed)
    {
        finding = RefuseDomain(job, kConciseIndex);
    }
    else if (entry.state == ConciseState::kEnd)
    {
        finding = Found(job.record.is_extra ? BootEvent::kSkip : BootEvent::kDone); // An extra is not supervised anew.
    }
    else
    {
        finding = Written(transfer_.Put(job, entry.object, entry.value, SdoMode::kNormal), BootEvent::kElse);
        job.record.position = (finding.event == BootEvent::kElse) ? entry.next : job.record.position;
    }
    return finding;
}

} // namespace counterpoint::cia302
