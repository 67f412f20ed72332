import type { Vector3Tuple } from '@farol/editing/fields';
import type { Light as ThreeLight } from 'three';
import type { Scene } from '../core/Scene';

/** Factors by which a group changes its lights. */
export interface LightMaster {
  /** Factor of the intensity, 0 or more. */
  readonly dimmer: number;
  /** Factors of the linear colour. */
  readonly colour: Vector3Tuple;
}

/** A component that lights the scene. */
export interface LightSource {
  readonly id: string;
  /** Called when the choice of lights that are shown alone (solo) has changed. */
  followSolo(): void;
}

/** A light that can be in a group. */
export interface GroupedLight extends LightSource {
  /** Called when the factors of the light's group change. @param tints - whether the colour may have changed too */
  followGroup(tints: boolean): void;
}

const scenes = new WeakMap<Scene, LightGroups>();
const multiply = (a: Vector3Tuple, b: Vector3Tuple): Vector3Tuple => [a[0] * b[0], a[1] * b[1], a[2] * b[2]];

/** Lights of a scene by the id of the object that is their group, the factors of groups, and the lights shown alone. */
export class LightGroups {
  private readonly lights = new Set<LightSource>();
  private readonly members = new Map<string, Set<GroupedLight>>();
  private readonly masters = new Map<string, LightMaster>();
  private alone: ReadonlySet<string> | null = null;

  static of(scene: Scene): LightGroups {
    let groups = scenes.get(scene);
    if (!groups) scenes.set(scene, (groups = new LightGroups()));
    return groups;
  }

  /** Adds a light, when its component enters the scene. */
  add(light: LightSource): void {
    this.lights.add(light);
  }

  /** Moves a light to a group. @param group - id of the group's object; null for none */
  join(light: GroupedLight, group: string | null): void {
    this.leave(light);
    if (group === null) return;
    const members = this.members.get(group);
    if (members) members.add(light);
    else this.members.set(group, new Set([light]));
  }

  remove(light: LightSource): void {
    this.lights.delete(light);
    this.leave(light);
  }

  /** Factors of a group; null while no object with a LightGroup has the id. */
  masterOf(group: string | null): LightMaster | null {
    return group === null ? null : (this.masters.get(group) ?? null);
  }

  /** Sets the factors of a group; null when its component was removed. */
  setMaster(group: string, master: LightMaster | null): void {
    const before = this.masters.get(group);
    if (master) this.masters.set(group, master);
    else this.masters.delete(group);
    const tints = !before || !master || before.colour !== master.colour;
    for (const light of this.members.get(group) ?? []) light.followGroup(tints);
  }

  /** Whether a light is dark because others are shown alone. */
  isMuted({ id }: LightSource): boolean {
    return this.alone !== null && !this.alone.has(id);
  }

  /** Shows some lights alone (solo), or all when null. @returns the previous lights, as `ids` */
  showAlone(ids: ReadonlySet<string> | null): ReadonlySet<string> | null {
    const before = this.alone;
    this.alone = ids;
    for (const light of this.lights) light.followSolo();
    return before;
  }

  private leave(light: LightSource): void {
    for (const members of this.members.values()) members.delete(light as GroupedLight);
  }
}

/** Multiplies the colours of a three light, those in its `userData.farol` too. */
export function tintLight(light: ThreeLight, colour: Vector3Tuple): void {
  if (colour.every((channel) => channel === 1)) return;
  const { groundColor, userData } = light as ThreeLight & { groundColor?: ThreeLight['color'] };
  for (const each of [light.color, groundColor]) {
    each?.setRGB(...multiply([each.r, each.g, each.b], colour));
  }
  const { farol } = userData;
  for (const name of ['ambient', 'specular']) if (farol?.[name]) farol[name] = multiply(farol[name], colour);
}

/**
 * Shows only some lights of a scene, for editors: neither an edit nor saved. Sky, environment and baked light stay.
 * @param ids - ids of Lights and ParticleEmitters; null shows all again
 * @returns the previous ids
 */
export function soloLights(scene: Scene, ids: ReadonlySet<string> | null): ReadonlySet<string> | null {
  return LightGroups.of(scene).showAlone(ids);
}
