import { t } from '@farol/editing';
import { type GameObject, gameObjectOf, Light, ObjectRenderer, ParticleEmitter, type Scene } from '@farol/engine';
import type { OtherLight, PixelLighting } from '@farol/renderer/pixel-lighting';
import type { Color } from 'three';
import { CostEstimate, type CostView } from '../../model/lights/lightCost';

/** A line of the list: a light of the scene, or light without an object, such as the environment. */
export interface ShareLine {
  readonly key: string;
  readonly name: string;
  /** Object that clicking the line selects; null for light without an object. */
  readonly object: GameObject | null;
  /** Light of this line at the pixel, linear RGB. */
  readonly color: Color;
  /** Part of all light that reaches the pixel, 0 to 1. */
  readonly share: number;
  /** `share` if the light cast no shadow; null when it casts none. */
  readonly unshadowed: number | null;
  /** `color` if the light cast no shadow; null when it casts none. */
  readonly unshadowedColor: Color | null;
  /** Distance from the light to the surface (m); null for light without a position. */
  readonly distance: number | null;
  /** Estimated share of the lighting time in the picture, 0 to 1; null for light without an object. */
  readonly cost: number | null;
}

/** Surface visible at the pixel, with its object and material. */
export interface SurfaceLine {
  readonly key: string;
  readonly object: GameObject;
  /** Name of the material's asset; null for a material of the object's own. */
  readonly material: string | null;
}

/** Light of a pixel with the objects that it comes from. */
export interface PixelReading {
  readonly lighting: PixelLighting;
  readonly lights: readonly ShareLine[];
  readonly others: readonly ShareLine[];
  readonly surfaces: readonly SurfaceLine[];
}

const luminanceOf = ({ r, g, b }: Color): number => 0.2126 * r + 0.7152 * g + 0.0722 * b;

/** Names of light without an object. */
const labelOfOther = (kind: OtherLight, count: number): string =>
  ({
    ambient: t('Ambient light'),
    hemisphere: t('Hemisphere light'),
    'light-probe': t('Light probe'),
    environment: t('Environment'),
    probes: t('Baked light probes'),
    lightmap: t('Lightmap'),
    emissive: t('Emissive'),
    fog: t('Fog'),
    unlit: t('Background and unlit'),
    lights: t('{count} weaker lights', { count }),
  })[kind];

/** Estimated costs of all lights, by their objects. */
function costsOf(scene: Scene, view: CostView): ReadonlyMap<GameObject, number> {
  const emitters = scene.componentsOf(ParticleEmitter).filter(({ shine }) => shine);
  const sources = [...scene.componentsOf(Light), ...emitters];
  const run = new CostEstimate(sources, view);
  let costs = run.next();
  while (costs === null) costs = run.next();
  return new Map(sources.map(({ gameObject }, i) => [gameObject, costs[i]]));
}

/** Converts the renderer's analysis of a pixel to lines with the scene's objects. */
export function readPixel(lighting: PixelLighting, scene: Scene, view: CostView): PixelReading {
  const costs = costsOf(scene, view);
  const whole = luminanceOf(lighting.sum);
  const partOf = (color: Color): number => (whole > 0 ? luminanceOf(color) / whole : 0);
  const lights = lighting.lights.map(({ light, index, color, unshadowed, share, distance }, i): ShareLine => {
    const object = gameObjectOf(light);
    const name = object?.name ?? (light.name || light.type);
    return {
      key: `light ${i}`,
      name: index === null ? name : `${name} ${index + 1}`,
      object,
      ...{ color, share, distance },
      unshadowed: partOf(unshadowed),
      unshadowedColor: unshadowed,
      cost: (object && costs.get(object)) ?? null,
    };
  });
  const others = lighting.others.map(({ kind, light, count, color, share }, i): ShareLine => {
    const object = light && gameObjectOf(light);
    const name = object?.name ?? labelOfOther(kind, count);
    const nothing = { unshadowed: null, unshadowedColor: null, distance: null, cost: null };
    return { key: `other ${i}`, name, object, color, share, ...nothing };
  });
  return { lighting, lights, others, surfaces: surfacesOf(lighting) };
}

function surfacesOf({ surfaces }: PixelLighting): SurfaceLine[] {
  return surfaces.flatMap(({ object: three, instanceId }, i) => {
    const object = gameObjectOf(three, instanceId ?? undefined);
    if (object === null) return [];
    return [{ key: `${i}`, object, material: object.getComponent(ObjectRenderer)?.material ?? null }];
  });
}
