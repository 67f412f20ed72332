import { type Command, countLabel, SetFields, t } from '@farol/editing';
import { GameObject, LightGroup, type Scene } from '@farol/engine';
import { PlaceObjects } from '../commands/PlaceObjects';
import { Sequence } from '../commands/Sequence';
import { UniqueNames } from '../UniqueNames';
import type { LightSource } from './lightSource';

const putInto = (lights: readonly LightSource[], group: GameObject | null, label: string): Command =>
  new SetFields(
    label,
    lights.map((owner) => ({ owner, name: 'group', value: group?.id ?? null })),
  );

/** Groups lights under a new LightGroup, at the top of the tree, and selects it. @param selected - ids selected now */
export function makeLightGroup(scene: Scene, lights: readonly LightSource[], selected: readonly string[]): Command {
  const object = new GameObject(new UniqueNames(scene).take(t('Light group')));
  object.addComponent(LightGroup);
  const place = { object, parent: scene, index: scene.roots.length };
  return new Sequence(
    t('Made {group} of lights', { group: object.name }),
    [
      () => new PlaceObjects('Add group', scene, 'add', [place], { done: [], undone: [] }),
      () => putInto(lights, object, 'Put into group'),
    ],
    { done: [object.id], undone: selected },
  );
}

/** Moves lights to a group, or out of their groups when null. */
export function moveToLightGroup(lights: readonly LightSource[], group: GameObject | null): Command {
  const objects = lights.map(({ gameObject }) => gameObject);
  const label = countLabel(group ? t('Put into a light group:') : t('Took out of their light group:'), objects);
  return putInto(lights, group, label);
}
