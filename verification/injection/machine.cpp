// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/injection/machine.hpp"

#include <cstring>
#include <stdexcept>
#include <sys/mman.h>
#include <unicorn/unicorn.h>

namespace counterpoint::injection
{
namespace
{

constexpr std::uint32_t kPage = 0x1000U;
constexpr std::uint32_t kGio = 0xFFF7BC00U;
constexpr std::uint32_t kPortOffsets[2] = {0x34U, 0x54U};
constexpr std::uint32_t kErrorPin = 0xFFFFF538U; ///< ESMEKR
constexpr std::uint32_t kMostOfStart = 3000000U;
constexpr std::uint32_t kMostOfStep = 200000U;

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

std::uint8_t* Allocate(const std::uint32_t bytes)
{
    void* const place = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (place == MAP_FAILED)
    {
        throw std::runtime_error{"no memory"};
    }
    return static_cast<std::uint8_t*>(place);
}

constexpr int kKept[] = {UC_ARM_REG_R4, UC_ARM_REG_R5,  UC_ARM_REG_R6,  UC_ARM_REG_R7, UC_ARM_REG_R8,
                         UC_ARM_REG_R9, UC_ARM_REG_R10, UC_ARM_REG_R11, UC_ARM_REG_SP, UC_ARM_REG_LR};
constexpr int kKeptDoubles[] = {UC_ARM_REG_D8,  UC_ARM_REG_D9,  UC_ARM_REG_D10, UC_ARM_REG_D11,
                                UC_ARM_REG_D12, UC_ARM_REG_D13, UC_ARM_REG_D14, UC_ARM_REG_D15};
constexpr int kNumbered[] = {UC_ARM_REG_R0,  UC_ARM_REG_R1,  UC_ARM_REG_R2,  UC_ARM_REG_R3, UC_ARM_REG_R4,
                             UC_ARM_REG_R5,  UC_ARM_REG_R6,  UC_ARM_REG_R7,  UC_ARM_REG_R8, UC_ARM_REG_R9,
                             UC_ARM_REG_R10, UC_ARM_REG_R11, UC_ARM_REG_R12, UC_ARM_REG_SP, UC_ARM_REG_LR};

bool IsIt(const std::uint32_t half_word)
{
    return ((half_word & 0xFF00U) == 0xBF00U) && ((half_word & 0xFU) != 0U);
}

std::uint32_t BlockLength(const std::uint32_t half_word)
{
    std::uint32_t length = 4U;
    while (((half_word >> (4U - length)) & 1U) == 0U)
    {
        --length;
    }
    return length;
}

std::uint32_t BlockEnd(const Program& program, const std::uint32_t it)
{
    std::uint32_t end = it + 2U;
    for (std::uint32_t left = BlockLength(program.HalfWord(it)); left != 0U; --left)
    {
        end += program.Length(end);
    }
    return end;
}

// Where a conditional branch leads to when it is taken.
std::uint32_t Target(const Program& program, const std::uint32_t address)
{
    const std::uint32_t first = program.HalfWord(address);
    if ((first & 0xF500U) == 0xB100U) // CBZ, CBNZ
    {
        return address + 4U + (((first >> 3U) & 0x1FU) << 1U) + (((first >> 9U) & 1U) << 6U);
    }
    if (program.Length(address) == 2U)
    {
        const auto offset = static_cast<std::int8_t>(first & 0xFFU);
        return address + 4U + static_cast<std::uint32_t>(2 * offset);
    }
    const std::uint32_t second = program.HalfWord(address + 2U);
    const std::uint32_t sign = (first >> 10U) & 1U;
    std::uint32_t offset = ((second & 0x7FFU) << 1U) | ((first & 0x3FU) << 12U) | (((second >> 13U) & 1U) << 18U) |
                           (((second >> 11U) & 1U) << 19U);
    offset |= (sign != 0U) ? 0xFFF00000U : 0U;
    return address + 4U + offset;
}

} // namespace

std::uint32_t FindBlock(const Program& program, const std::vector<std::uint32_t>& trace, const std::uint32_t count)
{
    for (std::uint32_t back = 1U; (back <= 4U) && (back <= count); ++back)
    {
        const std::uint32_t it = trace[count - back];
        if (IsIt(program.HalfWord(it)) && (trace[count] > it) && (trace[count] < BlockEnd(program, it)))
        {
            return count - back;
        }
    }
    return count;
}

bool IsDecision(const Program& program, const std::uint32_t address)
{
    const std::uint32_t first = program.HalfWord(address);
    const bool is_short = ((first & 0xF000U) == 0xD000U) && (((first >> 8U) & 0xFU) < 14U);
    const bool is_zero = (first & 0xF500U) == 0xB100U;
    bool is_long = false;
    if ((first & 0xF800U) == 0xF000U)
    {
        const std::uint32_t second = program.HalfWord(address + 2U);
        is_long = ((second & 0xD000U) == 0x8000U) && (((first >> 6U) & 0xFU) < 14U);
    }
    return is_short || is_zero || is_long || IsIt(first);
}

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
    // Words of a device arrive with the order of the bytes of the host.
    static std::uint64_t ReadPin(uc_engine* /*engine*/, const std::uint64_t offset, unsigned /*size*/, void* machine)
    {
        return __builtin_bswap32(
            static_cast<Machine*>(machine)->ReadPort((kGio & ~(kPage - 1U)) + static_cast<std::uint32_t>(offset)));
    }
    static void WritePin(uc_engine* /*engine*/, const std::uint64_t offset, unsigned /*size*/, std::uint64_t value,
                         void* machine)
    {
        static_cast<Machine*>(machine)->WritePort((kGio & ~(kPage - 1U)) + static_cast<std::uint32_t>(offset),
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
        static_cast<Machine*>(machine)->WritePort(0xFFFFF000U + static_cast<std::uint32_t>(offset),
                                                  __builtin_bswap32(static_cast<std::uint32_t>(value)));
    }
    static void WriteMailPort(uc_engine* /*engine*/, const std::uint64_t offset, unsigned /*size*/, std::uint64_t value,
                              void* machine)
    {
        static_cast<Machine*>(machine)->WritePort(kPortAddress + static_cast<std::uint32_t>(offset),
                                                  __builtin_bswap32(static_cast<std::uint32_t>(value)));
    }
};

namespace
{

using HookCall = void (*)(uc_engine*, std::uint64_t, std::uint32_t, void*);

void AddHook(uc_engine* const engine, const int type, const HookCall call, void* const machine)
{
    uc_hook hook{};
    void* function = nullptr;
    std::memcpy(&function, &call, sizeof function);
    Must(uc_hook_add(engine, &hook, type, function, machine, std::uint64_t{1}, std::uint64_t{0}), "hook");
}

} // namespace

Machine::Machine(const Program& program)
    : program_{program}, step_end_{program.Symbol("InjectionStepEnd") & ~1U},
      places_{program.Symbol("injection_places")}, ram_begin_{program.Symbol("memory_data_start")},
      ram_live_{program.Symbol("memory_zero_end")}, stack_top_{program.Symbol("stack_main_top")}
{
    code_ = Allocate(Pages(static_cast<std::uint32_t>(program_.Code().size())));
    std::memcpy(code_, program_.Code().data(), program_.Code().size());
    ram_bytes_ = Pages(stack_top_ + 64U - ram_begin_);
    ram_ = Allocate(ram_bytes_);
    mail_ = Allocate(kPage);
    for (uc_struct** const engine : {&watched_, &fast_})
    {
        Must(uc_open(UC_ARCH_ARM, static_cast<uc_mode>(UC_MODE_ARM), engine), "uc_open");
        Must(uc_ctl_set_cpu_model(*engine, UC_CPU_ARM_CORTEX_R5F), "processor");
        Map(*engine);
    }
    AddHook(watched_, UC_HOOK_CODE, &MachineCalls::Instruction, this);
    AddHook(fast_, UC_HOOK_BLOCK, &MachineCalls::Block, this);
    engine_ = watched_;
}

void Machine::Map(uc_struct* const engine)
{
    const auto code_bytes = Pages(static_cast<std::uint32_t>(program_.Code().size()));
    Must(uc_mem_map_ptr(engine, 0U, code_bytes, UC_PROT_READ | UC_PROT_EXEC, code_), "flash");
    Must(uc_mem_map_ptr(engine, ram_begin_, ram_bytes_, UC_PROT_READ | UC_PROT_WRITE, ram_), "RAM");
    Must(uc_mem_map_ptr(engine, kMailboxAddress, kPage, UC_PROT_READ, mail_), "mailbox");
    Must(uc_mmio_map(engine, kPortAddress, kPage, nullptr, nullptr, &MachineCalls::WriteMailPort, this), "ports");
    Must(uc_mmio_map(engine, kGio & ~(kPage - 1U), kPage, &MachineCalls::ReadPin, this, &MachineCalls::WritePin, this),
         "pins");
    Must(uc_mmio_map(engine, 0xFFF7D000U, kPage, &MachineCalls::ReadSystem, this, &MachineCalls::WriteSystem, this),
         "CAN controllers");
    Must(uc_mmio_map(engine, 0xFFFFF000U, kPage, &MachineCalls::ReadSystem, this, &MachineCalls::WriteSystem, this),
         "system");
}

void Machine::Use(uc_struct* const engine)
{
    if (engine_ != engine)
    {
        // A saved context has pointers into its own engine.
        for (const int which : kKept)
        {
            std::uint32_t value = 0U;
            uc_reg_read(engine_, which, &value);
            uc_reg_write(engine, which, &value);
        }
        for (const int which : kKeptDoubles)
        {
            std::uint64_t value = 0U;
            uc_reg_read(engine_, which, &value);
            uc_reg_write(engine, which, &value);
        }
        engine_ = engine;
    }
}

Machine::~Machine()
{
    uc_close(watched_);
    uc_close(fast_);
}

std::uint8_t* Machine::Ram(const std::uint32_t address)
{
    return ram_ + (address - ram_begin_);
}

void Machine::OnInstruction(const std::uint32_t address)
{
    const bool leaves = (patched_.end != 0U) && ((address < patched_.begin) || (address >= patched_.end));
    const bool reaches = (count_ == stop_at_) && (fault_.kind != FaultKind::kNone);
    if (leaves || (count_ > most_) || (address == step_end_) || (reaches && (fault_.kind != FaultKind::kRegister)))
    {
        StopAt(address);
        return;
    }
    if (reaches)
    {
        const int which = kNumbered[fault_.number / 32U];
        std::uint32_t value = 0U;
        uc_reg_read(engine_, which, &value);
        value ^= 1U << (fault_.number % 32U);
        uc_reg_write(engine_, which, &value);
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

std::uint32_t Machine::ReadPort(const std::uint32_t address) const
{
    for (std::uint32_t port = 0U; port < 2U; ++port)
    {
        const std::uint32_t offset = address - kGio - kPortOffsets[port];
        if (offset == 0x00U)
        {
            return world_.direction[port];
        }
        if (offset == 0x04U)
        {
            return world_.direction[port] & world_.output[port];
        }
        if ((offset == 0x08U) || (offset == 0x0CU) || (offset == 0x10U))
        {
            return world_.output[port];
        }
    }
    return (address == kGio) ? 1U : 0U;
}

void Machine::WritePin(const std::uint32_t offset, const std::uint32_t value)
{
    for (std::uint32_t port = 0U; port < 2U; ++port)
    {
        switch (offset - kPortOffsets[port])
        {
        case 0x00U:
            world_.direction[port] = value;
            break;
        case 0x08U:
            world_.output[port] = value;
            break;
        case 0x0CU:
            world_.output[port] |= value;
            break;
        case 0x10U:
            world_.output[port] &= ~value;
            break;
        default:
            break;
        }
    }
}

void Machine::WritePort(const std::uint32_t address, const std::uint32_t value)
{
    switch (address)
    {
    case kPortAddress + kPortIdentifier:
        sending_.identifier = value;
        break;
    case kPortAddress + kPortLength:
        sending_.length_bytes = value;
        break;
    case kPortAddress + kPortFirst:
        sending_.first = value;
        break;
    case kPortAddress + kPortSecond:
        sending_.second = value;
        seen_.sent.push_back(sending_);
        break;
    case kPortAddress + kPortAnswer:
        seen_.answer = value;
        seen_.is_answered = true;
        break;
    case kPortAddress + kPortEvent:
        seen_.events.push_back(value);
        break;
    case kPortAddress + kPortDeviceFault:
        seen_.device_fault = value;
        break;
    case kPortAddress + kPortRefused:
        seen_.refused += value;
        break;
    case kErrorPin:
        world_.is_error_pin_low = world_.is_error_pin_low || (value != 0U);
        break;
    default:
        if ((address & ~(kPage - 1U)) == (kGio & ~(kPage - 1U)))
        {
            WritePin(address - kGio, value);
        }
        break;
    }
}

// Up to a stop of the hook; false: the processor refuses to go on.
bool Machine::Run(const std::uint32_t from)
{
    is_stopped_ = false;
    const uc_err error = uc_emu_start(engine_, from, 0xFFFFFFF0U, 0U, 0U);
    return (error == UC_ERR_OK) && is_stopped_;
}

void Machine::Start()
{
    most_ = kMostOfStart;
    fault_ = Fault{};
    count_ = 0U;
    for (uc_struct* const engine : {fast_, watched_})
    {
        engine_ = engine;
        count_ = 0U;
        if ((!Run(0U)) || (stopped_ != step_end_))
        {
            throw std::runtime_error{"the image does not start: stopped at " + std::to_string(stopped_)};
        }
    }
    uc_reg_read(fast_, UC_ARM_REG_CPSR, &cpsr_);
    uc_reg_read(fast_, UC_ARM_REG_FPSCR, &fpscr_);
}

// From the IT instruction where the processor stands to the first one behind its block.
bool Machine::RunPatched(const std::uint32_t patched, const std::uint32_t block_end)
{
    const std::uint32_t begin = stopped_;
    const std::uint32_t bytes = program_.Length(patched);
    std::uint8_t* const place = code_ + patched;
    if (patched == begin)
    {
        // The other condition; what is for else is for then.
        const std::uint32_t length = BlockLength(program_.HalfWord(begin));
        const auto inverted = static_cast<std::uint8_t>((0x1EU << (4U - length)) & 0x1FU);
        place[0] = static_cast<std::uint8_t>(place[0] ^ inverted);
    }
    else
    {
        constexpr std::uint8_t kNothing[] = {0x00U, 0xBFU};
        constexpr std::uint8_t kNothingWide[] = {0xAFU, 0xF3U, 0x00U, 0x80U};
        std::memcpy(place, (bytes == 2U) ? kNothing : kNothingWide, bytes);
    }
    uc_ctl_remove_cache(engine_, std::uint64_t{begin}, std::uint64_t{block_end});
    patched_ = Range{begin, block_end};
    const bool is_running = Run(begin | 1U);
    patched_ = Range{0U, 0U};
    std::memcpy(place, &program_.Code()[patched], bytes);
    uc_ctl_remove_cache(engine_, std::uint64_t{begin}, std::uint64_t{block_end});
    return is_running;
}

bool Machine::RunFaulted(const std::uint32_t from)
{
    if (!Run(from))
    {
        return false;
    }
    if ((stopped_ == step_end_) || (count_ > most_) || (fault_.kind == FaultKind::kRegister))
    {
        return true;
    }
    const Fault fault = fault_;
    fault_ = Fault{};
    std::uint32_t next = stopped_ + program_.Length(stopped_);
    if (IsIt(program_.HalfWord(stopped_)))
    {
        if (fault.address != stopped_ || fault.kind == FaultKind::kInvert)
        {
            if (!RunPatched(fault.address, BlockEnd(program_, stopped_)))
            {
                return false;
            }
            next = stopped_;
            if ((stopped_ == step_end_) || (count_ > most_))
            {
                return true;
            }
        }
    }
    else if ((fault.kind == FaultKind::kInvert) && (fault.number == 0U))
    {
        next = Target(program_, stopped_);
    }
    return Run(next | 1U);
}

Seen Machine::Step(const Mailbox& mail, const Fault& fault, std::vector<std::uint32_t>* const trace)
{
    seen_ = Seen{};
    Fill(mail);
    fault_ = fault;
    trace_ = trace;
    count_ = 0U;
    stop_at_ = fault.count;
    most_ = kMostOfStep;
    world_.pending.clear();
    Use(((fault.kind == FaultKind::kNone) && (trace == nullptr)) ? fast_ : watched_);
    std::uint32_t caller = 0U;
    uc_reg_read(engine_, UC_ARM_REG_LR, &caller);
    const bool is_running = RunFaulted(caller);
    trace_ = nullptr;
    if (!is_running)
    {
        seen_.end = StepEnd::kException;
    }
    else if (stopped_ != step_end_)
    {
        seen_.end = StepEnd::kRunaway;
    }
    Look();
    return seen_;
}

void Machine::Fill(const Mailbox& mail)
{
    Mailbox words = mail;
    for (const SentFrame& frame : world_.pending)
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

void Machine::Look()
{
    seen_.pins = world_.direction[0] & world_.output[0];
    seen_.is_cut_off = world_.is_error_pin_low || (world_.direction[0] == 0U);
    seen_.objects = Objects();
    world_.pending = seen_.sent;
}

std::array<ObjectPair, 3> Machine::Objects()
{
    // Bytes in little-endian order, as on the wire.
    std::array<ObjectPair, 3> objects{};
    for (std::uint32_t i = 0U; i < objects.size(); ++i)
    {
        std::memcpy(&objects[i].normal, Ram(places_ + (8U * i)), 4U);
        std::memcpy(&objects[i].inverse, Ram(places_ + (8U * i) + 4U), 4U);
    }
    return objects;
}

Registers Machine::ReadRegisters()
{
    Registers result{};
    for (std::size_t i = 0U; i < result.words.size(); ++i)
    {
        uc_reg_read(engine_, kKept[i], &result.words[i]);
    }
    for (std::size_t i = 0U; i < result.doubles.size(); ++i)
    {
        uc_reg_read(engine_, kKeptDoubles[i], &result.doubles[i]);
    }
    return result;
}

void Machine::Save(Snapshot& to)
{
    Use(watched_); // Restore gives the context to this one.
    to.ram.assign(ram_, ram_ + ram_bytes_);
    to.registers = ReadRegisters();
    to.world = world_;
    if (to.context == nullptr)
    {
        Must(uc_context_alloc(engine_, &to.context), "context");
    }
    Must(uc_context_save(engine_, to.context), "context");
}

void Machine::Restore(const Snapshot& from)
{
    std::memcpy(ram_, from.ram.data(), ram_bytes_);
    world_ = from.world;
    engine_ = watched_;
    Must(uc_context_restore(engine_, from.context), "context");
    uc_reg_write(fast_, UC_ARM_REG_CPSR, &cpsr_);
    uc_reg_write(fast_, UC_ARM_REG_FPSCR, &fpscr_);
}

bool Machine::Equals(const Snapshot& other)
{
    if (!(world_ == other.world) || !(ReadRegisters() == other.registers))
    {
        return false;
    }
    const std::uint32_t stack = other.registers.words[8];
    return (std::memcmp(ram_, other.ram.data(), ram_live_ - ram_begin_) == 0) &&
           (std::memcmp(Ram(stack), &other.ram[stack - ram_begin_], stack_top_ - stack) == 0);
}

void Machine::FlipMemory(const std::uint32_t address, const std::uint32_t bit)
{
    std::uint8_t* const place = Ram(address);
    *place = static_cast<std::uint8_t>(*place ^ (1U << bit));
}

void Machine::WriteObjects(const std::uint32_t object, const ObjectPair& values)
{
    std::memcpy(Ram(places_ + (8U * object)), &values.normal, 4U);
    std::memcpy(Ram(places_ + (8U * object) + 4U), &values.inverse, 4U);
}

} // namespace counterpoint::injection
