export { Surface, type SurfaceOptions, type SurfaceRenderer, type SurfaceValue, type SurfaceValues } from './Surface';
export { textOfMicroShaders } from './textOfMicroShaders';
export type { SurfaceUniform, SurfaceUniformType } from './SurfaceUniform';
export {
  addSurface,
  canWearSurface,
  getSurfaces,
  layerSurface,
  setSurface,
  surfaceReach,
  type SurfaceUniforms,
  type WornSurface,
} from './setSurface';
