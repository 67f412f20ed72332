/** Commands for edits of prefabs. Each captures the scene's state when the command is made. */
import { type Command, labelOfField, SetFields, t } from '@farol/editing';
import type { Component, GameObject, Scene } from '@farol/engine';
import {
  type FieldOverride,
  isInstanceRoot,
  makePrefab,
  planApplyAll,
  planApplyField,
  planRevertAll,
  planUnpack,
  type Prefab,
  type PrefabEdit,
  type PrefabPlan,
  withoutPin,
} from '@farol/engine/prefabs';
import { MoveLocal } from './commands/MoveLocal';
import type { Container } from './commands/Placement';
import { PlaceComponents } from './commands/PlaceComponents';
import { PlaceObjects } from './commands/PlaceObjects';
import { Sequence } from './commands/Sequence';
import { SetPrefab } from './commands/SetPrefab';
import { SetProperty } from './commands/SetProperty';
import { deleteObjects } from './edits';
import { followTracks } from './timeline/followTracks';

const stay = { done: [], undone: [] };

/** Command for one edit of a plan that the engine made. */
function commandOf(scene: Scene, edit: PrefabEdit): Command {
  switch (edit.kind) {
    case 'field':
      return new SetFields('Set field', [{ owner: edit.component, name: edit.field, value: edit.value }]);
    case 'enabled':
      return new SetProperty('Enable', [edit.component], 'enabled', edit.value);
    case 'name':
      return new SetProperty('Rename', [edit.object], 'name', edit.value);
    case 'active':
      return new SetProperty('Show', [edit.object], 'active', edit.value);
    case 'static':
      return new SetProperty('Static', [edit.object], 'isStatic', edit.value);
    case 'tags':
      return new SetProperty('Tag', [edit.object], 'tags', edit.value);
    case 'link':
      return new SetProperty('Link', [edit.object], 'prefabLink', edit.value);
    case 'add-component': {
      const { object, component, id } = edit;
      const place = { object, component, index: object.components.length, id };
      return new PlaceComponents('Add component', scene, 'add', [place]);
    }
    case 'remove-component': {
      const { object, component } = edit;
      const place = { object, component, index: object.components.indexOf(component) };
      return new PlaceComponents('Remove component', scene, 'remove', [place]);
    }
    case 'add-object': {
      const { object, parent } = edit;
      const place = { object, parent, index: parent.children.length };
      return new PlaceObjects('Add object', scene, 'add', [place], stay);
    }
    case 'remove-object':
      return deleteObjects(scene, [edit.object]);
    case 'move-object':
      return new MoveLocal(scene, edit.object, edit.parent);
  }
}

/** Runs a whole plan as one undo step. @param selected - ids that stay selected */
function planned(label: string, scene: Scene, plan: PrefabPlan, selected: readonly string[]): Command {
  const edits = new Sequence(
    label,
    [
      ...plan.prefabs.map((prefab) => () => new SetPrefab(scene, prefab.id, prefab)),
      ...plan.edits.map((edit) => () => commandOf(scene, edit)),
    ],
    { done: selected, undone: selected },
  );
  return followTracks(scene, edits);
}

const fieldWords = (component: Component, field: string): { field: string; name: string } => ({
  field: labelOfField(field, component.fields[field]).toLowerCase(),
  name: component.gameObject.name,
});

/**
 * Makes a prefab from an object and its descendants; the object becomes the first instance. @throws PrefabError for a
 * part of an instance
 */
export function createPrefab(scene: Scene, object: GameObject, selected: readonly string[]): Command {
  const { prefab: made, links } = makePrefab(object);
  // a slash would create a folder of assets
  const prefab = { ...made, name: made.name.replaceAll('/', '-') };
  const edits = [...links].map(([each, value]): PrefabEdit => ({ kind: 'link', object: each, value }));
  return planned(t('Made prefab {name}', { name: prefab.name }), scene, { prefabs: [prefab], edits }, selected);
}

/** Applies all overrides of an instance to its prefab; other instances follow. */
export function applyInstance(scene: Scene, root: GameObject, selected: readonly string[]): Command {
  return planned(t('Applied {name} to its prefab', { name: root.name }), scene, planApplyAll(root), selected);
}

/** Applies one overridden field of an instance to its prefab; other instances follow. */
export function applyField(scene: Scene, component: Component, field: string, selected: readonly string[]): Command {
  return planned(
    t('Applied {field} of {name} to its prefab', fieldWords(component, field)),
    scene,
    planApplyField(component, field),
    selected,
  );
}

export function revertInstance(scene: Scene, root: GameObject, selected: readonly string[]): Command {
  return planned(
    t('Reverted {name} to its prefab', { name: root.name }),
    scene,
    { prefabs: [], edits: planRevertAll(root) },
    selected,
  );
}

/** Restores the prefab's value of an instance's field. */
export function revertField(scene: Scene, override: FieldOverride, selected: readonly string[]): Command {
  const { component, field, base } = override;
  const object = component.gameObject;
  const pin = override.path.slice(override.path.indexOf('/') + 1);
  const edits: PrefabEdit[] = [{ kind: 'field', component, field, value: base }];
  if (object.prefabLink?.pinned) edits.push({ kind: 'link', object, value: withoutPin(object.prefabLink, pin) });
  return planned(
    t('Reverted {field} of {name} to its prefab', fieldWords(component, field)),
    scene,
    { prefabs: [], edits },
    selected,
  );
}

/** Turns an instance into plain objects. */
export function unpackInstance(scene: Scene, root: GameObject, selected: readonly string[]): Command {
  return planned(t('Unpacked {name}', { name: root.name }), scene, { prefabs: [], edits: planUnpack(root) }, selected);
}

export function renamePrefab(scene: Scene, prefab: Prefab, name: string): Command {
  return new Sequence(t('Renamed prefab {name} to {next}', { name: prefab.name, next: name }), [
    () => new SetPrefab(scene, prefab.id, { ...prefab, name }),
  ]);
}

export function instancesOf(scene: Scene, id: string): GameObject[] {
  const roots: GameObject[] = [];
  scene.traverse((object) => {
    if (object.prefabLink?.prefab === id && isInstanceRoot(object)) roots.push(object);
  });
  return roots;
}

/** Deletes a prefab; its instances, in the scene and in other prefabs, become plain objects. */
export function deletePrefab(scene: Scene, prefab: Prefab, selected: readonly string[]): Command {
  const others = scene.prefabs.list.flatMap((other): Prefab[] => {
    if (!other.objects.some((object) => object.prefab?.prefab === prefab.id)) return [];
    const objects = other.objects.map((object) => {
      if (object.prefab?.prefab !== prefab.id) return object;
      const { prefab: _link, ...rest } = object;
      return rest;
    });
    return [{ ...other, objects }];
  });
  const edits = instancesOf(scene, prefab.id).flatMap(planUnpack);
  return new Sequence(
    t('Deleted prefab {name}', { name: prefab.name }),
    [
      ...edits.map((edit) => () => commandOf(scene, edit)),
      ...others.map((other) => () => new SetPrefab(scene, other.id, other)),
      () => new SetPrefab(scene, prefab.id, null),
    ],
    { done: selected, undone: selected },
  );
}

/** Whether an instance of a prefab can be added below a parent: not within an instance of the same prefab. */
export function canPlacePrefab(scene: Scene, prefab: Prefab, parent: Container): boolean {
  for (let above: Container | null = parent; above && 'prefabLink' in above; above = above.parent) {
    if (above.prefabLink && scene.prefabs.contains(prefab.id, above.prefabLink.prefab)) return false;
  }
  return true;
}
