import { setLightOptions } from '@farol/renderer/light-options';
import { PointLight, RectAreaLight, SpotLight, type Texture } from 'three';
import type { SingleLightKind } from '../plan/lightKinds';
import type { MovingLight } from './StageScene';

/** Half angle of a spot light's cone (radians), and the share of the cone in which it fades. */
const SPOT = { angle: 0.7, penumbra: 0.3 };
/** Sides of a rectangle (m). */
const RECTANGLE = { width: 0.4, height: 0.25 };

/** Creates a light of another kind from a point light (by its index in the list), with the same peak intensity. */
type Maker = (point: PointLight, index: number) => MovingLight;

function spot(point: PointLight): SpotLight {
  const { color, intensity, distance, decay } = point;
  const light = new SpotLight(color, intensity, distance, SPOT.angle, SPOT.penumbra, decay);
  light.position.copy(point.position);
  // the target is a child of the light, so that it moves with the light
  light.add(light.target);
  light.target.position.set(0, -1, 0);
  return light;
}

function rectangle(point: PointLight): RectAreaLight {
  const { width, height } = RECTANGLE;
  // radiance (nits) times area is the intensity straight ahead (candela)
  const light = new RectAreaLight(point.color, point.intensity / (width * height), width, height);
  light.position.copy(point.position);
  // rectangles shine along their -z
  light.rotation.x = -Math.PI / 2;
  light.userData.farol = { range: point.distance };
  return light;
}

/**
 * Returns the function that creates lights of a kind.
 *
 * @param profiles - textures of light profiles, assigned in rotation
 */
export function lightMaker(kind: SingleLightKind, profiles: readonly Texture[]): Maker {
  if (kind === 'spots') return spot;
  if (kind === 'rectangles') return rectangle;
  if (kind === 'points') return (point) => point;
  return (point, index) => {
    setLightOptions(point, { profile: profiles[index % profiles.length] });
    return point;
  };
}
