import { setLightOptions } from '@farol/renderer/light-options';
import { PointLight, RectAreaLight, SpotLight, type Texture } from 'three';
import type { SingleLightKind } from '../plan/lightKinds';
import type { MovingLight } from './StageScene';

/** Of a spot light: half of its cone (rad), and the part of it that fades. */
const SPOT = { angle: 0.7, penumbra: 0.3 };
/** Sides of a rectangle (m). */
const RECTANGLE = { width: 0.4, height: 0.25 };

/** Makes of a point light, and its place in the list, one of a kind that shines as brightly where it shines most. */
type Maker = (point: PointLight, index: number) => MovingLight;

function spot(point: PointLight): SpotLight {
  const { color, intensity, distance, decay } = point;
  const light = new SpotLight(color, intensity, distance, SPOT.angle, SPOT.penumbra, decay);
  light.position.copy(point.position);
  // goes where the light goes
  light.add(light.target);
  light.target.position.set(0, -1, 0);
  return light;
}

function rectangle(point: PointLight): RectAreaLight {
  const { width, height } = RECTANGLE;
  // straight ahead radiance (nits) times area is intensity (cd)
  const light = new RectAreaLight(point.color, point.intensity / (width * height), width, height);
  light.position.copy(point.position);
  // it shines along its -z
  light.rotation.x = -Math.PI / 2;
  light.userData.farol = { range: point.distance };
  return light;
}

/**
 * What makes the lights of a kind.
 *
 * @param profiles - textures that points with profiles have in turns
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
