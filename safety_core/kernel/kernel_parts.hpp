// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SAFETY_CORE_KERNEL_KERNEL_PARTS_HPP
#define SAFETY_CORE_KERNEL_KERNEL_PARTS_HPP

#include "hal/api/can_ports.hpp"
#include "hal/api/safety_output.hpp"
#include "hal/api/watchdog.hpp"
#include "safety_core/contract/channel.hpp"
#include "safety_core/kernel/application.hpp"
#include "safety_core/kernel/flow_watch.hpp"
#include "safety_core/kernel/self_test_part.hpp"
#include "safety_core/kernel/told_causes.hpp"

namespace counterpoint
{

/// Everything a kernel works with; all outlive it. Channel A writes and sends the normal side, channel B the inverse
/// side.
struct KernelParts
{
    Channel& channel_a;
    Channel& channel_b;
    hal::CanPorts& can;
    hal::SafetyOutput& output;
    hal::Watchdog& watchdog;
    Application& application;
    SelfTestPart* self_test{nullptr}; ///< Optional. [SRS_STS_063]
    /// Room for each SRDO of the device, or null: then a cause is told whenever a channel signals it. [SRS_KRN_347]
    CauseWindows* windows{nullptr};
    /// Optional: what stands between kernel and its flow monitor, for instance a simulated fault; null: the kernel's
    /// own. [SRS_KRN_039]
    FlowWatch* flow{nullptr};
};

} // namespace counterpoint

#endif
