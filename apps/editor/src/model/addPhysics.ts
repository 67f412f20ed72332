import { type Command, countLabel, t } from '@farol/editing';
import {
  CharacterController,
  Collider,
  type Component,
  type GameObject,
  ObjectRenderer,
  RigidBody,
  type Scene,
} from '@farol/engine';
import { PlaceComponents } from './commands/PlaceComponents';

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

/** Makes objects physics bodies: adds a RigidBody, and a collider fitted to the mesh, where they are missing. */
export function addPhysics(scene: Scene, objects: readonly GameObject[], kind: PhysicsKind): Command {
  const places = objects.flatMap((object) =>
    componentsFor(object, kind).map((component, i) => ({ component, object, index: object.components.length + i })),
  );
  return new PlaceComponents(countLabel(t('Added physics to'), objects), scene, 'add', places);
}
