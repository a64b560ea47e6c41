// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/injection/machine.hpp"

#include "verification/injection/thumb.hpp"

#include <algorithm>
#include <cstring>
#include <stdexcept>
#include <unicorn/unicorn.h>

namespace counterpoint::injection
{
namespace
{

constexpr std::uint32_t kMostOfStart = 3000000U;
constexpr std::uint32_t kMostOfStep = 200000U; // Instructions, or blocks of them.
constexpr std::size_t kStackPointer = 8U;      // Of what is kept.
constexpr std::uint32_t kNowhere = 0xFFFFFFFFU;

void Must(const uc_err error, const char* const what)
{
    if (error != UC_ERR_OK)
    {
        throw std::runtime_error{std::string{what} + ": " + uc_strerror(error)};
    }
}

std::uint32_t Pages(const std::uint32_t bytes)
{
    return (bytes + kPage - 1U) & ~(kPage - 1U);
}

} // namespace

/// What the emulator calls.
struct MachineCalls
{
    static void Instruction(uc_engine* /*engine*/, const std::uint64_t address, std::uint32_t /*size*/, void* machine)
    {
        static_cast<Machine*>(machine)->OnInstruction(static_cast<std::uint32_t>(address));
    }
    static void Block(uc_engine* /*engine*/, const std::uint64_t address, std::uint32_t /*size*/, void* machine)
    {
        static_cast<Machine*>(machine)->OnBlock(static_cast<std::uint32_t>(address));
    }
    static void Access(uc_engine* /*engine*/, const uc_mem_type type, const std::uint64_t address, const int size,
                       std::int64_t /*value*/, void* machine)
    {
        auto* const to = static_cast<Machine*>(machine);
        const auto call = (type == UC_MEM_WRITE) ? &Ram::OnWrite : &Ram::OnRead;
        (to->ram_.*call)(static_cast<std::uint32_t>(address), static_cast<std::uint32_t>(size));
    }
    // Words of a device arrive with the order of the bytes of the host.
    static std::uint64_t ReadPin(uc_engine* /*engine*/, const std::uint64_t offset, unsigned /*size*/, void* machine)
    {
        return __builtin_bswap32(static_cast<Machine*>(machine)->outside_.ReadPort((kGio & ~(kPage - 1U)) +
                                                                                   static_cast<std::uint32_t>(offset)));
    }
    static void WritePin(uc_engine* /*engine*/, const std::uint64_t offset, unsigned /*size*/, std::uint64_t value,
                         void* machine)
    {
        static_cast<Machine*>(machine)->outside_.WritePort((kGio & ~(kPage - 1U)) + static_cast<std::uint32_t>(offset),
                                                           __builtin_bswap32(static_cast<std::uint32_t>(value)));
    }
    static std::uint64_t ReadSystem(uc_engine* /*engine*/, std::uint64_t /*offset*/, unsigned /*size*/,
                                    void* /*machine*/)
    {
        return 0U;
    }
    static void WriteSystem(uc_engine* /*engine*/, const std::uint64_t offset, unsigned /*size*/, std::uint64_t value,
                            void* machine)
    {
        static_cast<Machine*>(machine)->outside_.WritePort(0xFFFFF000U + static_cast<std::uint32_t>(offset),
                                                           __builtin_bswap32(static_cast<std::uint32_t>(value)));
    }
    static void WriteMailPort(uc_engine* /*engine*/, const std::uint64_t offset, unsigned /*size*/, std::uint64_t value,
                              void* machine)
    {
        static_cast<Machine*>(machine)->outside_.WritePort(kPortAddress + static_cast<std::uint32_t>(offset),
                                                           __builtin_bswap32(static_cast<std::uint32_t>(value)));
    }
};

namespace
{

template <typename Call> void AddHook(uc_engine* const engine, const int type, const Call call, void* const machine)
{
    uc_hook hook{};
    void* function = nullptr;
    std::memcpy(&function, &call, sizeof function);
    Must(uc_hook_add(engine, &hook, type, function, machine, std::uint64_t{1}, std::uint64_t{0}), "hook");
}

} // namespace

Machine::Machine(const Program& program)
    : program_{program}, step_end_{program.Symbol("InjectionStepEnd") & ~1U},
      ram_begin_{program.Symbol("memory_data_start")},
      ram_{{ram_begin_, program.Symbol("memory_zero_end"), program.Symbol("stack_main_top")},
           Pages(program.Symbol("stack_main_top") + 64U - ram_begin_),
           program.Symbol("injection_places")}
{
    code_ = Allocate(Pages(static_cast<std::uint32_t>(program_.Code().size())));
    std::memcpy(code_, program_.Code().data(), program_.Code().size());
    mail_ = Allocate(kPage);
    for (uc_struct** const engine : {&watched_, &fast_, &reading_})
    {
        Must(uc_open(UC_ARCH_ARM, static_cast<uc_mode>(UC_MODE_ARM), engine), "uc_open");
        Must(uc_ctl_set_cpu_model(*engine, UC_CPU_ARM_CORTEX_R5F), "processor");
        Map(*engine);
    }
    AddHook(watched_, UC_HOOK_CODE, &MachineCalls::Instruction, this);
    AddHook(fast_, UC_HOOK_BLOCK, &MachineCalls::Block, this);
    AddHook(reading_, UC_HOOK_BLOCK, &MachineCalls::Block, this);
    AddHook(reading_, UC_HOOK_MEM_READ | UC_HOOK_MEM_WRITE, &MachineCalls::Access, this);
    engine_ = watched_;
}

void Machine::Map(uc_struct* const engine)
{
    const auto code_bytes = Pages(static_cast<std::uint32_t>(program_.Code().size()));
    Must(uc_mem_map_ptr(engine, 0U, code_bytes, UC_PROT_READ | UC_PROT_EXEC, code_), "flash");
    Must(uc_mem_map_ptr(engine, ram_begin_, ram_.Bytes(), UC_PROT_READ | UC_PROT_WRITE, ram_.First()), "RAM");
    Must(uc_mem_map_ptr(engine, kMailboxAddress, kPage, UC_PROT_READ, mail_), "mailbox");
    Must(uc_mmio_map(engine, kPortAddress, kPage, nullptr, nullptr, &MachineCalls::WriteMailPort, this), "ports");
    Must(uc_mmio_map(engine, kGio & ~(kPage - 1U), kPage, &MachineCalls::ReadPin, this, &MachineCalls::WritePin, this),
         "pins");
    Must(uc_mmio_map(engine, 0xFFF7D000U, kPage, &MachineCalls::ReadSystem, this, &MachineCalls::WriteSystem, this),
         "CAN controllers");
    Must(uc_mmio_map(engine, 0xFFFFF000U, kPage, &MachineCalls::ReadSystem, this, &MachineCalls::WriteSystem, this),
         "system");
}

// A saved context has pointers into its own engine. What runs in a foreign mode stays where it is.
void Machine::Use(uc_struct* const engine)
{
    if ((engine_ != engine) && (ModeOf(engine_) == mode_))
    {
        CopyRegisters(engine_, engine);
        engine_ = engine;
    }
}

Machine::~Machine()
{
    uc_close(watched_);
    uc_close(fast_);
    uc_close(reading_);
}

void Machine::OnInstruction(const std::uint32_t address)
{
    const bool leaves = (patched_.end != 0U) && ((address < patched_.begin) || (address >= patched_.end));
    const bool reaches = count_ == stop_at_;
    if (leaves || (count_ > most_) || (address == step_end_) || (reaches && is_walking_))
    {
        StopAt(address);
        return;
    }
    if (reaches)
    {
        FlipRegister(engine_, register_);
    }
    if (trace_ != nullptr)
    {
        trace_->push_back(address);
    }
    ++count_;
}

void Machine::OnBlock(const std::uint32_t address)
{
    ++count_;
    if ((address == step_end_) || (count_ > most_))
    {
        StopAt(address);
    }
}

void Machine::StopAt(const std::uint32_t address)
{
    is_stopped_ = true;
    stopped_ = address;
    uc_emu_stop(engine_);
}

// Up to a stop of the hook; false: the processor refuses to go on.
bool Machine::Run(const std::uint32_t from)
{
    is_stopped_ = false;
    const uc_err error = uc_emu_start(engine_, from, 0xFFFFFFF0U, 0U, 0U);
    return (error == UC_ERR_OK) && is_stopped_;
}

bool Machine::RunOn(const std::uint32_t from)
{
    if (IsOver())
    {
        return true;
    }
    Use(fast_);
    return Run(from | 1U);
}

bool Machine::IsOver() const
{
    return (stopped_ == step_end_) || (count_ > most_);
}

void Machine::Start()
{
    most_ = kMostOfStart;
    stop_at_ = kNowhere;
    for (uc_struct* const engine : {fast_, reading_, watched_})
    {
        engine_ = engine;
        count_ = 0U;
        if ((!Run(0U)) || (stopped_ != step_end_))
        {
            throw std::runtime_error{"the image does not start: stopped at " + std::to_string(stopped_)};
        }
    }
    mode_ = ModeOf(watched_);
    for (std::size_t i = 0U; i < 2U; ++i)
    {
        Must(uc_context_alloc((i == 0U) ? fast_ : reading_, &started_[i]), "context");
        Must(uc_context_save((i == 0U) ? fast_ : reading_, started_[i]), "context");
    }
}

// Changes the instruction of a fault until it is changed back.
void Machine::Patch(const Fault& fault)
{
    std::uint8_t* const place = code_ + fault.address;
    const std::uint32_t bytes = program_.Length(fault.address);
    if (fault.kind == FaultKind::kOpcode)
    {
        place[fault.number / 8U] = static_cast<std::uint8_t>(place[fault.number / 8U] ^ (1U << (fault.number % 8U)));
    }
    else if (fault.address == stopped_)
    {
        // The other condition; what is for else is for then.
        const std::uint32_t length = BlockLength(program_.HalfWord(stopped_));
        const auto inverted = static_cast<std::uint8_t>((0x1EU << (4U - length)) & 0x1FU);
        place[0] = static_cast<std::uint8_t>(place[0] ^ inverted);
    }
    else
    {
        constexpr std::uint8_t kNothing[] = {0x00U, 0xBFU};
        constexpr std::uint8_t kNothingWide[] = {0xAFU, 0xF3U, 0x00U, 0x80U};
        std::memcpy(place, (bytes == 2U) ? kNothing : kNothingWide, bytes);
    }
}

// From where the processor stands to behind this instruction; where it is an IT instruction, behind its block.
bool Machine::RunPatched(const Fault& fault)
{
    const std::uint32_t begin = stopped_;
    Patch(fault);
    const auto now = static_cast<std::uint32_t>(code_[begin] | (code_[begin + 1U] << 8U));
    const std::uint32_t was = program_.HalfWord(begin);
    std::uint32_t end = begin + program_.Length(begin);
    end = IsIt(now) ? std::max(end, BlockEnd(program_, begin, now)) : end;
    end = IsIt(was) ? std::max(end, BlockEnd(program_, begin, was)) : end;
    uc_ctl_remove_cache(engine_, std::uint64_t{begin}, std::uint64_t{end});
    patched_ = Range{begin, end};
    const bool is_running = Run(begin | 1U);
    patched_ = Range{0U, 0U};
    std::memcpy(code_ + fault.address, &program_.Code()[fault.address], program_.Length(fault.address));
    uc_ctl_remove_cache(engine_, std::uint64_t{begin}, std::uint64_t{end});
    return is_running;
}

bool Machine::RunFaulted(const Fault& fault)
{
    const bool is_skip = fault.kind == FaultKind::kSkip;
    const bool is_inverted = fault.kind == FaultKind::kInvert;
    const bool is_register = fault.kind == FaultKind::kRegister;
    const bool is_in_block = IsIt(program_.HalfWord(stopped_)) && ((fault.address != stopped_) || is_inverted);
    if (is_register && (fault.count != count_))
    {
        // Within a block: where it ends is not known before.
        stop_at_ = fault.count;
        register_ = fault.number;
        return Run(stopped_ | 1U);
    }
    if ((fault.kind == FaultKind::kOpcode) || (is_in_block && (is_skip || is_inverted)))
    {
        return RunPatched(fault) && RunOn(stopped_);
    }
    if (is_register)
    {
        FlipRegister(engine_, fault.number);
    }
    if (is_skip || is_inverted)
    {
        const bool is_taken = is_inverted && (fault.number == 0U);
        return RunOn(is_taken ? Target(program_, stopped_) : (stopped_ + program_.Length(stopped_)));
    }
    return RunOn(stopped_);
}

void Machine::Begin(const Mailbox& mail)
{
    Fill(mail);
    outside_.Begin();
    most_ = kMostOfStep;
    count_ = 0U;
    stop_at_ = kNowhere;
    stopped_ = Caller();
}

void Machine::WalkTo(const std::uint32_t count)
{
    Use(watched_);
    stop_at_ = count;
    is_walking_ = true;
    const bool is_running = (count == count_) || Run(stopped_ | 1U);
    is_walking_ = false;
    stop_at_ = kNowhere;
    if ((!is_running) || (count_ != count))
    {
        throw std::runtime_error{"the undisturbed step has no instruction " + std::to_string(count)};
    }
}

Seen Machine::Finish(const Fault& fault)
{
    const bool is_running = RunFaulted(fault);
    stop_at_ = kNowhere;
    return Conclude(is_running);
}

Seen Machine::Conclude(const bool is_running)
{
    StepEnd end = StepEnd::kDone;
    if (!is_running)
    {
        end = StepEnd::kException;
    }
    else if (stopped_ != step_end_)
    {
        end = StepEnd::kRunaway;
    }
    return outside_.End(end, ram_.Objects());
}

Seen Machine::Step(const Mailbox& mail)
{
    Begin(mail);
    Use(ram_.IsStuck() ? reading_ : fast_);
    const Seen seen = Conclude(Run(stopped_ | 1U));
    ram_.Force();
    return seen;
}

Seen Machine::Trace(const Mailbox& mail, std::vector<std::uint32_t>& trace)
{
    Begin(mail);
    Use(watched_);
    trace_ = &trace;
    const Seen seen = Conclude(Run(stopped_ | 1U));
    trace_ = nullptr;
    return seen;
}

Seen Machine::Note(const Mailbox& mail, Accesses& accesses)
{
    Begin(mail);
    Use(reading_);
    ram_.NoteIn(&accesses);
    const Seen seen = Conclude(Run(stopped_ | 1U));
    ram_.NoteIn(nullptr);
    return seen;
}

std::uint32_t Machine::Caller()
{
    std::uint32_t caller = 0U;
    uc_reg_read(engine_, UC_ARM_REG_LR, &caller);
    return caller & ~1U;
}

void Machine::Fill(const Mailbox& mail)
{
    Mailbox words = mail;
    for (const SentFrame& frame : outside_.Now().pending)
    {
        if (words.frame_count < kMostFrames)
        {
            words.frames[words.frame_count] =
                MailFrame{1U,          frame.identifier, frame.length_bytes,
                          frame.first, frame.second,     mail.now_us - 200U + words.frame_count};
            ++words.frame_count;
        }
    }
    std::array<std::uint32_t, sizeof(Mailbox) / sizeof(std::uint32_t)> raw{};
    std::memcpy(raw.data(), &words, sizeof words);
    for (std::uint32_t& word : raw)
    {
        word = __builtin_bswap32(word);
    }
    std::memcpy(mail_, raw.data(), sizeof words);
}

void Machine::Save(Snapshot& to)
{
    Use(watched_); // Restore gives the context to this one.
    to.ram = ram_.Content();
    to.mail.assign(mail_, mail_ + sizeof(Mailbox));
    to.registers = ReadKept(engine_);
    to.outside = outside_;
    to.count = count_;
    to.stopped = stopped_;
    if (to.context == nullptr)
    {
        Must(uc_context_alloc(engine_, &to.context), "context");
    }
    Must(uc_context_save(engine_, to.context), "context");
}

void Machine::Restore(const Snapshot& from)
{
    ram_.Restore(from.ram);
    std::memcpy(mail_, from.mail.data(), from.mail.size());
    outside_ = from.outside;
    count_ = from.count;
    stopped_ = from.stopped;
    most_ = kMostOfStep;
    engine_ = watched_;
    Must(uc_context_restore(engine_, from.context), "context");
    Must(uc_context_restore(fast_, started_[0]), "context");
    Must(uc_context_restore(reading_, started_[1]), "context");
}

bool Machine::Equals(const Snapshot& other)
{
    return (outside_.Now() == other.outside.Now()) && (ReadKept(engine_) == other.registers) &&
           ram_.Equals(other.ram, other.registers.words[kStackPointer]);
}

void Machine::Add(Digest& to)
{
    const Registers registers = ReadKept(engine_);
    for (const std::uint32_t word : registers.words)
    {
        to.Add(word);
    }
    for (const std::uint64_t value : registers.doubles)
    {
        to.Add(value);
    }
    ram_.Add(to, registers.words[kStackPointer]);
    outside_.Add(to);
}

void Machine::FlipCode(const std::uint32_t address, const std::uint32_t bit)
{
    code_[address] = static_cast<std::uint8_t>(code_[address] ^ (1U << bit));
    uc_ctl_remove_cache(fast_, std::uint64_t{address & ~1U}, std::uint64_t{(address & ~1U) + 2U});
}

} // namespace counterpoint::injection
