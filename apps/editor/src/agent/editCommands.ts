import { type Command, SetFields } from '@farol/editing';
import { type Component, GameObject, type Scene } from '@farol/engine';
import type { FieldOwner, FieldValue, Vector3Tuple } from '@farol/engine/fields';
import { instantiatePrefab } from '@farol/engine/prefabs';
import type { Edit } from '@farol/mcp/tools';
import { Matrix4, Quaternion, Vector3 } from 'three';
import type { EditorApi } from '../api/EditorApi';
import { giveSky } from '../files/library/giveSky';
import { bringItem } from '../files/library/placeLibraryItem';
import { poseEdits } from '../model/cameraEdits';
import type { Container } from '../model/commands/Placement';
import { Sequence } from '../model/commands/Sequence';
import { addComponent, addObject, deleteObjects, moveObjects, removeComponents } from '../model/edits';
import { renameObject, setActive, setLocked, setStatic } from '../model/edits';
import { buildLibraryItem } from '../model/library/buildLibraryItem';
import { skies } from '../model/library/skies';
import { creationNames, libraryId } from './creationNames';
import { duplicateAlong } from './duplicateAlong';
import { storedValue } from './fieldValues';
import { findObject, findObjects } from './findObjects';

type EditOf<Name extends Edit['edit']> = Extract<Edit, { edit: Name }>;
type Values = Readonly<Record<string, unknown>>;

interface Place {
  readonly position?: readonly number[];
  readonly rotation?: readonly number[];
  readonly scale?: readonly number[];
  readonly lookAt?: readonly number[];
  readonly by?: readonly number[];
}

/** A prepared edit of an agent; each of its commands is made once the commands before it are done. */
export interface PreparedEdit {
  readonly make: readonly (() => Command)[];
  /** Objects that the edit added or changed, once it is done. */
  touched(): readonly GameObject[];
}

const setValues = (label: string, owner: FieldOwner, values: Values, scene: Scene): Command =>
  new SetFields(
    label,
    Object.entries(values).map(([name, value]) => ({ owner, name, value: storedValue(owner, name, value, scene) })),
  );

const containerOf = (scene: Scene, reference: string | undefined): Container =>
  reference === undefined || reference === 'scene' ? scene : findObject(scene, reference);

/** The only component of a type on an object. @throws Error that lists the object's components */
function componentOf(object: GameObject, type: string): Component {
  const [found, second] = object.getComponents(type);
  if (!found) {
    const types = object.components.map(({ typeName }) => typeName).join(', ');
    throw new Error(`“${object.name}” has no ${type}; it has ${types}. add_component adds one.`);
  }
  if (second) throw new Error(`“${object.name}” has several components of type ${type}: edit them by hand.`);
  return found;
}

/** Commands that place an object, relative to its parent. */
function placing(object: GameObject, { position, rotation, scale, lookAt, by }: Place, scene: Scene): Command {
  const { transform } = object;
  const values: Record<string, unknown> = {};
  const before = transform.getAuthored('position') as Vector3Tuple;
  if (position ?? by) values.position = (position ?? before).map((each, i) => each + (by?.[i] ?? 0));
  if (rotation) values.rotation = rotation;
  if (scale) values.scale = scale;
  if (lookAt) {
    const world = new Vector3(...((values.position ?? before) as Vector3Tuple));
    if (object.parent) world.applyMatrix4(object.parent.transform.modelMatrix);
    const matrix = new Matrix4().lookAt(world, new Vector3(...(lookAt as Vector3Tuple)), new Vector3(0, 1, 0));
    const quaternion = new Quaternion().setFromRotationMatrix(matrix);
    const [, turned] = poseEdits(object, { position: world, quaternion });
    return new SetFields('', [
      ...Object.entries(values)
        .filter(([name]) => name !== 'rotation')
        .map(([name, value]) => ({ owner: transform, name, value: storedValue(transform, name, value, scene) })),
      turned,
    ]);
  }
  return setValues('', transform, values, scene);
}

const isPlacing = (place: Place): boolean =>
  Object.values([place.position, place.rotation, place.scale, place.lookAt, place.by]).some(Boolean);

async function addEdit(editor: EditorApi, edit: EditOf<'add_object'>): Promise<PreparedEdit> {
  const { scene, selection } = editor.document;
  const id = libraryId(edit.what);
  if (id !== null && Object.hasOwn(skies, id)) {
    const sky = skies[id as keyof typeof skies];
    return { make: [() => giveSky(scene, edit.what, sky, selection.ids)], touched: () => [] };
  }
  const item = id === null ? null : buildLibraryItem(id);
  let object: GameObject;
  if (item === null) object = await creationNames(scene).make(edit.what);
  const make = [
    () => {
      // made here, not earlier: an edit before this one may have added the prefab
      const { prefab, steps } = item === null ? { prefab: null, steps: [] } : bringItem(scene, item);
      if (prefab !== null) object = instantiatePrefab(prefab, scene.registry);
      if (edit.name !== undefined) object.name = edit.name;
      const add = addObject(scene, object, containerOf(scene, edit.parent), selection.ids);
      return new Sequence(add.label, [...steps, () => add]);
    },
    ...(isPlacing(edit) ? [() => placing(object, edit, scene)] : []),
    ...Object.entries(edit.components ?? {}).map(([type, values]) => () => {
      const found = object.getComponent(type);
      return found ? setValues('', found, values, scene) : added(scene, object, type, values);
    }),
  ];
  return { make, touched: () => [object] };
}

/** Command that adds a component. @throws Error for an unknown type, or a second one of a `unique` type */
function added(scene: Scene, object: GameObject, type: string, values: Values = {}): Command {
  const found = scene.registry.get(type);
  if (found.unique && object.getComponent(type))
    throw new Error(`“${object.name}” has a ${type} already, and can have one only: set_fields changes it.`);
  const blank = new found();
  const stored = Object.entries(values).map(([name, value]): [string, FieldValue] => [
    name,
    storedValue(blank, name, value, scene),
  ]);
  return addComponent(scene, [object], found, Object.fromEntries(stored));
}

const ownProperties: Readonly<Record<string, (object: GameObject, value: never) => Command>> = {
  name: (object, value: string) => renameObject(object, value),
  active: (object, value: boolean) => setActive([object], value),
  locked: (object, value: boolean) => setLocked([object], value),
  static: (object, value: boolean) => setStatic([object], value),
};

/** Command that sets a property of the object itself. @throws Error that lists the properties */
function setOwn(object: GameObject, name: string, value: unknown): Command {
  const isText = name === 'name';
  if (!Object.hasOwn(ownProperties, name))
    throw new Error(`Object has no field “${name}”. Its fields are ${Object.keys(ownProperties).join(', ')}.`);
  if (typeof value !== (isText ? 'string' : 'boolean') || value === '')
    throw new Error(`Object.${name} must be ${isText ? 'text' : 'true or false'}, not ${JSON.stringify(value)}.`);
  return ownProperties[name](object, value as never);
}

function setEdit(scene: Scene, { object: reference, component, values }: EditOf<'set_fields'>): PreparedEdit {
  if (reference === 'scene') return { make: [() => setValues('', scene.settings, values, scene)], touched: () => [] };
  const object = (): GameObject => findObject(scene, reference);
  let found: GameObject | null = null;
  if (component === undefined)
    throw new Error('Say which component: its type, such as "Light", or "Object" for name, active, locked, static.');
  const make =
    component === 'Object'
      ? Object.entries(values).map(
          ([name, value]) =>
            () =>
              setOwn((found ??= object()), name, value),
        )
      : [() => setValues('', componentOf((found = object()), component), values, scene)];
  return { make, touched: () => (found ? [found] : []) };
}

function moveEdit(scene: Scene, edit: EditOf<'move_object'>): PreparedEdit {
  let found: GameObject | null = null;
  const object = (): GameObject => (found ??= findObject(scene, edit.object));
  const intoParent = (): Command => moveObjects(scene, [object()], containerOf(scene, edit.parent));
  const make = [
    ...(edit.parent === undefined ? [] : [intoParent]),
    ...(isPlacing(edit) ? [() => placing(object(), edit, scene)] : []),
  ];
  if (make.length === 0) throw new Error('Say where to: position, by, rotation, scale, lookAt or parent.');
  return { make, touched: () => (found ? [found] : []) };
}

function deleteEdit(scene: Scene, { objects, component }: EditOf<'delete'>): PreparedEdit {
  const all = (): GameObject[] => findObjects(scene, objects);
  const make = (): Command => {
    if (component === undefined) return deleteObjects(scene, all());
    if (component === 'Transform') throw new Error('The Transform cannot be removed: delete the object.');
    return removeComponents(
      scene,
      all().map((object) => componentOf(object, component)),
    );
  };
  return { make: [make], touched: () => [] };
}

function duplicateEdit(editor: EditorApi, edit: EditOf<'duplicate_along'>): PreparedEdit {
  const { scene } = editor.document;
  let before = new Set<GameObject>();
  const all = (): GameObject[] => {
    const found: GameObject[] = [];
    scene.traverse((object) => found.push(object));
    return found;
  };
  const make = (): Command => {
    before = new Set(all());
    return duplicateAlong(editor, edit);
  };
  return { make: [make], touched: () => all().filter((object) => !before.has(object)) };
}

/**
 * Fetches what an edit needs.
 * @throws Error (as a rejection) for an edit that cannot be made, whatever the scene holds; commands throw for what depends
 *   on the scene
 */
export async function prepareEdit(editor: EditorApi, edit: Edit): Promise<PreparedEdit> {
  const { scene } = editor.document;
  switch (edit.edit) {
    case 'add_object':
      return addEdit(editor, edit);
    case 'set_fields':
      return setEdit(scene, edit);
    case 'add_component': {
      let found: GameObject | null = null;
      const make = (): Command => added(scene, (found = findObject(scene, edit.object)), edit.component, edit.values);
      return { make: [make], touched: () => (found ? [found] : []) };
    }
    case 'move_object':
      return moveEdit(scene, edit);
    case 'duplicate_along':
      return duplicateEdit(editor, edit);
    case 'delete':
      return deleteEdit(scene, edit);
  }
}
