import { type Command, countLabel, t } from '@farol/editing';
import {
  Camera,
  CharacterController,
  Collider,
  type Component,
  GameObject,
  ObjectRenderer,
  RigidBody,
  type Scene,
} from '@farol/engine';
import { PlaceComponents } from './commands/PlaceComponents';
import { Sequence } from './commands/Sequence';
import { addObject, moveObjects } from './edits';

/** Body type of an object in the physics simulation. */
export type PhysicsKind = 'dynamic' | 'kinematic' | 'fixed' | 'character';

const shapes: Readonly<Record<string, Collider['shape']>> = {
  box: 'box',
  plane: 'box',
  sphere: 'sphere',
  capsule: 'capsule',
  cylinder: 'cylinder',
};

/** The collider shape closest to an object's mesh: the mesh itself for fixed bodies, a hull for others. */
function shapeFor(object: GameObject, kind: PhysicsKind): Collider['shape'] {
  const mesh = object.getComponent(ObjectRenderer)?.mesh;
  const isDrawn = mesh !== undefined || object.getComponent('ModelRenderer') !== null;
  if (mesh && Object.hasOwn(shapes, mesh)) return shapes[mesh];
  if (!isDrawn) return 'box';
  return kind === 'fixed' ? 'mesh' : 'hull';
}

function componentsFor(object: GameObject, kind: PhysicsKind): Component[] {
  const made: Component[] = [];
  if (kind === 'character') {
    if (!object.getComponent(CharacterController) && !object.getComponent(RigidBody))
      made.push(new CharacterController());
    return made;
  }
  if (kind !== 'fixed' && !object.getComponent(RigidBody) && !object.getComponent(CharacterController)) {
    const body = new RigidBody();
    body.type = kind;
    made.push(body);
  }
  if (!object.getComponent(Collider)) {
    const collider = new Collider();
    collider.shape = shapeFor(object, kind);
    made.push(collider);
  }
  return made;
}

/** Height of a walking character's camera above its feet (m). */
const EYE_HEIGHT = 1.65;

/** Commands that add a character as the parent of a camera. @param selected - ids selected now */
function carryCamera(scene: Scene, camera: GameObject, selected: readonly string[]): (() => Command)[] {
  const player = new GameObject(t('Player'));
  player.addComponent(CharacterController);
  player.tags = ['player'];
  const { x, y, z } = camera.transform.worldPosition;
  player.transform.position = [x, y - EYE_HEIGHT, z];
  return [() => addObject(scene, player, scene, selected), () => moveObjects(scene, [camera], player)];
}

/**
 * Makes objects characters. A camera becomes the child of a new one: a character's origin is at its feet, so a
 * controller on the camera itself would drop the eye to the floor.
 * @param selected - ids selected now
 */
export function addCharacter(scene: Scene, objects: readonly GameObject[], selected: readonly string[]): Command {
  const label = countLabel(t('Added physics to'), objects);
  const seeing = objects.filter((object) => object.getComponent(Camera) && !object.getComponent(CharacterController));
  const others = objects.filter((object) => !seeing.includes(object));
  const steps = seeing.flatMap((camera) => carryCamera(scene, camera, selected));
  if (others.length > 0) steps.push(() => placePhysics(scene, others, 'character'));
  return new Sequence(label, steps, { done: selected, undone: selected });
}

const placePhysics = (scene: Scene, objects: readonly GameObject[], kind: PhysicsKind): Command => {
  const places = objects.flatMap((object) =>
    componentsFor(object, kind).map((component, i) => ({ component, object, index: object.components.length + i })),
  );
  return new PlaceComponents(countLabel(t('Added physics to'), objects), scene, 'add', places);
};

/** Makes objects physics bodies: adds a RigidBody, and a collider fitted to the mesh, where they are missing. */
export const addPhysics = (scene: Scene, objects: readonly GameObject[], kind: PhysicsKind): Command =>
  kind === 'character'
    ? addCharacter(
        scene,
        objects,
        objects.map(({ id }) => id),
      )
    : placePhysics(scene, objects, kind);
