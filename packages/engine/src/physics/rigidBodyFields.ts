const dynamic = { visibleWhen: { field: 'type', equals: ['dynamic'] } };
const start = { ...dynamic, group: 'At the start' };
const locked = { ...dynamic, group: 'Locked axes' };

import { boolean, choice, number, vector3 } from '@farol/editing/fields';

/** The fields of a RigidBody. */
export const rigidBodyFields = {
  type: choice('dynamic', ['dynamic', 'kinematic', 'fixed'], {
    help: 'Moved by forces and collisions, moved by animation and scripts, or never.',
    optionLabels: { dynamic: 'Dynamic', kinematic: 'Kinematic', fixed: 'Fixed' },
  }),
  massFrom: choice('mass', ['mass', 'density'], {
    help: 'Whether its mass is given, or comes from size and density of its colliders.',
    label: 'Mass by',
    optionLabels: { mass: 'Mass ## of a body', density: 'Density' },
    ...dynamic,
  }),
  mass: number(1, {
    unit: 'kg',
    min: 0.0001,
    step: 0.1,
    help: 'Mass of the whole body.',
    visibleWhen: { field: 'massFrom', equals: ['mass'] },
  }),
  gravityScale: number(1, { step: 0.1, help: "Factor of the scene's gravity.", label: 'Gravity factor', ...dynamic }),
  linearDamping: number(0, {
    unit: '1/s',
    min: 0,
    step: 0.05,
    help: 'How fast its speed fades by itself.',
    label: 'Damping',
    ...dynamic,
  }),
  angularDamping: number(0.05, {
    unit: '1/s',
    min: 0,
    step: 0.05,
    help: 'How fast its turning fades by itself.',
    label: 'Turning damping',
    ...dynamic,
  }),
  continuous: boolean(false, {
    help: 'Does not pass through thin things when it is fast.',
    label: 'Continuous detection',
    ...dynamic,
  }),
  initialVelocity: vector3([0, 0, 0], { unit: 'm/s', step: 0.1, help: 'In the world.', label: 'Velocity', ...start }),
  initialAngularVelocity: vector3([0, 0, 0], {
    unit: 'rad/s',
    step: 0.1,
    help: 'Axis of the world that it turns about, as long as it is fast.',
    label: 'Angular velocity',
    ...start,
  }),
  lockPositionX: boolean(false, { help: 'It does not move along X of the world.', label: 'Position X', ...locked }),
  lockPositionY: boolean(false, { help: 'It does not move along Y of the world.', label: 'Position Y', ...locked }),
  lockPositionZ: boolean(false, { help: 'It does not move along Z of the world.', label: 'Position Z', ...locked }),
  lockRotationX: boolean(false, { help: 'It does not turn about X of the world.', label: 'Rotation X', ...locked }),
  lockRotationY: boolean(false, { help: 'It does not turn about Y of the world.', label: 'Rotation Y', ...locked }),
  lockRotationZ: boolean(false, { help: 'It does not turn about Z of the world.', label: 'Rotation Z', ...locked }),
};
