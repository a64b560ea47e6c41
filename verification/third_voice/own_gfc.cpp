// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/third_voice/own_gfc.hpp"

namespace counterpoint::third_voice
{
OwnGfc::OwnGfc(const DeviceConfig& config, const Flaw flaw) : config_(config), flaw_(flaw)
{
}

void OwnGfc::Start()
{
    called_.reset();
    is_sent_ = false;
}

void OwnGfc::OnSent(const Time follow_us)
{
    if (!is_sent_ || flaw_ == Flaw::kGfcPutOff) // One that is sent again does not put the first one off.
    {
        follow_us_ = follow_us;
        at_ = called_;
    }
    is_sent_ = true;
}

void OwnGfc::OnNormal(const bool is_taken)
{
    is_sent_ = is_sent_ && !is_taken && flaw_ != Flaw::kGfcFollowed;
}

bool OwnGfc::Look(const Time now)
{
    if (is_sent_ && !at_)
    {
        at_ = now - ((flaw_ == Flaw::kGfcFromCycle) ? 0 : Time{config_.cycle_us});
        follow_us_ = (flaw_ == Flaw::kGfcAtOnce) ? 0 : follow_us_;
    }
    called_ = now;
    const bool is_missed = is_sent_ && now - *at_ > follow_us_;
    is_sent_ = is_sent_ && !is_missed;
    return is_missed;
}
} // namespace counterpoint::third_voice
