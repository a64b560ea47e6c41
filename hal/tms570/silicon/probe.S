@ Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
@
@ The one instruction that a test of ECC reads with, and the way back from the abort that it provokes. ARM state, so that
@ every instruction has the same length. [SRS_TMS_046]
    .syntax unified
    .arch armv7-r
    .arm

    .equ .Lmode_system, 0x1F

    .section .text.probe, "ax", %progbits
    .global ProbeRead
    .type ProbeRead, %function
ProbeRead:                             @ r0: address; r0: the word, or the address after a provoked abort
    mrs r1, cpsr
    push {r1, r4-r11, lr}
    ldr r2, =probe_stack
    str sp, [r2]
    dsb
    .global ProbeReadInstruction
ProbeReadInstruction:
    ldr r0, [r0]
    dsb                                @ an abort has come by now
.Lback:
    pop {r1, r4-r11, lr}
    msr cpsr_cx, r1                    @ asynchronous aborts as before, too
    bx lr
    .size ProbeRead, . - ProbeRead

@ From the handler, in whatever mode it runs: back behind the instruction, with the stack and registers of ProbeRead.
    .global ProbeReturn
    .type ProbeReturn, %function
ProbeReturn:
    cps #.Lmode_system
    ldr r2, =probe_stack
    ldr sp, [r2]
    b .Lback
    .size ProbeReturn, . - ProbeReturn
    .ltorg

    .section .bss.probe_stack, "aw", %nobits
    .balign 4
    .type probe_stack, %object
probe_stack:
    .space 4
    .size probe_stack, . - probe_stack

    .section .note.GNU-stack, "", %progbits
    .end
