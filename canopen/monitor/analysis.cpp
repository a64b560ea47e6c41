// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/monitor/analysis.hpp"

#include <algorithm>
#include <utility>

namespace counterpoint::monitor
{
namespace
{
constexpr std::uint32_t kNmt = 0x000U;
constexpr std::uint32_t kGfc = 0x001U;
constexpr std::uint32_t kSync = 0x080U;
constexpr std::uint32_t kTimeStamp = 0x100U;
constexpr std::uint32_t kFirstSrdo = 0x101U;
constexpr std::uint32_t kLastSrdo = 0x180U;
constexpr std::uint32_t kSdoAnswer = 0x580U;
constexpr std::uint32_t kSdoRequest = 0x600U;
constexpr std::uint32_t kErrorControl = 0x700U;
constexpr std::uint32_t kNodes = 0x7FU;
constexpr std::uint32_t kLssFirst = 0x7E4U;
constexpr std::uint32_t kLssLast = 0x7E5U;

constexpr std::uint8_t kStop = 2U;
constexpr std::uint8_t kPreOperational = 128U;
constexpr std::uint8_t kResetNode = 129U;
constexpr std::uint8_t kResetCommunication = 130U;
constexpr std::uint8_t kStateOperational = 5U;

bool IsIn(const std::uint32_t identifier, const std::uint32_t base)
{
    return identifier > base && identifier <= base + kNodes;
}

/// By the identifier alone, in the predefined connection set.
Service Predefined(const std::uint32_t identifier)
{
    if (identifier == kNmt || identifier == kGfc)
    {
        return identifier == kNmt ? Service::kNmt : Service::kGfc;
    }
    if (identifier == kSync || identifier == kTimeStamp)
    {
        return identifier == kSync ? Service::kSync : Service::kTime;
    }
    if (identifier >= kFirstSrdo && identifier <= kLastSrdo)
    {
        return Service::kSrdo;
    }
    if (IsIn(identifier, kSync))
    {
        return Service::kEmergency;
    }
    if (IsIn(identifier, kSdoAnswer) || IsIn(identifier, kSdoRequest))
    {
        return Service::kSdo;
    }
    if (identifier == kLssFirst || identifier == kLssLast)
    {
        return Service::kLss;
    }
    return IsIn(identifier, kErrorControl) ? Service::kErrorControl : Service::kOther;
}
} // namespace

const char* ServiceName(const Service service) noexcept
{
    constexpr std::array<const char*, kServiceCount> names{
        "NMT", "GFC", "SYNC", "EMCY", "TIME", "SRDO", "PDO", "SDO", "error control", "LSS", "other", "not CANopen"};
    return names.at(static_cast<std::size_t>(service));
}

Analysis::Analysis(const Network& network, Listener listener)
    : network_(network), listener_(std::move(listener)), gfc_(network), counts_(network.Watches().size()),
      next_deadline_(std::numeric_limits<Time>::max())
{
    for (std::uint32_t identifier = 0U; identifier < kIdentifiers; ++identifier)
    {
        services_.at(identifier) = Predefined(identifier);
    }
    for (const PdoModel& pdo : network.Pdos())
    {
        services_.at(pdo.identifier) = Service::kPdo;
    }
    for (const NodeModel& node : network.Nodes())
    {
        services_.at(node.emergency_id) = Service::kEmergency;
    }
    for (const WatchModel& watch : network.Watches())
    {
        const std::size_t number = watches_.size();
        watches_.emplace_back(number, watch.setup, static_cast<BreachSink&>(*this));
        for (const std::uint32_t identifier : {watch.setup.normal_id, watch.setup.inverse_id})
        {
            if (identifier < kIdentifiers)
            {
                watches_of_.at(identifier).push_back(number);
                services_.at(identifier) = Service::kSrdo;
            }
        }
    }
}

Service Analysis::ServiceOf(const LogFrame& frame) const noexcept
{
    const bool is_canopen = !frame.is_extended && !frame.is_fd && !frame.is_error && frame.identifier < kIdentifiers;
    return is_canopen ? services_[frame.identifier] : Service::kForeign;
}

void Analysis::Take(const LogFrame& frame)
{
    first_frame_ = (frame_count_ == 0U) ? frame.time : first_frame_;
    last_frame_ = frame.time;
    ++frame_count_;
    Advance(frame.time);
    const Service service = ServiceOf(frame);
    ++frames_.at(static_cast<std::size_t>(service));
    if (service == Service::kNmt || service == Service::kErrorControl)
    {
        FollowNodes(frame);
    }
    if (frame.IsPlain())
    {
        gfc_.OnFrame(frame);
        next_deadline_ = std::min(next_deadline_, gfc_.Deadline());
    }
    if (service == Service::kSrdo)
    {
        for (const std::size_t number : watches_of_.at(frame.identifier))
        {
            watches_[number].OnFrame(frame);
            next_deadline_ = std::min(next_deadline_, watches_[number].Deadline());
        }
        Tell();
    }
}

void Analysis::Advance(const Time now)
{
    first_ = has_begun_ ? first_ : now;
    has_begun_ = true;
    last_ = now;
    if (is_blind_)
    {
        Open(now);
    }
    if (now <= next_deadline_)
    {
        return;
    }
    next_deadline_ = std::numeric_limits<Time>::max();
    for (SrdoWatch& watch : watches_)
    {
        watch.Advance(now);
        next_deadline_ = std::min(next_deadline_, watch.Deadline());
    }
    if (const auto breach = gfc_.Advance(now); breach)
    {
        fresh_.push_back({*breach, {}});
    }
    next_deadline_ = std::min(next_deadline_, gfc_.Deadline());
    Tell();
}

void Analysis::Open(const Time now)
{
    is_blind_ = false;
    for (SrdoWatch& watch : watches_)
    {
        watch.Begin(now);
    }
}

void Analysis::Interrupt() noexcept
{
    is_blind_ = true;
    gfc_.Stop();
    error_control_ = {}; // Whether a toggle bit alternates is not known any more.
    for (SrdoWatch& watch : watches_)
    {
        watch.Stop(last_);
    }
}

void Analysis::End() noexcept
{
    for (SrdoWatch& watch : watches_)
    {
        watch.End(last_);
    }
}

void Analysis::OnBreach(const std::size_t watch, const Breach& breach)
{
    ++counts_.at(watch).at(static_cast<std::size_t>(breach.cause));
    const std::uint32_t normal_id = watches_[watch].Setup().normal_id;
    for (Violation& violation : fresh_)
    {
        // That of a GFC, which has no watch, is of another cause.
        const bool is_same = violation.breach.cause == breach.cause && violation.breach.time == breach.time &&
                             violation.breach.details == breach.details &&
                             watches_[violation.watches.front()].Setup().normal_id == normal_id;
        if (is_same)
        {
            violation.watches.push_back(watch);
            return;
        }
    }
    fresh_.push_back({breach, {watch}});
}

void Analysis::Tell()
{
    if (fresh_.empty())
    {
        return;
    }
    std::stable_sort(fresh_.begin(), fresh_.end(), [](const Violation& left, const Violation& right)
                     { return left.breach.time < right.breach.time; });
    violation_count_ += fresh_.size();
    for (const Violation& violation : fresh_)
    {
        listener_(violation);
    }
    fresh_.clear();
}

/// Commands, boot-up, heartbeat and guarding tell who leaves OPERATIONAL; supervision begins with the next valid pair.
/// [SRS_MON_009]
void Analysis::FollowNodes(const LogFrame& frame)
{
    if (frame.identifier != kNmt)
    {
        const ErrorControlFrame told = error_control_.Take(frame);
        if (told.TellsState() && told.state != kStateOperational)
        {
            StopNode(told.node_id);
        }
    }
    else if (frame.IsPlain() && frame.length == 2U)
    {
        const std::uint8_t command = frame.data[0];
        const bool leaves =
            command == kStop || command == kPreOperational || command == kResetNode || command == kResetCommunication;
        if (leaves)
        {
            StopNode(frame.data[1]);
        }
    }
}

void Analysis::StopNode(const std::uint8_t node_id)
{
    for (std::size_t number = 0U; number < watches_.size(); ++number)
    {
        const WatchModel& watch = network_.Watches()[number];
        for (const auto& end : {watch.producer, watch.consumer})
        {
            const bool is_node = end && (node_id == 0U || network_.Nodes()[end->node].id == node_id);
            if (is_node)
            {
                watches_[number].Stop(last_);
            }
        }
    }
}

const std::array<std::size_t, kCauseCount>& Analysis::CountsOf(const std::size_t watch) const
{
    return counts_.at(watch);
}
} // namespace counterpoint::monitor
