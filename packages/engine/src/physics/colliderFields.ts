const simple = ['box', 'sphere', 'capsule', 'cylinder'] as const;
const standing = { visibleWhen: { field: 'shape', equals: ['capsule', 'cylinder'] } };
const byHand = { visibleWhen: { field: 'fit', equals: [false] } };
const solid = { visibleWhen: { field: 'sensor', equals: [false] }, group: 'Surface' };

import { boolean, choice, number, vector3 } from '@farol/editing/fields';

/** A Collider's shape, size, surface and filters, as the inspector shows them. */
export const colliderFields = {
  shape: choice('box', [...simple, 'hull', 'mesh'], {
    help: 'A hull is the smallest shape without hollows round the mesh; a mesh has every triangle, and cannot be that of a dynamic body.',
    optionLabels: {
      box: 'Box',
      sphere: 'Sphere',
      capsule: 'Capsule',
      cylinder: 'Cylinder',
      hull: 'Convex hull',
      mesh: 'Mesh ## collider',
    },
  }),
  fit: boolean(true, {
    help: 'As large as the mesh of the object, or where it has none as the meshes below it.',
    label: 'Fit to mesh',
    visibleWhen: { field: 'shape', equals: simple },
  }),
  size: vector3([1, 1, 1], {
    unit: 'm',
    min: 0,
    step: 0.1,
    help: 'Sides of the box; of other shapes those of the box round them.',
    ...byHand,
  }),
  offset: vector3([0, 0, 0], {
    unit: 'm',
    step: 0.1,
    help: 'Middle of the shape in the space of the object.',
    ...byHand,
  }),
  axis: choice('y', ['x', 'y', 'z'], {
    help: 'Own axis that it stands along.',
    optionLabels: { x: 'X', y: 'Y', z: 'Z' },
    ...standing,
  }),
  sensor: boolean(false, {
    label: 'Trigger only',
    help: 'It stops nothing, and tells what comes in and goes out: onTriggerEnter, onTriggerExit.',
  }),
  friction: number(0.5, {
    min: 0,
    max: 100,
    step: 0.05,
    help: '0 slides as on ice; between two bodies the mean counts.',
    ...solid,
  }),
  restitution: number(0, {
    min: 0,
    max: 1,
    step: 0.05,
    help: 'How much it bounces: 0 not at all, 1 as high as before.',
    label: 'Bounciness',
    ...solid,
  }),
  density: number(1000, {
    unit: 'kg/m³',
    min: 0.001,
    step: 10,
    help: 'Of bodies whose mass comes from their density; else the share of this shape in the mass. Water has 1000.',
    ...solid,
  }),
};
