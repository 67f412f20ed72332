import { boolean, euler, number, string, vector3 } from '@farol/editing/fields';
import type { Object3D } from 'three';
import { declare } from './declare';

/** Updates an object's matrix from the edited values, if the page has turned `matrixAutoUpdate` off. */
const place = (target: object) => {
  const object = target as Object3D;
  if (!object.matrixAutoUpdate) object.updateMatrix();
};

/** Position, rotation and scale of any object, in its parent. */
export const transformProperties = [
  declare('position', vector3([0, 0, 0], { unit: 'm', step: 0.1, help: 'Place in its parent.' }), place),
  declare('rotation', euler([0, 0, 0], { help: 'Turn about x, y and z in its parent.' }), place),
  declare('scale', vector3([1, 1, 1], { step: 0.1, help: 'Size along x, y and z.' }), place),
];

/** Name and flags of any object. */
export const objectProperties = [
  declare('name', string('', { help: 'What the tree calls it.' })),
  declare('visible', boolean(true, { help: 'Drawn, with all that is below it.' })),
  declare('castShadow', boolean(false, { help: 'Throws a shadow.' })),
  declare('receiveShadow', boolean(false, { help: 'Shows the shadows of others.' })),
  declare('frustumCulled', boolean(true, { help: 'Left out while the camera does not see it.' })),
  declare('renderOrder', number(0, { integer: true, help: 'Lower ones are drawn first.' })),
];
