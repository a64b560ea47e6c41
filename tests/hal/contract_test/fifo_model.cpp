// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tests/hal/contract_test/fifo_model.hpp"

#include <algorithm>

namespace port_fifo
{

using counterpoint::CanFrame;
using counterpoint::CanPortId;
using counterpoint::FrameKind;
using counterpoint::Instant;

namespace
{

constexpr std::size_t kReceiveRoom = 16U;
constexpr std::size_t kEventRoom = 8U;
constexpr std::uint32_t kBitUs = 2U;
FifoModel* the_model = nullptr;

[[nodiscard]] std::uint32_t WordOf(const CanFrame& frame, const std::uint32_t first)
{
    std::uint32_t word = 0U;
    for (std::uint32_t byte = 0U; byte < 4U; ++byte)
    {
        word |= static_cast<std::uint32_t>(frame.data[first + byte]) << (8U * byte);
    }
    return word;
}

} // namespace

std::uint32_t ReadRegister(const std::uint32_t offset) noexcept
{
    return the_model->Read(offset);
}

void WriteRegister(const std::uint32_t offset, const std::uint32_t value) noexcept
{
    the_model->Write(offset, value);
}

FifoModel::FifoModel()
{
    the_model = this;
    plain_[kCanControl / 4U] = kOffTheBus;
    Restart();
}

FifoModel::~FifoModel()
{
    the_model = nullptr;
}

std::uint32_t FifoModel::Read(const std::uint32_t offset)
{
    ++accesses;
    switch (offset)
    {
    case kCanTimer:
        return static_cast<std::uint32_t>(now_us_ / kBitUs) & kStampMask;
    case kReceiveLevel:
        return static_cast<std::uint32_t>(received_.size());
    case kReceiveIdentifier:
    case kReceiveLength:
    case kReceiveData:
    case kReceiveData + 4U:
        return ReadReceive(offset);
    case kTransmitPending:
    {
        std::uint32_t pending = 0U;
        for (const std::uint32_t buffer : requests_)
        {
            pending |= 1U << buffer;
        }
        return pending | ((on_bus_ && on_bus_->buffer) ? (1U << *on_bus_->buffer) : 0U);
    }
    case kEventLevel:
        return static_cast<std::uint32_t>(events_.size());
    case kEventBuffer:
        return events_.empty() ? 0U : (events_.front().frame.identifier | (events_.front().stamp << kStampShift));
    case kTimerA:
        plain_[kTimerAHigh / 4U] = static_cast<std::uint32_t>((a_us_ * 80U) >> 32U);
        return static_cast<std::uint32_t>(a_us_ * 80U);
    case kTimerB:
        return static_cast<std::uint32_t>(b_us_);
    case kPinIn:
        return Pins();
    case kWatchdogQuestion:
        return watchdog_.Question().value;
    default:
        return plain_.at(offset / 4U);
    }
}

void FifoModel::Write(const std::uint32_t offset, const std::uint32_t value)
{
    ++accesses;
    switch (offset)
    {
    case kCanStatus:
        plain_[kCanStatus / 4U] &= ~value | kBusOff;
        break;
    case kReceivePop:
        received_.pop_front();
        break;
    case kEventPop:
        events_.pop_front();
        break;
    case kTransmitRequest:
        requests_.push_back(value);
        Begin();
        break;
    case kTransmitCancel:
        requests_.clear();
        break;
    case kWatchdogAnswer:
        watchdog_.Answer(counterpoint::hal::WatchdogAnswer{value}, Instant{static_cast<std::uint32_t>(now_us_)});
        break;
    default:
        plain_.at(offset / 4U) = value;
        break;
    }
}

void FifoModel::Advance(const std::uint32_t us)
{
    const std::uint64_t until = now_us_ + us;
    Begin();
    while (on_bus_ && (on_bus_->end_us <= until))
    {
        Pass(on_bus_->end_us - now_us_);
        Finish();
        Begin();
    }
    Pass(until - now_us_);
}

void FifoModel::Send(const CanFrame& frame)
{
    peer_.push_back(frame);
    Begin();
}

void FifoModel::Restart()
{
    pin_held = false;
    plain_[kPinOut / 4U] = 0U;
    plain_[kPinDirection / 4U] = 0U;
    watchdog_.Start(counterpoint::hal::WatchdogWindow{500U, 1600U}, Instant{static_cast<std::uint32_t>(now_us_)});
}

std::uint32_t FifoModel::Pins()
{
    const std::uint32_t driven = IsAlive() ? (plain_[kPinOut / 4U] & plain_[kPinDirection / 4U]) : 0U;
    return driven | (pin_held ? 1U : 0U);
}

bool FifoModel::IsAlive()
{
    watchdog_.Examine(Instant{static_cast<std::uint32_t>(now_us_)});
    return watchdog_.IsAlive();
}

std::uint32_t FifoModel::ReadReceive(const std::uint32_t offset) const
{
    if (received_.empty())
    {
        return 0U;
    }
    const CanFrame& frame = received_.front().frame;
    if (offset == kReceiveIdentifier)
    {
        const std::uint32_t remote = (frame.kind == FrameKind::kRemote) ? kRemote : 0U;
        return frame.identifier | remote | ((frame.kind == FrameKind::kExtended) ? kExtended : 0U);
    }
    if (offset == kReceiveLength)
    {
        return frame.length_bytes | (received_.front().stamp << kStampShift);
    }
    return WordOf(frame, offset - kReceiveData);
}

void FifoModel::Begin()
{
    const bool is_off = (plain_[kCanControl / 4U] & kOffTheBus) != 0U;
    if (on_bus_ || is_off)
    {
        return;
    }
    if (!peer_.empty())
    {
        const std::uint64_t bits = 60U + (10U * peer_.front().length_bytes);
        on_bus_ = OnBus{peer_.front(), now_us_ + (bits * kBitUs), std::nullopt};
        peer_.pop_front();
    }
    else if (!requests_.empty() && !bus_held)
    {
        const CanFrame frame = FrameOf(requests_.front());
        on_bus_ = OnBus{frame, now_us_ + ((60U + (10U * frame.length_bytes)) * kBitUs), requests_.front()};
        requests_.pop_front();
    }
}

void FifoModel::Finish()
{
    const std::uint32_t stamp = static_cast<std::uint32_t>(now_us_ / kBitUs) & kStampMask;
    const OnBus done = *on_bus_;
    on_bus_.reset();
    if (done.buffer)
    {
        CanFrame number{};
        number.identifier = *done.buffer;
        events_.push_back(Entry{number, stamp});
        seen_by_peer.push_back(done.frame);
        plain_[kCanStatus / 4U] |= (events_.size() > kEventRoom) ? kEventLost : 0U;
    }
    else if (IsAccepted(done.frame))
    {
        const bool is_full = received_.size() == kReceiveRoom;
        plain_[kCanStatus / 4U] |= is_full ? kReceiveLost : 0U;
        if (!is_full)
        {
            received_.push_back(Entry{done.frame, stamp});
        }
    }
    if (!interrupt_masked && interrupt)
    {
        interrupt();
    }
}

void FifoModel::Pass(const std::uint64_t us)
{
    now_us_ += us;
    a_us_ += a_held ? 0U : us;
    b_us_ += b_held ? 0U : us;
    static_cast<void>(IsAlive());
}

bool FifoModel::IsAccepted(const CanFrame& frame) const
{
    const auto first = plain_.begin() + (kFilter / 4U);
    return std::find(first, first + kFilters, frame.identifier) != (first + kFilters);
}

CanFrame FifoModel::FrameOf(const std::uint32_t buffer) const
{
    const std::size_t place = (kTransmitBuffer + (buffer * kBufferBytes)) / 4U;
    CanFrame frame{
        plain_.at(place), FrameKind::kData, CanPortId::kFirst, static_cast<std::uint8_t>(plain_.at(place + 1U)), {}};
    for (std::uint32_t byte = 0U; byte < counterpoint::kMaxPayloadBytes; ++byte)
    {
        frame.data[byte] = static_cast<std::uint8_t>(plain_.at(place + 2U + (byte / 4U)) >> (8U * (byte % 4U)));
    }
    return frame;
}

} // namespace port_fifo
