@ Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
@
@ Vectors on the emulator, in place of hal/zynqmp/start/low_vectors.S: its two processors see one memory, without a TCM for
@ each, and take their exceptions at FFFF0000h. Both write the same words there, which lead each processor to the vectors of
@ its own image by a register that it has for itself. Every entry of hal/zynqmp/start/start_up.S sets its stack first, so
@ the stack pointer of its mode is free here.
    .syntax unified
    .arch armv7-r
    .arm

    .section .text.start_up, "ax", %progbits
    .global HardwareSetVectors
    .type HardwareSetVectors, %function
HardwareSetVectors:
    ldr r0, =FirmwareVectors
    mcr p15, 0, r0, c13, c0, 4         @ TPIDRPRW
    ldr r0, =0xFFFF0000
    adr r1, Lead
    mov r2, #(Lead_end - Lead) / 4
1:  ldr r3, [r1], #4
    str r3, [r0], #4
    subs r2, r2, #1
    bne 1b
    dsb
    isb
    bx lr

Lead:
    .irp number, 0, 1, 2, 3, 4, 5, 6, 7
    b Lead_\number
    .endr
    .irp number, 0, 1, 2, 3, 4, 5, 6, 7
Lead_\number:
    mrc p15, 0, sp, c13, c0, 4
    add pc, sp, #4 * \number
    .endr
Lead_end:
    .ltorg
    .size HardwareSetVectors, . - HardwareSetVectors
    .section .note.GNU-stack, "", %progbits
    .end
