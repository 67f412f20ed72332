import { t } from '@farol/editing';
import type { Light } from '@farol/engine';
import { lightExtrasOf } from '@farol/engine/files';
import { Color, DirectionalLight, type Light as ThreeLight, Object3D, PointLight, SpotLight } from 'three';
import type { PhotometricProfile } from '@farol/renderer/light-profiles';
import type { ProfileLight } from './GltfProfiles';

/** Smallest softness of a spot light's edge, since glTF allows no hard edge. */
const THINNEST_EDGE = 1e-3;

/** Falloff of a light: share of its intensity that is left at a distance (m). */
function left(light: Light, distance: number): number {
  if (light.attenuation === 'near-far') {
    return Math.min(1, Math.max(0, (light.far - distance) / Math.max(1e-6, light.far - light.near)));
  }
  if (light.attenuation === 'polynomial') {
    return 1 / Math.max(1e-6, light.constant + light.linear * distance + light.quadratic * distance ** 2);
  }
  return distance ** -light.decay;
}

/** Intensity factor with which a light of inverse-square falloff is as bright as `light` half way to its range. */
function asBright(light: Light): number {
  const hasPlace = light.type === 'point' || light.type === 'spot';
  if (!hasPlace || (light.attenuation === 'physical' && light.decay === 2)) return 1;
  const half = (Number.isFinite(light.reach) ? light.reach : 2) / 2;
  // with a range, three and glTF multiply by (1 - (d / range)^4)^2: half way, by (1 - 0.5^4)^2
  const end = light.attenuation !== 'physical' && Number.isFinite(light.reach) ? (1 - 0.5 ** 4) ** 2 : 1;
  return (left(light, half) * half ** 2) / end;
}

/** An area light, which glTF does not support: a node whose extras have its fields, readable by Farol. */
export function gltfShapeLight({ type, width, height, colour, intensity, areaRange }: Light): Object3D {
  const node = new Object3D();
  node.userData.farolLight = { type, width, height, diffuse: [...colour], intensity, areaRange };
  return node;
}

/** Properties of a light that glTF cannot express, kept in extras or lost; null for none. @see KHR_lights_punctual */
export function whatIsLost(light: Light): string | null {
  const hasPlace = light.type === 'point' || light.type === 'spot';
  if (hasPlace && (light.attenuation !== 'physical' || light.decay !== 2)) {
    return t(
      'Lights that fade in a way of their own do so in Farol alone; elsewhere they fade as in nature, as bright half way',
    );
  }
  if (light.type === 'spot' && light.exponent > 0) {
    return t('Spot lights with an exponent keep it in Farol alone; elsewhere they have an edge');
  }
  if (light.ownSpecular || light.ambient.some((channel) => channel > 0)) {
    return t('Second colours of lights are kept in Farol alone');
  }
  return null;
}

/** Further losses of a light with a photometric profile; null for none. @see EXT_lights_ies */
export function whatProfileLoses(source: ThreeLight): string | null {
  if (source instanceof SpotLight) return t('Cones of lights with a profile are left out');
  if (source instanceof PointLight && source.distance > 0)
    return t('Lights with a profile have an end in Farol alone; elsewhere they go on');
  return null;
}

/** Splits a light's colour into a colour within glTF's range and a factor. */
function split(source: ThreeLight): { colour: Color; largest: number } {
  const colour = source.color.clone();
  const largest = Math.max(1, colour.r, colour.g, colour.b);
  return { colour: colour.multiplyScalar(1 / largest), largest };
}

/**
 * A node for a light with a photometric profile, which points along -z, and the profile's data.
 * @param light - the component; null when there is none
 */
export function gltfProfileLight(
  source: PointLight | SpotLight,
  profile: PhotometricProfile,
  light: Light | null,
): { node: Object3D; light: ProfileLight } {
  const { colour, largest } = split(source);
  const maximum = profile.maximumIntensity;
  const intensity = source.intensity * largest * (light ? asBright(light) : 1);
  const node = new Object3D();
  // three's point lights with profiles point along -y
  if (source instanceof PointLight) node.rotation.x = -Math.PI / 2;
  const { distance, color } = source;
  // the range is stored in extras, since EXT_lights_ies has none
  const end = distance > 0 && { intensity: source.intensity, color: color.toArray(), distance, decay: 2 };
  const extras = source instanceof PointLight && (lightExtrasOf(source, largest > 1) ?? end);
  if (extras) node.userData.farolLight = extras;
  return { node, light: { profile, multiplier: maximum > 0 ? intensity / maximum : 0, color: colour.toArray() } };
}

/**
 * Converts a light to glTF, with inverse-square falloff; null for ambient kinds. A light with another falloff keeps its
 * brightness half way to its range, and its real parameters in extras.
 * @see KHR_lights_punctual
 */
export function gltfLight(source: ThreeLight, light: Light | null): ThreeLight | null {
  if (!(source instanceof DirectionalLight || source instanceof PointLight || source instanceof SpotLight)) return null;
  const { colour, largest } = split(source);
  const intensity = source.intensity * largest * (light ? asBright(light) : 1);
  let copy: DirectionalLight | PointLight | SpotLight;
  if (source instanceof SpotLight) {
    const penumbra = Math.max(THINNEST_EDGE, source.penumbra);
    copy = new SpotLight(colour, intensity, source.distance, source.angle, penumbra);
  } else if (source instanceof PointLight) copy = new PointLight(colour, intensity, source.distance);
  else copy = new DirectionalLight(colour, intensity);
  copy.position.set(0, 0, 0);
  const extras = lightExtrasOf(source, largest > 1);
  if (extras) copy.userData.farolLight = extras;
  // GLTFExporter would write the target as a node; glTF lights always point along -z
  if (!(copy instanceof PointLight)) Reflect.deleteProperty(copy, 'target');
  return copy;
}
