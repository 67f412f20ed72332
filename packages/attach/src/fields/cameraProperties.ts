import { number } from '@farol/editing/fields';
import type { PerspectiveCamera } from 'three';
import { declare } from './declare';

const project = (target: object) => (target as PerspectiveCamera).updateProjectionMatrix();

/** Of cameras; a camera has those that three gives its kind. */
export const cameraProperties = [
  declare(
    'fov',
    number(50, { min: 1, max: 179, unit: '°', step: 1, label: 'Field of view', help: 'From bottom to top.' }),
    project,
  ),
  declare('zoom', number(1, { min: 0.01, step: 0.1, help: 'Factor of the picture.' }), project),
  declare('near', number(0.1, { min: 0, unit: 'm', step: 0.1, help: 'Nearer things are cut off.' }), project),
  declare('far', number(2000, { min: 0, unit: 'm', step: 1, help: 'Farther things are cut off.' }), project),
];
