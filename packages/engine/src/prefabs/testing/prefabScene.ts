import { object } from '@farol/editing/fields';
import { Light } from '../../components/Light';
import { ObjectRenderer } from '../../components/ObjectRenderer';
import { GameObject } from '../../core/GameObject';
import { Scene } from '../../core/Scene';
import { component } from '../../core/Component';
import { ComponentRegistry } from '../../core/ComponentRegistry';
import { builtinComponents } from '../../components/index';
import { instantiatePrefab } from '../instantiatePrefab';
import { makePrefab } from '../makePrefab';
import type { PrefabPlan } from '../planPrefabChange';
import type { Prefab } from '../../core/Prefab';
import { applyPrefabEdit, type PrefabEdit } from '../PrefabEdit';

export class Follower extends component({ target: object(null, { help: 'What it follows.' }) }) {
  static override readonly typeName: string = 'Follower';
}

export const registry = new ComponentRegistry([...builtinComponents.types.values(), Follower]);
/** The scene of the present test; `newScene` replaces it. */
export let scene: Scene;

export function newScene(known: ComponentRegistry = registry): void {
  scene = new Scene({ registry: known });
}

export const run = (plan: PrefabPlan | readonly PrefabEdit[]): void => {
  if ('prefabs' in plan) for (const prefab of plan.prefabs) scene.prefabs.set(prefab);
  ('prefabs' in plan ? plan.edits : plan).forEach(applyPrefabEdit);
};

/** A lamp that contains a bulb (a light); it is the first instance of its prefab. */
export function lampPrefab(): { lamp: GameObject; prefab: Prefab } {
  const lamp = new GameObject('Lamp');
  lamp.transform.position = [1, 0, 0];
  lamp.addComponent(ObjectRenderer, { mesh: 'cylinder' });
  const bulb = new GameObject('Bulb');
  bulb.addComponent(Light, { intensity: 5 });
  lamp.add(bulb);
  scene.add(lamp);
  return { lamp, prefab: take(lamp) };
}

/** Makes a prefab of an object, which becomes its first instance. */
export function take(from: GameObject): Prefab {
  const made = makePrefab(from);
  scene.prefabs.set(made.prefab);
  for (const [each, link] of made.links) each.prefabLink = link;
  return made.prefab;
}

export function place(prefab: Prefab, parent: GameObject | Scene = scene): GameObject {
  const instance = instantiatePrefab(scene.prefabs.get(prefab.id)!, registry);
  parent.add(instance);
  return instance;
}

export const lightOf = (root: GameObject): Light => root.find('Bulb')!.getComponent(Light)!;
