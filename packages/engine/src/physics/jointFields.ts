const withAxis = { visibleWhen: { field: 'type', equals: ['hinge', 'slider'] } };
const withLimits = { visibleWhen: { field: 'type', equals: ['hinge', 'slider', 'ball'] } };
const ball = { field: 'type', equals: ['ball'] };
const hinge = { field: 'type', equals: ['hinge'] };
const slider = { field: 'type', equals: ['slider'] };
const limit = { group: 'Limits' };
const motor = { group: 'Motor' };
const spring = { visibleWhen: { field: 'type', equals: ['spring'] }, group: 'Spring' };

import { angle, boolean, choice, number, object, vector3 } from '@farol/editing/fields';

/** A Joint's kind, other body, axis, limits and motor, as the inspector shows them. */
export const jointFields = {
  type: choice('hinge', ['fixed', 'hinge', 'ball', 'slider', 'spring'], {
    help: 'What the two bodies may do to each other: nothing, turn about an axis or a point, slide along an axis, or keep a distance.',
    optionLabels: { fixed: 'Fixed', hinge: 'Hinge', ball: 'Ball ## joint', slider: 'Slider', spring: 'Spring' },
  }),
  partner: object(null, { help: 'The object with the other body; the world when empty.' }),
  anchor: vector3([0, 0, 0], { unit: 'm', step: 0.05, help: 'Where the joint is, in the space of this object.' }),
  ownPartnerAnchor: boolean(false, {
    help: 'Gives the place of the joint at the partner too; else it is where the joint is when the scene begins to play.',
    label: 'Anchor at the partner',
  }),
  partnerAnchor: vector3([0, 0, 0], {
    unit: 'm',
    step: 0.05,
    help: 'Where the joint is in the space of the partner, or in the world.',
    label: 'Partner anchor',
    visibleWhen: { field: 'ownPartnerAnchor', equals: [true] },
  }),
  axis: vector3([0, 1, 0], {
    step: 0.1,
    help: 'Axis of this object that it turns about or slides along; of a ball, the one that leans within its limit.',
    ...withLimits,
  }),
  collide: boolean(false, { help: 'The two bodies collide with each other.', label: 'Collide with partner' }),
  limits: boolean(false, { help: 'Holds the motion between two ends, or within a cone.', ...withLimits, ...limit }),
  lowerAngle: angle(-Math.PI / 2, {
    min: -Math.PI,
    max: Math.PI,
    help: 'From where it is when the scene begins to play.',
    label: 'Lower angle',
    visibleWhen: { field: 'limits', equals: [true], and: hinge },
    ...limit,
  }),
  upperAngle: angle(Math.PI / 2, {
    min: -Math.PI,
    max: Math.PI,
    help: 'From where it is when the scene begins to play.',
    label: 'Upper angle',
    visibleWhen: { field: 'limits', equals: [true], and: hinge },
    ...limit,
  }),
  coneAngle: angle(Math.PI / 4, {
    min: 0,
    max: Math.PI,
    help: 'How far the axis leans from where it is when the scene begins to play; about it, it turns freely.',
    label: 'Cone angle',
    visibleWhen: { field: 'limits', equals: [true], and: ball },
    ...limit,
  }),
  lowerDistance: number(0, {
    unit: 'm',
    step: 0.05,
    help: 'From where it is when the scene begins to play.',
    label: 'Lower distance',
    visibleWhen: { field: 'limits', equals: [true], and: slider },
    ...limit,
  }),
  upperDistance: number(1, {
    unit: 'm',
    step: 0.05,
    help: 'From where it is when the scene begins to play.',
    label: 'Upper distance',
    visibleWhen: { field: 'limits', equals: [true], and: slider },
    ...limit,
  }),
  motor: boolean(false, { help: 'Drives the joint.', ...withAxis, ...motor }),
  motorTurn: number(1, {
    unit: 'rad/s',
    step: 0.1,
    help: 'Speed that the motor turns it to.',
    label: 'Motor speed',
    visibleWhen: { field: 'motor', equals: [true], and: hinge },
    ...motor,
  }),
  motorSpeed: number(1, {
    unit: 'm/s',
    step: 0.1,
    help: 'Speed that the motor moves it to.',
    label: 'Motor speed',
    visibleWhen: { field: 'motor', equals: [true], and: slider },
    ...motor,
  }),
  motorStrength: number(10, {
    min: 0,
    step: 1,
    help: 'Force or torque for each unit of speed that is missing.',
    label: 'Motor strength',
    visibleWhen: { field: 'motor', equals: [true] },
    ...motor,
  }),
  restLength: number(1, {
    unit: 'm',
    min: 0,
    step: 0.05,
    help: 'Distance of the anchors at which the spring does not pull.',
    label: 'Rest length',
    ...spring,
  }),
  stiffness: number(50, {
    unit: 'N/m',
    min: 0,
    step: 1,
    help: 'Force for each metre that it is stretched or pressed.',
    ...spring,
  }),
  damping: number(1, {
    unit: 'N·s/m',
    min: 0,
    step: 0.1,
    help: 'Force against each metre a second of its motion.',
    ...spring,
  }),
};
