/** Settings of a scene for its physics. */
import { vector3 } from '@farol/editing/fields';
export const physicsFields = {
  gravity: vector3([0, -9.81, 0], {
    unit: 'm/s²',
    step: 0.1,
    help: 'Acceleration of every dynamic body while the scene plays.',
  }),
};
