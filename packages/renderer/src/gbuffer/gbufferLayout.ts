import { HalfFloatType, RGBAFormat, RGFormat, UnsignedByteType, type PixelFormat, type TextureDataType } from 'three';

/** One colour attachment of the G-buffer. */
export interface GBufferAttachment {
  readonly name: string;
  readonly format: PixelFormat;
  readonly type: TextureDataType;
  readonly bytes: number;
}

/**
 * The G-buffer, 20 bytes a pixel and 32-bit float depth. Position is rebuilt from depth. Four attachments, WebGL2's least.
 * The encoding is in gbufferWrite.glsl and gbufferRead.glsl.
 */
export const gbufferLayout = [
  // rgb: emissive, ambient, environment, light maps (linear); a: Phong shininess
  {
    name: 'accumulation',
    format: RGBAFormat,
    type: HalfFloatType,
    bytes: 8,
  },
  // view-space normal, octahedral; of four numbers where depth is too coarse: the distance too, see storedDistance.glsl
  { name: 'normal', format: RGFormat, type: HalfFloatType, bytes: 4 },
  // rgb: square root of the albedo; a: flags (shading model, fog, tone mapped, receives shadows) / 255
  {
    name: 'albedo',
    format: RGBAFormat,
    type: UnsignedByteType,
    bytes: 4,
  },
  // standard: roughness, metalness, square root of F0, F90; Phong: rgb square root of specular colour, a specular
  // strength
  {
    name: 'material',
    format: RGBAFormat,
    type: UnsignedByteType,
    bytes: 4,
  },
] as const satisfies readonly GBufferAttachment[];
