import type { AlignSide, Axis } from '../viewport/placing/alignObjects';
import type { EditorApi } from '../api/EditorApi';
import type { Action } from '../api/Action';
import { hasSelection } from './hasSelection';

const several = ({ document }: EditorApi): boolean => document.selection.ids.length > 1;
const three = ({ document }: EditorApi): boolean => document.selection.ids.length > 2;

/** Drops the selected objects onto the surface below them. */
export const drop: Action = {
  id: 'object.drop',
  label: 'Drop to ground',
  keys: ['End'],
  async run({ document, commands }) {
    const { dropToGround } = await import('../viewport/placing/alignObjects');
    const { scene, selectedObjects } = document;
    if (selectedObjects.length > 0) commands.run(dropToGround(scene, selectedObjects));
  },
  enabled: hasSelection,
};

const alignments: readonly [Axis, AlignSide, string][] = [
  ['x', 'min', 'Align the least x'],
  ['x', 'centre', 'Align the middle in x'],
  ['x', 'max', 'Align the greatest x'],
  ['y', 'min', 'Align the lowest points'],
  ['y', 'centre', 'Align the middle in y'],
  ['y', 'max', 'Align the highest points'],
  ['z', 'min', 'Align the least z'],
  ['z', 'centre', 'Align the middle in z'],
  ['z', 'max', 'Align the greatest z'],
];

/** Aligns one side of the selected objects' boxes. */
export const align: readonly Action[] = alignments.map(([axis, side, label]) => ({
  id: `object.align-${axis}-${side}`,
  label,
  async run({ document, commands }) {
    const { alignObjects } = await import('../viewport/placing/alignObjects');
    const { scene, selectedObjects } = document;
    if (selectedObjects.length > 0) commands.run(alignObjects(scene, selectedObjects, axis, side));
  },
  enabled: several,
}));

const distributions: readonly [Axis, 'gaps' | 'centres', string][] = [
  ['x', 'gaps', 'Equal gaps along x'],
  ['y', 'gaps', 'Equal gaps along y'],
  ['z', 'gaps', 'Equal gaps along z'],
  ['x', 'centres', 'Equal distances of middles along x'],
  ['y', 'centres', 'Equal distances of middles along y'],
  ['z', 'centres', 'Equal distances of middles along z'],
];

/** Makes distances between the selected objects equal. */
export const distribute: readonly Action[] = distributions.map(([axis, by, label]) => ({
  id: `object.distribute-${axis}-${by}`,
  label,
  async run({ document, commands }) {
    const { distributeObjects } = await import('../viewport/placing/alignObjects');
    const { scene, selectedObjects } = document;
    if (selectedObjects.length > 0) commands.run(distributeObjects(scene, selectedObjects, axis, by));
  },
  enabled: three,
}));
