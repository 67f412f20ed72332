import { type Command, type FieldEdit, SetFields, t, tCount } from '@farol/editing';
import { GameObject, type Scene } from '@farol/engine';
import type { Vector3Tuple } from '@farol/engine/fields';
import { Euler, Matrix4, Quaternion, Vector3 } from 'three';
import { MoveObjects } from '../commands/MoveObjects';
import { type Container, placementOf, topmost } from '../commands/Placement';
import { PlaceObjects } from '../commands/PlaceObjects';
import { Sequence } from '../commands/Sequence';
import { UniqueNames } from '../UniqueNames';
import type { ArrangedPlace, Arrangement } from './Arrangement';
import { lightEdits } from './varyLight';

const none = { done: [], undone: [] };
const world = new Matrix4();
const position = new Vector3();
const rotation = new Quaternion();
const turn = new Quaternion();
const scale = new Vector3();
const euler = new Euler();

/** Rounds to a micrometre, to drop rounding errors of the matrix arithmetic. */
const tidy = (value: number): number => Number(value.toFixed(6)) + 0;

interface Own {
  readonly rotation: Vector3Tuple;
  readonly scale: Vector3Tuple;
}

interface Pose extends Own {
  readonly position: Vector3Tuple;
}

const ownOf = ({ transform }: GameObject): Own => ({
  rotation: transform.getAuthored('rotation') as Vector3Tuple,
  scale: transform.getAuthored('scale') as Vector3Tuple,
});

/**
 * Pose of a placed object in the space of its parent.
 * @param source - world matrix of the original
 * @param own - authored rotation and scale of the original, if its parent has the orientation and size of the new
 *   parent, else null; copied exactly where the place does not change them
 */
function poseAt(place: ArrangedPlace, source: Matrix4, parentInverse: Matrix4 | null, own: Own | null): Pose {
  source.decompose(position, rotation, scale);
  position.fromArray(place.position);
  if (place.turn) rotation.premultiply(turn.fromArray(place.turn));
  scale.multiplyScalar(place.scale ?? 1);
  if (parentInverse) {
    world.compose(position, rotation, scale).premultiply(parentInverse).decompose(position, rotation, scale);
  }
  euler.setFromQuaternion(rotation, 'XYZ');
  return {
    position: [tidy(position.x), tidy(position.y), tidy(position.z)],
    rotation: own && !place.turn ? own.rotation : [tidy(euler.x), tidy(euler.y), tidy(euler.z)],
    scale: own && place.scale === undefined ? own.scale : [tidy(scale.x), tidy(scale.y), tidy(scale.z)],
  };
}

const poseEdits = ({ transform }: GameObject, pose: Pose): FieldEdit[] =>
  (['position', 'rotation', 'scale'] as const).map((name) => ({ owner: transform, name, value: pose[name] }));

const inverseOf = (parent: Container): Matrix4 | null =>
  parent instanceof GameObject ? parent.transform.modelMatrix.invert() : null;

/** Centroid of places (m, world). */
function middleOf(places: readonly ArrangedPlace[]): Vector3 {
  const middle = new Vector3();
  for (const place of places) middle.add(position.fromArray(place.position));
  return middle.divideScalar(Math.max(1, places.length));
}

/**
 * Copies objects to places, the first place of each being its own, and varies the copies' lights, as one undo step.
 * Copies follow their original in the tree, or all are below a new object at their centroid; new objects are selected.
 * @param objects - at least one; those below another are ignored
 * @param places - at least one for each original; at most `MOST_COPIES`
 */
export function arrangeObjects(
  scene: Scene,
  objects: readonly GameObject[],
  places: readonly ArrangedPlace[],
  arrangement: Arrangement,
): Command {
  const tops = topmost(objects, scene);
  const sources = tops.map(({ transform }) => transform.modelMatrix);
  const names = new UniqueNames(scene);
  const group = arrangement.grouped ? new GameObject(names.take(t('Copies of {name}', { name: tops[0].name }))) : null;
  const groupPlace = placementOf(tops[0], scene);
  const inverses = new Map<Container, Matrix4 | null>();
  if (group) {
    position.copy(middleOf(places));
    const parentInverse = inverseOf(groupPlace.parent);
    if (parentInverse) position.applyMatrix4(parentInverse);
    group.transform.position = [tidy(position.x), tidy(position.y), tidy(position.z)];
    const inside = new Matrix4().setPosition(...group.transform.position).invert();
    inverses.set(group, parentInverse ? inside.multiply(parentInverse) : inside);
  }
  const after = new Map<GameObject, number>();
  const seen = new Set<number>();
  const edits: FieldEdit[] = [];
  const made: GameObject[] = [];
  const placements = places.flatMap((place, i) => {
    const original = tops[place.source];
    const parent: Container = group ?? original.parent ?? scene;
    let inverse = inverses.get(parent);
    if (inverse === undefined) inverses.set(parent, (inverse = inverseOf(parent)));
    const isAsBefore = !group || (original.parent ?? scene) === groupPlace.parent;
    const pose = poseAt(place, sources[place.source], inverse, isAsBefore ? ownOf(original) : null);
    const isOriginal = !seen.has(place.source);
    seen.add(place.source);
    const differences = (object: GameObject): FieldEdit[] => lightEdits(object, arrangement, i, places.length);
    if (isOriginal) {
      edits.push(...poseEdits(original, pose), ...differences(original));
      return [];
    }
    const copy = original.clone();
    copy.name = names.take(original.name);
    Object.assign(copy.transform, pose);
    for (const { owner, name, value } of differences(copy)) owner.set(name, value);
    made.push(copy);
    const number = (after.get(original) ?? 0) + 1;
    after.set(original, number);
    return [{ object: copy, parent, original, number }];
  });
  /** Placements in the order of the tree: within each parent, every original and then its copies. */
  const inTree = (): { object: GameObject; parent: Container; index: number }[] => {
    if (group) return placements.map(({ object }, i) => ({ object, parent: group, index: tops.length + i }));
    const shifts = new Map<Container, number>();
    return tops.flatMap((original) => {
      const { parent, index } = placementOf(original, scene);
      const copies = placements.filter((each) => each.original === original);
      const shift = shifts.get(parent) ?? 0;
      shifts.set(parent, shift + copies.length);
      return copies.map(({ object, number }) => ({ object, parent, index: index + shift + number }));
    });
  };
  const label = tCount(made.length, 'Duplicated {name} once', 'Duplicated {name} {count} times', {
    name: nameOf(tops),
  });
  return new Sequence(
    label,
    [
      ...(group
        ? [
            () => new PlaceObjects('Add group', scene, 'add', [{ ...groupPlace, object: group }], none),
            () => new MoveObjects('Move into group', scene, tops, group, null),
          ]
        : []),
      () => new PlaceObjects('Add copies', scene, 'add', inTree(), none),
      () => new SetFields('Place', edits),
    ],
    {
      done: group ? [group.id] : [...tops, ...made].map(({ id }) => id),
      undone: objects.map(({ id }) => id),
    },
  );
}

const nameOf = (objects: readonly GameObject[]): string =>
  objects.length === 1 ? objects[0].name : tCount(objects.length, '{count} object', '{count} objects');
