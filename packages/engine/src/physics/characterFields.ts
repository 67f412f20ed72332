const body = { group: 'Body' };
const whenTurned = { visibleWhen: { field: 'look', equals: ['drag', 'move'] }, group: 'Look' };

import { angle, boolean, choice, number, vector3 } from '@farol/editing/fields';

/** The fields of a CharacterController. */
export const characterFields = {
  walkSpeed: number(3, { unit: 'm/s', min: 0, step: 0.1, help: 'Speed of walking.', label: 'Walk speed' }),
  runFactor: number(2, {
    min: 1,
    max: 100,
    step: 0.1,
    help: 'Factor of the speed while Shift is held or the stick is pressed.',
    label: 'Run factor',
  }),
  jumpHeight: number(1, {
    unit: 'm',
    min: 0,
    step: 0.1,
    help: 'How high it jumps; 0 for not at all.',
    label: 'Jump height',
  }),
  airControl: number(0.3, {
    min: 0,
    max: 1,
    step: 0.05,
    help: 'How well it is steered in the air: 0 not at all, 1 as on the ground.',
    label: 'Control in the air',
  }),
  maxSlope: angle(Math.PI / 4, {
    min: 0,
    max: Math.PI / 2,
    help: 'Steepest slope that it walks up; it slides down steeper ones.',
    label: 'Steepest slope',
  }),
  stepHeight: number(0.3, {
    unit: 'm',
    min: 0,
    step: 0.05,
    help: 'Steps up to this height are climbed.',
    label: 'Step height',
  }),
  snapDistance: number(0.3, {
    unit: 'm',
    min: 0,
    step: 0.05,
    help: 'How far down it keeps to the ground, on stairs and slopes.',
    label: 'Snap to ground',
  }),
  height: number(1.8, { unit: 'm', min: 0.01, step: 0.05, help: 'Height of its capsule.', ...body }),
  radius: number(0.3, { unit: 'm', min: 0.005, step: 0.05, help: 'Radius of its capsule.', ...body }),
  centre: vector3([0, 0.9, 0], {
    unit: 'm',
    step: 0.05,
    help: 'Centre of the capsule in the space of the object: half the height above its feet.',
    label: 'Centre',
    ...body,
  }),
  pushes: boolean(true, { help: 'It pushes dynamic bodies that are in its way.', label: 'Pushes bodies', ...body }),
  mass: number(80, {
    unit: 'kg',
    min: 0.1,
    step: 1,
    help: 'How hard it pushes.',
    visibleWhen: { field: 'pushes', equals: [true] },
    ...body,
  }),
  keys: boolean(true, {
    help: 'W A S D or arrows walk, Shift runs, Space jumps; a gamepad and a finger on the left half do too.',
    label: 'Keys, gamepad, touch',
  }),
  look: choice('drag', ['drag', 'move', 'none'], {
    help: 'How the pointer turns it, and its camera up and down.',
    optionLabels: { drag: 'Dragging', move: 'Moving', none: 'Not at all' },
    group: 'Look',
  }),
  lookSpeed: number(0.004, {
    unit: 'rad/px',
    step: 0.001,
    help: 'Turn for each pixel of motion; below 0 it is inverted.',
    label: 'Look speed',
    ...whenTurned,
  }),
  pitchLimit: angle(1.4, {
    min: 0,
    max: Math.PI / 2,
    help: 'Greatest angle of the view above or below the horizon.',
    label: 'Pitch limit',
    ...whenTurned,
  }),
};
