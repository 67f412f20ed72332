export { explainPixel } from './explainPixel';
export type {
  LightShare,
  OtherLight,
  OtherShare,
  PixelLighting,
  PixelLightingOptions,
  PixelProgram,
  PixelSurface,
} from './PixelLighting';
