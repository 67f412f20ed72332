/** Commands for edits by the user. Each captures the scene's state when made, and must be run before another edit. */
import { type Command, countLabel, namesOf, SetFields, t } from '@farol/editing';
import { type Component, type ComponentClass, GameObject, type Scene } from '@farol/engine';
import type { FieldOwner, FieldValue } from '@farol/engine/fields';
import { cloneTogether } from './cloneTogether';
import { componentName } from './componentName';
import { MoveComponents } from './commands/MoveComponents';
import { MoveObjects } from './commands/MoveObjects';
import { childrenOf, type Container, containerOf, placementOf, topmost } from './commands/Placement';
import { PlaceComponents } from './commands/PlaceComponents';
import { PlaceObjects } from './commands/PlaceObjects';
import { SetProperty } from './commands/SetProperty';
import { followTracks } from './timeline/followTracks';
import { nameUniquely } from './UniqueNames';

const ids = (objects: readonly GameObject[]): string[] => objects.map(({ id }) => id);

/** Names of a component and of its objects, for labels. @param components - of one type */
const ofObjects = (components: readonly Component[]): { component: string; name: string } => ({
  component: componentName(components[0]?.typeName ?? ''),
  name: components.length === 0 ? '' : namesOf(components.map(({ gameObject }) => gameObject)),
});

/**
 * Adds a new object at the end of a parent, with a unique name, and selects it.
 * @param selected - ids selected now
 */
export function addObject(scene: Scene, object: GameObject, parent: Container, selected: readonly string[]): Command {
  nameUniquely(scene, [object]);
  const placement = { object, parent, index: childrenOf(parent).length };
  return new PlaceObjects(t('Added {name}', { name: object.name }), scene, 'add', [placement], {
    done: [object.id],
    undone: selected,
  });
}

/** Deletes objects and their descendants. */
export function deleteObjects(scene: Scene, objects: readonly GameObject[]): Command {
  const tops = topmost(objects, scene);
  const placements = tops.map((object) => placementOf(object, scene));
  return new PlaceObjects(countLabel(t('Deleted'), tops), scene, 'remove', placements, {
    done: [],
    undone: ids(objects),
  });
}

/** Copies each object and its descendants; the copy comes after the original, has a unique name and is selected. */
export function duplicateObjects(scene: Scene, objects: readonly GameObject[]): Command {
  const tops = topmost(objects, scene);
  const shift = new Map<Container, number>();
  const copies = cloneTogether(tops);
  const placements = tops.map((source, i) => {
    const { parent, index } = placementOf(source, scene);
    const earlier = shift.get(parent) ?? 0;
    shift.set(parent, earlier + 1);
    return { object: copies[i], parent, index: index + 1 + earlier };
  });
  nameUniquely(scene, copies);
  return new PlaceObjects(countLabel(t('Duplicated'), tops), scene, 'add', placements, {
    done: ids(copies),
    undone: ids(objects),
  });
}

/** Whether objects may be put below a parent: it is none of them, nor below one. */
export function canMoveTo(objects: readonly GameObject[], parent: Container): boolean {
  const moving = new Set(objects);
  for (let above = parent instanceof GameObject ? parent : null; above; above = above.parent) {
    if (moving.has(above)) return false;
  }
  return true;
}

/**
 * Moves objects below a parent; their world poses stay, and clips that animate them are changed to their new paths.
 * @param index - index among the parent's other children; at the end when absent
 */
export function moveObjects(scene: Scene, objects: readonly GameObject[], parent: Container, index?: number): Command {
  const tops = topmost(objects, scene);
  const moving = new Set(tops);
  const staying = childrenOf(parent).filter((child) => !moving.has(child));
  const before = index === undefined ? null : (staying[index] ?? null);
  const name = namesOf(tops);
  let label = t('Moved {name} to the top', { name });
  if (tops.every((object) => containerOf(object, scene) === parent)) label = t('Reordered {name}', { name });
  else if (parent instanceof GameObject) label = t('Moved {name} into {parent}', { name, parent: parent.name });
  return followTracks(scene, new MoveObjects(label, scene, tops, parent, before));
}

/** Renames an object; clips that animate it are changed to its new path. */
export function renameObject(object: GameObject, name: string): Command {
  const label = t('Renamed {name} to {next}', { name: object.name, next: name });
  const command = new SetProperty(label, [object], 'name', name);
  return object.scene ? followTracks(object.scene, command) : command;
}

/** Shows or hides objects and their descendants. */
export function setActive(objects: readonly GameObject[], active: boolean): Command {
  return new SetProperty(countLabel(active ? t('Showed') : t('Hid'), objects), objects, 'active', active);
}

/** Locks objects and their descendants, so that clicks in the viewport do not pick them; or unlocks them. */
export function setLocked(objects: readonly GameObject[], locked: boolean): Command {
  return new SetProperty(countLabel(locked ? t('Locked') : t('Unlocked'), objects), objects, 'locked', locked);
}

/** Marks objects as static or moving; their children are unchanged. */
export function setStatic(objects: readonly GameObject[], isStatic: boolean): Command {
  const label = countLabel(isStatic ? t('Made static:') : t('Made moving:'), objects);
  return new SetProperty(label, objects, 'isStatic', isStatic);
}

export function setEnabled(components: readonly Component[], enabled: boolean): Command {
  const words = ofObjects(components);
  const label = enabled
    ? t('Switched on {component} of {name}', words)
    : t('Switched off {component} of {name}', words);
  return new SetProperty(label, components, 'enabled', enabled);
}

/**
 * Adds a component to each object that can take one.
 * @param values - values other than the defaults
 * @throws FieldError for a value that is not allowed
 */
export function addComponent(
  scene: Scene,
  objects: readonly GameObject[],
  type: ComponentClass,
  values: Readonly<Record<string, FieldValue>> = {},
): Command {
  const places = objects
    .filter((object) => !type.unique || !object.getComponent(type.typeName))
    .map((object) => {
      const component = new type();
      for (const name of Object.keys(values)) component.set(name, values[name]);
      return { component, object, index: object.components.length };
    });
  return new PlaceComponents(
    t('Added {component} to {name}', { component: componentName(type.typeName), name: namesOf(objects) }),
    scene,
    'add',
    places,
  );
}

export function removeComponents(scene: Scene, components: readonly Component[]): Command {
  const places = components
    .map((component) => {
      const object = component.gameObject;
      return { component, object, index: object.components.indexOf(component) };
    })
    .toSorted((a, b) => a.index - b.index);
  return new PlaceComponents(t('Removed {component} from {name}', ofObjects(components)), scene, 'remove', places);
}

/** Moves components up or down among those of their objects. @param by - -1 for up, 1 for down */
export function moveComponents(components: readonly Component[], by: number): Command {
  return new MoveComponents(
    by < 0
      ? t('Moved {component} of {name} up', ofObjects(components))
      : t('Moved {component} of {name} down', ofObjects(components)),
    components,
    by,
  );
}

/** Sets fields of all owners to equal values; an owner without a field skips it. */
export function setValues(
  label: string,
  owners: readonly FieldOwner[],
  values: Readonly<Record<string, FieldValue>>,
): Command {
  const edits = owners.flatMap((owner) =>
    Object.keys(values)
      .filter((name) => name in owner.fields && !owner.fields[name].readOnly)
      .map((name) => ({ owner, name, value: values[name] })),
  );
  return new SetFields(label, edits);
}

/**
 * Resets fields to their defaults. Components of unknown classes keep their values, since their fields have no
 * defaults.
 * @param names - names of the fields; all when absent
 */
export function resetFields(label: string, owners: readonly FieldOwner[], names?: readonly string[]): Command {
  const edits = owners.flatMap((owner) =>
    (names ?? Object.keys(owner.fields).filter((name) => owner.fields[name].viewOf === undefined))
      .map((name) => ({ owner, name, value: owner.fields[name].default }))
      .filter(({ value }) => value !== undefined),
  );
  return new SetFields(label, edits);
}
