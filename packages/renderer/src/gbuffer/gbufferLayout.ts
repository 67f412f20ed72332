import { HalfFloatType, RGBAFormat, RGFormat, UnsignedByteType, type PixelFormat, type TextureDataType } from 'three';

export interface GBufferAttachment {
  readonly name: string;
  readonly format: PixelFormat;
  readonly type: TextureDataType;
  /** Bytes of a pixel. */
  readonly bytes: number;
  /** GLSL precision of the sampler uniform that reads it. Default 'highp'. */
  readonly precision?: 'highp' | 'lowp';
}

/**
 * The G-buffer, 20 bytes a pixel and 32-bit float depth. Position is rebuilt from depth. Four attachments, WebGL2's
 * least. Outputs and uniforms (gbufferNames.ts) and gbufferTextures.glsl are made from these rows; the encoding is in
 * gbufferWrite.glsl and gbufferRead.glsl.
 */
export const gbufferLayout = [
  // rgb: emissive, ambient, environment, light maps (linear); a: Phong shininess, or the vertices' normal, see halfNormal.glsl
  { name: 'accumulation', format: RGBAFormat, type: HalfFloatType, bytes: 8 },
  // rg: view-space normal, octahedral; ba, only where depth is too coarse: distance, see storedDistance.glsl
  { name: 'normal', format: RGFormat, type: HalfFloatType, bytes: 4 },
  // rgb: square root of the albedo; a: flags (surfaceFlags.ts) / 255
  { name: 'albedo', format: RGBAFormat, type: UnsignedByteType, bytes: 4, precision: 'lowp' },
  // standard: roughness, metalness, square root of F0, F90; Phong: square root of the specular colour (rgb), its strength
  { name: 'material', format: RGBAFormat, type: UnsignedByteType, bytes: 4, precision: 'lowp' },
] as const satisfies readonly GBufferAttachment[];
