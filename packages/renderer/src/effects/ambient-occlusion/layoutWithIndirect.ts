import { HalfFloatType, RGBAFormat } from 'three';
import { gbufferLayout, type GBufferAttachment } from '../../gbuffer/gbufferLayout';

/** Attachment of indirect light. */
export const INDIRECT = gbufferLayout.length;

/** The G-buffer with what the accumulation holds of ambient, environment and light maps, reflections by roughness, apart. */
export const layoutWithIndirect: readonly GBufferAttachment[] = [
  ...gbufferLayout,
  { name: 'indirect', format: RGBAFormat, type: HalfFloatType, bytes: 8 },
];
