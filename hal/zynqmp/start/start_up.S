@ Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
@
@ Vectors of a Cortex-R5F of a Zynq UltraScale+ and the way from reset to FirmwareMain. The same object is in the image for a
@ board and in the one for the emulator. [SRS_ZYN_003]
@
@ Order: registers of all modes, ECC of the TCMs, stacks, vectors, RAM, data, constructors.
    .syntax unified
    .arch armv7-r
    .fpu vfpv3-d16
    .arm

    .equ .Lmode_user, 0x10
    .equ .Lmode_fast, 0x11
    .equ .Lmode_interrupt, 0x12
    .equ .Lmode_supervisor, 0x13
    .equ .Lmode_abort, 0x17
    .equ .Lmode_undefined, 0x1B
    .equ .Lmode_system, 0x1F
    .equ .Lsctlr_off, (1 << 0) | (1 << 2) | (1 << 12)    @ MPU and both caches
    .equ .Lsctlr_exceptions, (1 << 25) | (1 << 30)       @ EE: entered with little-endian data; TE: in ARM state
    .equ .Lactlr_ecc, 7 << 25          @ ECC of the A-TCM and of both B-TCM
    .equ .Lcpacr_vfp, 0xF << 20
    .equ .Lfpexc_enable, 1 << 30
    .equ .Lstack_paint, 0xA5A5A5A5

    .section .vectors, "ax", %progbits
    .global FirmwareVectors
    .type FirmwareVectors, %object
FirmwareVectors:
    b Reset
    b UndefinedInstruction
    b SupervisorCall
    b PrefetchAbort
    b DataAbort
    b Reserved
    b Interrupt
    b FastInterrupt
    .size FirmwareVectors, . - FirmwareVectors

    .section .text.start_up, "ax", %progbits
    .macro begin name
    .global \name
    .type \name, %function
\name:
    .endm
    .macro finish name
    .size \name, . - \name
    .endm

    begin Reset
    setend le
    cpsid aif, #.Lmode_system
    mrc p15, 0, r0, c1, c0, 0
    bic r0, r0, #.Lsctlr_off & 0xFF
    bic r0, r0, #.Lsctlr_off & 0xFF00
    bic r0, r0, #.Lsctlr_exceptions
    dsb
    mcr p15, 0, r0, c1, c0, 0
    isb
    mov r0, #0
    mcr p15, 0, r0, c7, c5, 0          @ nothing of an earlier program in the caches
    mcr p15, 0, r0, c15, c5, 0
    isb
    b InitialiseRegisters
    finish Reset

@ Both processors of a lockstep pair start with random registers: whatever is not written differs when it is first stored.
    begin InitialiseRegisters
    mov r0, #0
    .irp number, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12
    mov r\number, #0
    .endr
    mrs r1, cpsr
    cps #.Lmode_fast
    msr spsr_cxsf, r1
    .irp number, 8, 9, 10, 11, 12, 13, 14
    mov r\number, #0
    .endr
    .irp mode, .Lmode_interrupt, .Lmode_supervisor, .Lmode_abort, .Lmode_undefined
    cps #\mode
    msr spsr_cxsf, r1
    mov r13, #0
    mov lr, #0
    .endr
    cps #.Lmode_system
    mov r13, #0
    mov lr, #0

    mrc p15, 0, r1, c1, c0, 2
    orr r1, r1, #.Lcpacr_vfp
    mcr p15, 0, r1, c1, c0, 2
    isb
    mov r1, #.Lfpexc_enable
    vmsr fpexc, r1
    vmsr fpscr, r0
    .irp number, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15
    vmov d\number, r0, r0
    .endr
    b InitialiseMemory
    finish InitialiseRegisters

    begin InitialiseMemory
    mrc p15, 0, r0, c1, c0, 1
    orr r0, r0, #.Lactlr_ecc
    dmb
    mcr p15, 0, r0, c1, c0, 1
    isb
    bl HardwareSetVectors              @ r0 to r3 only, no stack
    ldr r4, =stack_exception_top
    .irp mode, .Lmode_abort, .Lmode_undefined, .Lmode_supervisor
    cps #\mode
    mov sp, r4
    .endr
    ldr r4, =stack_interrupt_top
    cps #.Lmode_interrupt
    mov sp, r4
    ldr r4, =stack_fast_top
    cps #.Lmode_fast
    mov sp, r4
    cps #.Lmode_system
    ldr sp, =stack_main_top

    ldr r0, =memory_zero_start         @ words of 64 bits: what a write with ECC of the B-TCM covers
    ldr r1, =memory_zero_end
    mov r2, #0
    mov r3, #0
1:  cmp r0, r1
    strdlo r2, r3, [r0], #8
    blo 1b

    ldr r0, =stack_main_bottom         @ the painted stack shows how deep a run went
    ldr r1, =stack_main_top
    ldr r2, =.Lstack_paint
    mov r3, r2
2:  cmp r0, r1
    strdlo r2, r3, [r0], #8
    blo 2b

    ldr r0, =memory_data_load
    ldr r1, =memory_data_start
    ldr r2, =memory_data_end
3:  cmp r1, r2
    ldrlo r3, [r0], #4
    strlo r3, [r1], #4
    blo 3b

    ldr r4, =memory_constructors_start
    ldr r5, =memory_constructors_end
4:  cmp r4, r5
    bhs 5f
    ldr r0, [r4], #4
    blx r0
    b 4b
5:  cpsie a                            @ a write that nobody answers is an exception, too
    ldr r0, =FirmwareMain
    blx r0
    b Stopped
    finish InitialiseMemory

@ Where nothing works any more: after a reset all outputs are closed, and the watchdog is not served.
    begin Stopped
    wfi
    b Stopped
    finish Stopped

@ FirmwareException(cause, accessed address, where): closes the outputs, keeps the record, does not come back.
    .macro exception name, cause, offset
    begin \name
    setend le
    cpsid if
    ldr sp, =stack_exception_top
    sub r2, lr, #\offset
    mov r0, #\cause
    .endm
    .macro enter_exception name
    ldr r3, =FirmwareException
    blx r3
    b Stopped
    finish \name
    .endm

    @ Causes: hal::ExceptionCause. After an instruction of Thumb state the link register is 2 behind, not 4.
    .macro place_of_thumb
    mrs r3, spsr
    tst r3, #0x20
    addne r2, r2, #2
    .endm

    exception UndefinedInstruction, 3, 4
    place_of_thumb
    mov r1, #0
    enter_exception UndefinedInstruction
    exception PrefetchAbort, 1, 4
    mrc p15, 0, r1, c6, c0, 2          @ IFAR
    enter_exception PrefetchAbort
    exception DataAbort, 1, 8
    mrc p15, 0, r1, c6, c0, 0          @ DFAR
    enter_exception DataAbort
    exception Reserved, 5, 4
    mov r1, #0
    enter_exception Reserved
@ The only supervisor call there is: unprivileged code came back to UnprivilegedReturn. From anywhere else, or in any other
@ mode, it is an exception.
    begin SupervisorCall
    setend le
    mrs r0, spsr
    and r1, r0, #0x1F
    cmp r1, #.Lmode_user
    ldreq r1, =UnprivilegedReturn + 4
    cmpeq lr, r1
    bne ForeignCall
    ldr r1, =unprivileged_stack
    ldr r2, [r1]
    cmp r2, #0
    beq ForeignCall
    mov r3, #0
    str r3, [r1]
    orr r0, r0, #.Lmode_system         @ user and system mode differ in the low four bits
    msr cpsr_cxsf, r0
    mov sp, r2
    pop {r2, r3}
    vmsr fpscr, r2
    vpop {d8-d15}
    pop {r3-r11, pc}
    finish SupervisorCall

    exception ForeignCall, 5, 4
    place_of_thumb
    mov r1, #0
    enter_exception ForeignCall

@ void RunUnprivileged(void (*code)(), std::uint32_t* stack_top): calls `code` in user mode on a stack of its own. User and
@ system mode share the stack pointer: ours waits in unprivileged_stack, which user mode cannot write. [SRS_ZYN_069]
    begin RunUnprivileged
    push {r3-r11, lr}
    vpush {d8-d15}                     @ nothing that a caller relies on is left to that code
    vmrs r2, fpscr
    push {r2, r3}
    ldr r2, =unprivileged_stack
    str sp, [r2]
    mov sp, r1
    ldr lr, =UnprivilegedReturn
    mrs r2, cpsr
    bic r2, r2, #0xF                   @ system (11111) becomes user (10000)
    msr cpsr_c, r2
    bx r0
    finish RunUnprivileged

    begin UnprivilegedReturn
    svc #0
    b UnprivilegedReturn
    finish UnprivilegedReturn

@ Interrupts are not nested: each has a stack of its own and runs to its end. Compilers move 64 bits by registers of the
@ floating-point unit, in what is interrupted and in what interrupts.
    .macro interrupt name, stack, function
    begin \name
    setend le
    ldr sp, =\stack
    sub lr, lr, #4
    push {r0-r3, r12, lr}
    vpush {d0-d7}
    vmrs r0, fpscr
    push {r0, r1}
    ldr r0, =\function
    blx r0
    pop {r0, r1}
    vmsr fpscr, r0
    vpop {d0-d7}
    pop {r0-r3, r12, lr}
    movs pc, lr
    finish \name
    .endm

    interrupt Interrupt, stack_interrupt_top, FirmwareInterrupt
    interrupt FastInterrupt, stack_fast_top, FirmwareFastInterrupt
    .ltorg
    .section .bss.unprivileged_stack, "aw", %nobits
    .balign 4
    .type unprivileged_stack, %object
unprivileged_stack:
    .space 4
    .size unprivileged_stack, . - unprivileged_stack

    .section .note.GNU-stack, "", %progbits
    .end
