import {
  CustomBlending,
  LessEqualDepth,
  Matrix4,
  NoBlending,
  OneFactor,
  OneMinusSrcAlphaFactor,
  RGBAIntegerFormat,
  type Texture,
  UnsignedIntType,
  type Vector2,
  Vector4,
} from 'three';
import { FullscreenPass } from '../../gpu/FullscreenPass';
import fogBackground from './fogBackground.glsl?raw';
import fogFarthest from './fogFarthest.glsl?raw';
import fogIntegrate from './fogIntegrate.glsl?raw';
import fogLights from './fogLights.glsl?raw';
import type { MediumUniforms } from './FogMedium';
import fogMedium from './fogMedium.glsl?raw';
import fogPhase from './fogPhase.glsl?raw';
import fogScatter from './fogScatter.glsl?raw';
import fogSlices from './fogSlices.glsl?raw';

const noTexture = () => ({ value: null as Texture | null });

/** Uniforms of fogSlices.glsl and of the blocks of froxels, shared by the passes. */
export type GridUniforms = {
  /** Number of froxels across, up and in depth; first slice of a draw. */
  readonly farol_fogGrid: { readonly value: Int32Array };
  readonly farol_fogSlices: { readonly value: Vector2 };
  readonly farol_fogRay: { readonly value: Vector4 };
  /** Number of blocks of 8 × 8 froxels across and up. */
  readonly farol_fogBlocks: { readonly value: Int32Array };
};

/** Makes the pass that finds the lights of each block of froxels. */
export function fogLightsPass(grid: GridUniforms) {
  return new FullscreenPass({
    program: 'lights of fog',
    fragment: 'fogLights',
    microShaders: { fogSlices, fogLights },
    uniforms: { ...grid },
    shared: ['farol_lightTable', 'farol_lightCounts'],
    blending: NoBlending,
    target: { format: RGBAIntegerFormat, type: UnsignedIntType, internalFormat: 'RGBA32UI' },
    repeats: true,
  });
}

/** Makes the pass that computes the light that froxels scatter. @param layers - number of slices of a draw */
export function fogScatterPass(grid: GridUniforms, medium: MediumUniforms, layers: number) {
  return new FullscreenPass({
    program: 'light in fog',
    fragment: 'fogScatter',
    microShaders: { fogSlices, fogMedium, fogPhase, fogScatter },
    uniforms: {
      ...grid,
      ...medium,
      farol_fogLights: noTexture(),
      farol_fogBefore: noTexture(),
      farol_fogToWorld: { value: new Matrix4() },
      farol_fogToBefore: { value: new Matrix4() },
      farol_fogRayBefore: { value: new Vector4() },
      farol_fogShare: { value: new Vector4() },
      farol_fogTurn: { value: new Int32Array([1, 0]) },
      farol_fogOtherShare: { value: 1 },
      farol_anisotropy: { value: 0 },
    },
    shared: 'all',
    defines: { FAROL_FOG_LAYERS: `${layers}` },
    blending: NoBlending,
    repeats: true,
  });
}

/** Makes the pass that sums froxels from the eye on. @param layers - number of slices of a draw */
export function fogIntegratePass(grid: GridUniforms, layers: number) {
  return new FullscreenPass({
    program: 'fog to the eye',
    fragment: 'fogIntegrate',
    microShaders: { fogSlices, fogIntegrate },
    uniforms: { ...grid, farol_froxels: noTexture() },
    defines: { FAROL_FOG_LAYERS: `${layers}` },
    blending: NoBlending,
    repeats: true,
  });
}

/** Makes the pass that draws fog over the background. */
export function fogBackgroundPass() {
  return new FullscreenPass({
    program: 'fog over background',
    vertex: 'fogFarthest',
    fragment: 'fogBackground',
    microShaders: { fogFarthest, fogBackground },
    uniforms: { farol_farthest: { value: 1 } },
    shared: ['farol_media', 'farol_mediaSpace'],
    asThree: true,
    toneMapped: true,
    depthTest: true,
    depthFunc: LessEqualDepth,
    transparent: true,
    blending: CustomBlending,
    blendSrc: OneFactor,
    blendDst: OneMinusSrcAlphaFactor,
    repeats: true,
  });
}
