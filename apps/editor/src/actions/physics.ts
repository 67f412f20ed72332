import type { Action } from '../api/Action';
import type { PhysicsKind } from '../model/addPhysics';
import { hasSelection } from './hasSelection';

const makes = (kind: PhysicsKind, label: string, icon: Action['icon']): Action => ({
  id: `physics.${kind}`,
  label,
  icon,
  menu: { menu: 'object', group: 'physics', submenu: 'Physics' },
  enabled: hasSelection,
  async run({ document, commands }) {
    const { addPhysics } = await import('../model/addPhysics');
    commands.run(addPhysics(document.scene, document.selectedObjects, kind));
  },
});

/** Actions that make the selected objects physics bodies, with colliders fitted to their meshes. */
export const physicsActions: readonly Action[] = [
  makes('dynamic', 'Add dynamic body and collider', 'body'),
  makes('kinematic', 'Add kinematic body and collider', 'body'),
  makes('fixed', 'Add fixed collider', 'collider'),
  makes('character', 'Add character controller', 'character'),
];
