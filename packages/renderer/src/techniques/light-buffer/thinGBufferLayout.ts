import { HalfFloatType, RGBAFormat } from 'three';
import type { GBufferAttachment } from '../../gbuffer/gbufferLayout';

/**
 * The thin G-buffer: 8 bytes a texel and 32-bit float depth. Position is rebuilt from depth, or where depth is too coarse from a
 * second attachment of distances, which also holds vertex normals where shadow maps need them. Encoded in thinGBufferWrite.glsl,
 * decoded in sumLight.glsl and lightBufferFilter.glsl.
 */
export const thinGBufferLayout = {
  // xy: view-space normal, octahedral; z: specular lobe: roughness (2 more where F90 is below 1), -1 -
  // Blinn-Phong shininess, 0 for none; w: number of the object, below 0 if it receives no shadows, 0 for nothing
  name: 'surface',
  format: RGBAFormat,
  type: HalfFloatType,
  bytes: 8,
} as const satisfies GBufferAttachment;
