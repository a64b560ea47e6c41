@ Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
@
@ From reset to TargetMain on a Cortex-R4F or R5F with big-endian data. The processor starts in ARM state; an emulator
@ starts it with little-endian data, hence `setend be` before the first access to memory.
    .syntax unified
    .arch armv7-r
    .fpu vfpv3-d16

    .equ .Lmode_supervisor, 0x13
    .equ .Lmode_abort, 0x17
    .equ .Lmode_undefined, 0x1B
    .equ .Lmode_system, 0x1F
    .equ .Linterrupts_off, 0xC0
    .equ .Lsctlr_ee, 1 << 25
    .equ .Lcpacr_vfp, 0xF << 20
    .equ .Lfpexc_enable, 1 << 30

    .section .vectors, "ax", %progbits
    .arm
    .global TargetVectors
TargetVectors:
    b Reset
    b UndefinedInstruction
    b SupervisorCall
    b PrefetchAbort
    b DataAbort
    b Reserved
    b Interrupt
    b FastInterrupt

    .section .text.startup, "ax", %progbits
    .arm
    .type Reset, %function
Reset:
    setend be
    mrc p15, 0, r0, c1, c0, 0
    orr r0, r0, #.Lsctlr_ee              @ exceptions are entered with big-endian data, too
    mcr p15, 0, r0, c1, c0, 0
    isb

    mrc p15, 0, r0, c1, c0, 2
    orr r0, r0, #.Lcpacr_vfp
    mcr p15, 0, r0, c1, c0, 2
    isb
    mov r0, #.Lfpexc_enable
    vmsr fpexc, r0

    ldr r4, =target_exception_stack_top
    cps #.Lmode_abort
    mov sp, r4
    cps #.Lmode_undefined
    mov sp, r4
    cps #.Lmode_supervisor
    mov sp, r4
    cps #.Lmode_system
    ldr sp, =stack_main_top

    ldr r0, =stack_main_bottom       @ the painted stack shows how deep a run went
    ldr r1, =stack_main_top
    ldr r2, =0xA5A5A5A5
1:  cmp r0, r1
    strlo r2, [r0], #4
    blo 1b

    ldr r0, =target_data_load
    ldr r1, =target_data_start
    ldr r2, =target_data_end
2:  cmp r1, r2
    ldrlo r3, [r0], #4
    strlo r3, [r1], #4
    blo 2b

    ldr r0, =target_bss_start
    ldr r1, =target_bss_end
    mov r2, #0
3:  cmp r0, r1
    strlo r2, [r0], #4
    blo 3b

    ldr r4, =target_init_start
    ldr r5, =target_init_end
4:  cmp r4, r5
    bhs 5f
    ldr r0, [r4], #4
    blx r0
    b 4b
5:  ldr r0, =TargetMain
    blx r0
    ldr r1, =TargetExit
    blx r1
6:  b 6b

@ r0: which exception, r1: where. TargetException reports it and ends the run as a failure.
    .macro exception name, number, offset
    .type \name, %function
\name:
    setend be
    ldr sp, =target_exception_stack_top
    sub r1, lr, #\offset
    mov r0, #\number
    ldr r2, =TargetException
    blx r2
7:  b 7b
    .endm

    exception UndefinedInstruction, 1, 2
    exception SupervisorCall, 2, 4
    exception PrefetchAbort, 3, 4
    exception DataAbort, 4, 8
    exception Reserved, 5, 4
    exception Interrupt, 6, 4
    exception FastInterrupt, 7, 4
    .ltorg

    .section .note.GNU-stack, "", %progbits
    .end
