import { boolean, euler, number, string, vector3 } from '@farol/editing/fields';
import type { Object3D } from 'three';
import { declare } from './declare';

/** Updates an object's matrix from the edited values, when the page has set `matrixAutoUpdate` to false. */
const place = (target: object) => {
  const object = target as Object3D;
  if (!object.matrixAutoUpdate) object.updateMatrix();
};

/** Position, rotation and scale of any object, relative to its parent. */
export const transformProperties = [
  declare('position', vector3([0, 0, 0], { unit: 'm', step: 0.1, help: 'Position in its parent.' }), place),
  declare('rotation', euler([0, 0, 0], { help: 'Rotation about x, y and z in its parent.' }), place),
  declare('scale', vector3([1, 1, 1], { step: 0.1, help: 'Scale along x, y and z.' }), place),
];

/** Name and flags of any object. */
export const objectProperties = [
  declare('name', string('', { help: 'Name in the tree.' })),
  declare('visible', boolean(true, { help: 'Drawn, with all that is below it.' })),
  declare('castShadow', boolean(false, { help: 'Casts a shadow.' })),
  declare('receiveShadow', boolean(false, { help: 'Shadows of others fall on it.' })),
  declare('frustumCulled', boolean(true, { help: 'Not drawn while it is outside the view.' })),
  declare('renderOrder', number(0, { integer: true, help: 'Lower ones are drawn first.' })),
];
