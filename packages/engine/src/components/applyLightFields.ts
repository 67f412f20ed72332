import type { ValuesOf, Vector3Tuple } from '@farol/editing/fields';
import {
  DirectionalLight,
  HemisphereLight,
  type Light as ThreeLight,
  PointLight,
  RectAreaLight,
  SpotLight,
  type OrthographicCamera,
} from 'three';
import type { FarolLightData } from '@farol/renderer/light-options';
import { lightOfKelvin } from '../photometry/colourTemperature';
import type { lightFields } from './lightFields';

type LightValues = Readonly<ValuesOf<typeof lightFields>>;

/** Linear colour of a light: the chosen one, or that of its temperature with luminance 1. */
export const colourOfLight = ({
  colourBy,
  diffuse,
  kelvin,
}: Pick<LightValues, 'colourBy' | 'diffuse' | 'kelvin'>): Vector3Tuple =>
  colourBy === 'temperature' ? lightOfKelvin(kelvin) : diffuse;

const isBlack = (colour: Vector3Tuple): boolean => colour.every((channel) => channel === 0);

/** Light properties that three's lights lack; undefined when there are none. */
function extraData(values: LightValues): FarolLightData | undefined {
  const data: FarolLightData = {};
  if (!isBlack(values.ambient)) data.ambient = values.ambient;
  if (values.ownSpecular) data.specular = values.specular;
  if (values.type === 'spot' && values.exponent > 0) data.spotExponent = values.exponent;
  if (values.type !== 'directional' && values.attenuation === 'near-far') {
    const { near, far } = values;
    data.attenuation = { kind: 'near-far', near: Math.min(near, far * 0.999), far };
  }
  if (values.type !== 'directional' && values.attenuation === 'polynomial') {
    const { constant, linear, quadratic, range } = values;
    data.attenuation = { kind: 'polynomial', constant, linear, quadratic, range };
  }
  return Object.keys(data).length > 0 ? data : undefined;
}

/** Distance and decay of the three light: exact for 'physical', the closest fit for other attenuations. */
function fallOff(values: LightValues): { distance: number; decay: number } {
  if (values.attenuation === 'near-far') return { distance: values.far, decay: 0 };
  if (values.attenuation === 'physical') return { distance: values.range, decay: values.decay };
  return { distance: values.range, decay: values.quadratic > 0 ? 2 : values.linear > 0 ? 1 : 0 };
}

function applyShadow(values: LightValues, light: DirectionalLight | PointLight | SpotLight, softness: number): void {
  light.castShadow = values.castShadow;
  const { shadow } = light;
  if (shadow.mapSize.x !== values.shadowMapSize) {
    shadow.mapSize.setScalar(values.shadowMapSize);
    shadow.map?.dispose();
    shadow.map = null;
  }
  shadow.radius = values.shadowRadius * softness;
  shadow.bias = values.shadowBias;
  shadow.normalBias = values.shadowNormalBias;
  if (!(light instanceof DirectionalLight)) return;
  const camera: OrthographicCamera = light.shadow.camera;
  camera.left = camera.bottom = -values.shadowExtent;
  camera.right = camera.top = values.shadowExtent;
  camera.near = -4 * values.shadowExtent;
  camera.far = 4 * values.shadowExtent;
  camera.updateProjectionMatrix();
}

function applyArea(values: LightValues, light: RectAreaLight): void {
  light.width = values.width;
  light.height = values.height;
  light.castShadow = values.castShadow;
  const data: FarolLightData = {};
  if (values.type === 'disc' || values.type === 'tube') data.shape = values.type;
  if (values.areaRange > 0) data.range = values.areaRange;
  if (values.castShadow) {
    data.shadowMapSize = values.shadowMapSize;
    data.shadowNormalBias = values.shadowNormalBias;
  }
  if (Object.keys(data).length > 0) light.userData.farol = data;
}

/**
 * Writes the fields of a Light to the three light of its type.
 * @param softness - factor of `shadowRadius`
 */
export function applyLightFields(values: LightValues, light: ThreeLight, softness = 1): void {
  light.color.setRGB(...colourOfLight(values));
  light.intensity = values.intensity;
  delete light.userData.farol;
  if (light instanceof HemisphereLight) light.groundColor.setRGB(...values.groundColour);
  if (light instanceof RectAreaLight) applyArea(values, light);
  if (!(light instanceof DirectionalLight || light instanceof PointLight || light instanceof SpotLight)) return;
  const extra = extraData(values);
  if (extra) light.userData.farol = extra;
  if (!(light instanceof DirectionalLight)) Object.assign(light, fallOff(values));
  if (light instanceof SpotLight) {
    light.angle = values.cutoff;
    light.penumbra = values.penumbra;
  }
  applyShadow(values, light, softness);
}
