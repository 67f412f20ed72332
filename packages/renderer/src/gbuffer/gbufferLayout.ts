import {
  HalfFloatType,
  RGBAFormat,
  RGBFormat,
  RGFormat,
  UnsignedByteType,
  UnsignedInt101111Type,
  type PixelFormat,
  type TextureDataType,
} from 'three';

/** Storage of one attachment. */
export interface TexelFormat {
  readonly format: PixelFormat;
  readonly type: TextureDataType;
  /** Bytes of a pixel. */
  readonly bytes: number;
}

/** A texture of the G-buffer. */
export interface GBufferAttachment extends TexelFormat {
  readonly name: string;
  /** GLSL precision of the attachment's sampler uniform. Default 'highp'. */
  readonly precision?: 'highp' | 'lowp';
  /** Format with the quality 'lite'. Default: the attachment's own. */
  readonly lite?: TexelFormat;
}

/**
 * The G-buffer: 20 bytes a pixel (14 with the quality 'lite') and 32-bit float depth. Positions are computed from depth. Four
 * attachments, the number that WebGL2 guarantees. Outputs and uniforms (gbufferNames.ts) and gbufferTextures.glsl are made from
 * these rows; the encoding is in gbufferWrite.glsl and gbufferRead.glsl.
 */
export const gbufferLayout = [
  // rgb: emissive, ambient, environment, light maps (linear); a, not in 'lite': Phong shininess, or the vertex normal,
  // see halfNormal.glsl
  {
    name: 'accumulation',
    ...{ format: RGBAFormat, type: HalfFloatType, bytes: 8 },
    lite: { format: RGBFormat, type: UnsignedInt101111Type, bytes: 4 },
  },
  // rg: view-space normal, octahedral; ba, only where depth is too coarse: distance, see storedDistance.glsl
  { name: 'normal', format: RGFormat, type: HalfFloatType, bytes: 4 },
  // rgb: square root of the albedo; a: flags (surfaceFlags.ts) / 255
  { name: 'albedo', format: RGBAFormat, type: UnsignedByteType, bytes: 4, precision: 'lowp' },
  // standard: roughness, metalness, square root of F0, F90; Phong: square root of the specular colour (rgb), its strength;
  // 'lite': roughness, metalness (F0 0.04, F90 1); Phong: square root of the grey, log2(1 + shininess) / 13
  {
    name: 'material',
    ...{ format: RGBAFormat, type: UnsignedByteType, bytes: 4, precision: 'lowp' },
    lite: { format: RGFormat, type: UnsignedByteType, bytes: 2 },
  },
] as const satisfies readonly GBufferAttachment[];

/** Storage of an attachment with the quality 'lite' or 'full'. */
export function formatOf(row: GBufferAttachment, isLite: boolean): TexelFormat {
  return (isLite && row.lite) || row;
}
