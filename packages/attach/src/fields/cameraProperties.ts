import { number } from '@farol/editing/fields';
import type { PerspectiveCamera } from 'three';
import { declare } from './declare';

const project = (target: object) => (target as PerspectiveCamera).updateProjectionMatrix();

/** Properties of cameras; a camera shows those that its three class has. */
export const cameraProperties = [
  declare(
    'fov',
    number(50, { min: 1, max: 179, unit: '°', step: 1, label: 'Field of view', help: 'Vertical angle of the view.' }),
    project,
  ),
  declare('zoom', number(1, { min: 0.01, step: 0.1, help: 'Enlarges the picture.' }), project),
  declare('near', number(0.1, { min: 0, unit: 'm', step: 0.1, help: 'Nearer things are cut off.' }), project),
  declare('far', number(2000, { min: 0, unit: 'm', step: 1, help: 'Farther things are cut off.' }), project),
];
