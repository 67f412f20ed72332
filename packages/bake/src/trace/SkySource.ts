import {
  Color,
  type CubeTexture,
  EquirectangularReflectionMapping,
  Matrix3,
  Matrix4,
  type Scene,
  type Texture,
  Vector3,
} from 'three';
import type { Sky } from '../BakeOptions';
import type { SkyLight } from '../scene/collectLights';

/** Uniforms and defines of sky.glsl. */
export interface SkySource {
  readonly isBlack: boolean;
  readonly uniforms: Record<string, { value: unknown }>;
  readonly defines: Record<string, unknown>;
}

/** @param lights - ambient and hemisphere lights that are baked */
export function skySource(
  scene: Scene,
  sky: Sky,
  lights: readonly SkyLight[],
  onWarning: (sentence: string) => void,
): SkySource {
  const colour = new Color(0, 0, 0);
  let map: Texture | null = null;
  let factor = 1;
  const turn = new Matrix3();
  if (sky === 'environment') {
    map = scene.environment ?? null;
    factor = scene.environmentIntensity ?? 1;
    if (scene.environmentRotation) {
      turn.setFromMatrix4(new Matrix4().makeRotationFromEuler(scene.environmentRotation)).transpose();
    }
  } else if (typeof sky === 'object' && 'isTexture' in sky) map = sky;
  else if (sky !== 'none') colour.set(sky);
  if (map && ((map as CubeTexture).isCubeTexture || map.mapping !== EquirectangularReflectionMapping)) {
    onWarning(
      'The sky is not baked: its texture is not equirectangular. Give options.sky the equirectangular texture that it was made from.',
    );
    map = null;
  }
  const overPi = (each: Color): Color => each.clone().multiplyScalar(1 / Math.PI);
  const black = { up: new Vector3(0, 1, 0), sky: colour.clone().set(0), ground: colour.clone().set(0) };
  const all = lights.length > 0 ? lights : [black];
  return {
    isBlack: map === null && colour.getHex() === 0 && colour.r + colour.g + colour.b === 0 && lights.length === 0,
    uniforms: {
      farol_skyColour: { value: colour },
      farol_skyUp: { value: all.map(({ up }) => up) },
      farol_skyAbove: { value: all.map((each) => overPi(each.sky)) },
      farol_skyBelow: { value: all.map(({ ground }) => overPi(ground)) },
      farol_skyMap: { value: map },
      farol_skyTurn: { value: turn },
      farol_skyFactor: { value: factor },
    },
    defines: { SKY_LIGHTS: all.length, ...(map ? { SKY_TEXTURE: '' } : {}) },
  };
}
