import {
  Color,
  type FogExp2,
  type Light,
  type LightProbe,
  type Material,
  type Object3D,
  type Scene,
  type SpotLight,
} from 'three';
import { bakedSurroundingsOf, setBakedSurroundings } from '../effects/light-probes/LightProbes';
import type { RenderItem } from '../frame/RenderItem';
import type { OtherLight } from './PixelLighting';

/** Source of light other than managed lights; turned off while other light is measured. */
export interface LightTerm {
  readonly kind: OtherLight | 'light';
  /** three's light object, if three itself lights with it; else null. */
  readonly light: Light | null;
  turnOff(): void;
  turnOn(): void;
  /** Turns the light's shadow off; null without a shadow. */
  readonly unshadow: (() => void) | null;
}

/** Properties of the host's objects, changed for draws and restored after them. */
class Held<T extends object> {
  private readonly values = new Map<T, T[keyof T]>();

  constructor(
    private readonly key: keyof T,
    private readonly off: T[keyof T],
  ) {}

  /** @returns whether the object gives light through the property */
  add(object: T): boolean {
    const value = object[this.key];
    if (value === undefined || value === this.off) return this.values.has(object);
    this.values.set(object, value);
    return true;
  }

  get isEmpty(): boolean {
    return this.values.size === 0;
  }

  readonly turnOff = (): void => {
    for (const object of this.values.keys()) object[this.key] = this.off;
  };
  readonly turnOn = (): void => {
    for (const [object, value] of this.values) object[this.key] = value;
  };
}

interface LitMaterial extends Material {
  emissive?: Color;
  emissiveIntensity: number;
  lightMap?: object | null;
  lightMapIntensity: number;
  envMap?: object | null;
  envMapIntensity: number;
  isMeshStandardMaterial?: boolean;
}

type LeftLight = Light & Partial<Pick<LightProbe, 'isLightProbe'>> & Partial<Pick<SpotLight, 'shadow'>>;

const black = new Color(0);

/**
 * Finds sources of light besides the managed lights: those of the surfaces drawn at the pixel, and of the scene.
 * @param managed - lights that are drawn one by one
 */
export function findTerms(
  root: Object3D,
  items: readonly RenderItem[],
  managed: ReadonlySet<Light>,
  layers: { test(layers: Object3D['layers']): boolean },
): LightTerm[] {
  const scene = root as Scene;
  const terms: LightTerm[] = [];
  const add = (kind: LightTerm['kind'], held: { turnOff(): void; turnOn(): void }): void =>
    void terms.push({ kind, light: null, unshadow: null, turnOff: held.turnOff, turnOn: held.turnOn });

  const emissive = new Held<LitMaterial>('emissiveIntensity', 0);
  const lightmaps = new Held<LitMaterial>('lightMapIntensity', 0);
  const reflections = new Held<LitMaterial>('envMapIntensity', 0);
  for (const { material } of items) {
    const lit = material as LitMaterial;
    if (lit.emissive !== undefined) emissive.add(lit);
    if (lit.lightMap) lightmaps.add(lit);
    if (lit.envMap && lit.isMeshStandardMaterial) reflections.add(lit);
  }
  if (!emissive.isEmpty) add('emissive', emissive);
  if (!lightmaps.isEmpty) add('lightmap', lightmaps);
  const surroundings = new Held<Scene>('environmentIntensity', 0);
  if (scene.isScene && scene.environment) surroundings.add(scene);
  if (!surroundings.isEmpty || !reflections.isEmpty) {
    add('environment', {
      turnOff: () => void (surroundings.turnOff(), reflections.turnOff()),
      turnOn: () => void (surroundings.turnOn(), reflections.turnOn()),
    });
  }
  addFog(scene, add);
  addProbes(scene, add);
  root.traverseVisible((object) => {
    const light = object as LeftLight;
    if (light.isLight !== true || managed.has(light) || !layers.test(light.layers)) return;
    if (light.intensity === 0) return;
    const held = new Held<Light>('intensity', 0);
    held.add(light);
    const shadow = light.castShadow && light.shadow ? new Held<{ intensity: number }>('intensity', 0) : null;
    shadow?.add(light.shadow!);
    terms.push({
      kind: light.isLightProbe ? 'light-probe' : 'light',
      light,
      turnOff: held.turnOff,
      turnOn: () => void (held.turnOn(), shadow?.turnOn()),
      unshadow: shadow && shadow.turnOff,
    });
  });
  return terms;
}

type Add = (kind: LightTerm['kind'], held: { turnOff(): void; turnOn(): void }) => void;

/** Adds fog: its colour is the light that it adds; black fog only dims. */
function addFog({ fog }: Scene, add: Add): void {
  const { color } = (fog ?? {}) as Partial<FogExp2>;
  if (color === undefined) return;
  const before = color.clone();
  add('fog', { turnOff: () => void color.copy(black), turnOn: () => void color.copy(before) });
}

/** Adds the probes of the effect `LightProbes`. */
function addProbes(scene: Scene, add: Add): void {
  const baked = bakedSurroundingsOf(scene);
  if (baked?.grid == null) return;
  add('probes', {
    turnOff: () => setBakedSurroundings(scene, { ...baked, grid: null }),
    turnOn: () => setBakedSurroundings(scene, baked),
  });
}
