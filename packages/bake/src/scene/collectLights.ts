import {
  type AmbientLight,
  Color,
  type DirectionalLight,
  type HemisphereLight,
  type Light,
  type Object3D,
  type PointLight,
  type RectAreaLight,
  type SpotLight,
  Vector3,
} from 'three';
import { describe } from './describe';

/** Attenuation that replaces three's: `userData.farol.attenuation`. */
type Attenuation =
  | { readonly kind: 'near-far'; readonly near: number; readonly far: number }
  | { kind: 'polynomial'; constant: number; linear: number; quadratic: number; range: number };

/** Options in `light.userData.farol` that a bake reads. */
export interface BakedLightData {
  /** Radius (m) of the glowing sphere of a point or spot light, for soft shadows. Default 0. */
  radius?: number;
  /** Angle (rad) that a directional light's sun covers in the sky, for soft shadows. Default 0. */
  angle?: number;
  /** Shape of a RectAreaLight. Default 'rectangle'. */
  shape?: 'rectangle' | 'disc' | 'tube';
  ambient?: readonly [number, number, number];
  spotExponent?: number;
  attenuation?: Attenuation;
}

/** A light with a position or direction, in world space. */
export interface TracedLight {
  readonly light: Light;
  readonly kind: 'directional' | 'point' | 'spot' | 'rectangle' | 'disc' | 'tube';
  readonly position: Vector3;
  /**
   * Unit vector in world space: towards the light (directional), against the cone's axis (spot), or in the direction in
   * which the light shines (area).
   */
  readonly direction: Vector3;
  /** Linear colour of the light times its intensity. */
  readonly colour: Color;
  /** Distance (m) beyond which the light has no effect; 0 for no limit. */
  readonly range: number;
  readonly decay: number;
  readonly coneCosine: number;
  readonly penumbraCosine: number;
  readonly spotExponent: number;
  /** Radius of the glowing sphere (m); for a directional light the tangent of half its angle. */
  readonly radius: number;
  readonly attenuation: Attenuation | null;
  readonly ambient: Color;
  /** Half of an area light's width, as a vector in world space (m). */
  readonly halfWidth: Vector3;
  readonly halfHeight: Vector3;
  /** Whether only the reflected light is baked. */
  readonly isIndirect: boolean;
}

/** Light from all directions: ambient and hemisphere lights. */
export interface SkyLight {
  readonly light: Light;
  /** World direction of the sky half: unit length. */
  readonly up: Vector3;
  /** Irradiance of a surface that faces up. */
  readonly sky: Color;
  readonly ground: Color;
  readonly isIndirect: boolean;
}

export interface CollectedLights {
  readonly traced: TracedLight[];
  readonly skies: SkyLight[];
}

/** Visible lights of a scene that are baked. World matrices must be up to date. */
export function collectLights(
  scene: Object3D,
  isBaked: (light: Light) => boolean | 'indirect',
  onWarning: (sentence: string) => void,
): CollectedLights {
  const found: CollectedLights = { traced: [], skies: [] };
  const visit = (object: Object3D): void => {
    if (!object.visible) return;
    if ((object as Light).isLight) {
      const baked = isBaked(object as Light);
      if (baked !== false) addLight(object as Light, baked === 'indirect', found, onWarning);
    }
    object.children.forEach(visit);
  };
  visit(scene);
  return found;
}

function addLight(
  light: Light,
  isIndirect: boolean,
  { traced, skies }: CollectedLights,
  onWarning: (sentence: string) => void,
): void {
  const colour = new Color(light.color).multiplyScalar(light.intensity);
  if ('isAmbientLight' in light) {
    skies.push({ light: light as AmbientLight, up: new Vector3(0, 1, 0), sky: colour, ground: colour, isIndirect });
  } else if ('isHemisphereLight' in light) {
    const { groundColor, intensity } = light as HemisphereLight;
    const up = new Vector3().setFromMatrixPosition(light.matrixWorld).normalize();
    const ground = new Color(groundColor).multiplyScalar(intensity);
    skies.push({ light, up: up.lengthSq() > 0 ? up : new Vector3(0, 1, 0), sky: colour, ground, isIndirect });
  } else {
    const read = tracedLight(light, colour, isIndirect);
    if (read) {
      traced.push(read);
      if ((light as SpotLight).map || light.userData.farolMap || light.userData.farolProfile) {
        onWarning(`${describe(light)} is baked without the image that it projects.`);
      }
    } else {
      onWarning(`${describe(light)} is not baked: lights of its kind are not supported. It stays as it is.`);
    }
  }
}

function tracedLight(light: Light, colour: Color, isIndirect: boolean): TracedLight | null {
  const data = (light.userData.farol ?? {}) as BakedLightData;
  const position = new Vector3().setFromMatrixPosition(light.matrixWorld);
  const attenuation = data.attenuation ?? null;
  const base = {
    ...{ light, position, colour, attenuation, isIndirect },
    direction: new Vector3(0, 0, 1),
    range: 0,
    decay: 2,
    coneCosine: -2,
    penumbraCosine: -1,
    spotExponent: -1,
    radius: Math.max(0, data.radius ?? 0),
    ambient: new Color(...(data.ambient ?? [0, 0, 0])).multiplyScalar(light.intensity),
    halfWidth: new Vector3(),
    halfHeight: new Vector3(),
  };
  const toTarget = ({ target }: DirectionalLight | SpotLight): Vector3 =>
    position.clone().sub(new Vector3().setFromMatrixPosition(target.matrixWorld)).normalize();
  if ('isDirectionalLight' in light) {
    const radius = Math.tan(0.5 * Math.min(3, Math.max(0, data.angle ?? 0)));
    return { ...base, kind: 'directional', direction: toTarget(light as DirectionalLight), radius };
  }
  if ('isPointLight' in light || 'isSpotLight' in light) {
    const { distance, decay } = light as PointLight;
    const range = attenuation ? (attenuation.kind === 'near-far' ? attenuation.far : attenuation.range) : distance;
    const point = { ...base, kind: 'point' as const, decay, range: range > 0 && range < 1e18 ? range : 0 };
    if ('isPointLight' in light) return point;
    const { angle, penumbra } = light as SpotLight;
    return {
      ...point,
      kind: 'spot',
      direction: toTarget(light as SpotLight),
      coneCosine: Math.cos(angle),
      penumbraCosine: Math.cos(angle * (1 - penumbra)),
      spotExponent: data.spotExponent ?? -1,
    };
  }
  if ('isRectAreaLight' in light) {
    const { width, height, matrixWorld } = light as RectAreaLight;
    const [halfWidth, halfHeight, back] = [new Vector3(), new Vector3(), new Vector3()];
    matrixWorld.extractBasis(halfWidth, halfHeight, back);
    // as in three, the object rotates the sides of the light but does not scale them
    halfWidth.normalize().multiplyScalar(0.5 * width);
    halfHeight.normalize().multiplyScalar(0.5 * height);
    return { ...base, kind: data.shape ?? 'rectangle', direction: back.normalize().negate(), halfWidth, halfHeight };
  }
  return null;
}
