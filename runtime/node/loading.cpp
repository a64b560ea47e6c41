// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "runtime/node/loading.hpp"

#include "canopen/cia306/text/input_error.hpp"

#include <utility>

namespace counterpoint::runtime
{
NodeLoading::NodeLoading(const DeviceModel& model, NodeSelfTest* const self_test, NodeReport& report)
    : model_(model), self_test_(self_test), report_(report)
{
}

void NodeLoading::TellSelfTest()
{
    const std::string failure = (self_test_ == nullptr) ? "" : self_test_->Failure();
    if (!failure.empty() && !has_told_test_)
    {
        report_.Tell(now_ns_, "self test failed: " + failure, "self_test", {{"failed", failure}});
    }
    has_told_test_ = !failure.empty();
}

bool NodeLoading::TakeRestart() noexcept
{
    return std::exchange(has_restarted_, false);
}

bool NodeLoading::TakeReset() noexcept
{
    return std::exchange(has_reset_, false);
}

void NodeLoading::OnStart() noexcept
{
    if (self_test_ != nullptr)
    {
        has_told_test_ = false;
        self_test_->Start();
        TellSelfTest();
    }
}

void NodeLoading::OnNoStart(const StartResult result) noexcept
{
    const auto reason = static_cast<unsigned>(result);
    report_.Tell(now_ns_, "the kernel refuses this device, reason " + std::to_string(reason) + " of StartResult",
                 "no_start", {{"reason", reason}});
}

/// What is wrong with the store's file is told once, not at each reset.
void NodeLoading::OnLoaded(const std::uint8_t groups) noexcept
{
    has_restarted_ = has_restarted_ || (groups & cia301::kApplicationGroup) != 0U;
    const std::string warning = (store_ == nullptr) ? "" : store_->Load(groups);
    if (!warning.empty() && warning != store_warning_)
    {
        report_.Tell(now_ns_, warning, "store", {{"text", warning}});
        store_warning_ = warning;
    }
}

void NodeLoading::OnRefused(const ConfigurationWrite& write, const AbortCode code) noexcept
{
    const std::string text = model_.File() + ":" + std::to_string(write.line) +
                             ": warning: " + cia306::ObjectName(write.object.index, write.object.sub) +
                             ": the kernel refuses " + cia306::Hex(write.value, write.size_bytes * 2) +
                             " with abort code " + AbortText(code) + ", expected what 'counterpoint check' finds right";
    report_.Tell(now_ns_, text, "refused", {{"text", text}});
}

void NodeLoading::OnResetCommunication(const std::vector<std::string>& refusals) noexcept
{
    has_reset_ = true;
    for (const std::string& refusal : refusals)
    {
        report_.Tell(now_ns_, refusal, "refused", {{"text", refusal}});
    }
}

void NodeLoading::OnTime(const cia301::TimeOfDay& time, const Instant now) noexcept
{
    static_cast<void>(now);
    report_.Tell(now_ns_, TextOf(time), "time", {{"ms", time.ms}, {"days", time.days}});
}

void NodeLoading::OnEmergency(const cia301::ReceivedEmergency& emergency) noexcept
{
    report_.Tell(now_ns_, TextOf(emergency), "emergency",
                 {{"node", emergency.node.value}, {"code", emergency.code}, {"register", emergency.error_register}});
}
} // namespace counterpoint::runtime
