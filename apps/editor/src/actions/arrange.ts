import type { Command } from '@farol/editing';
import type { GameObject, Scene } from '@farol/engine';
import type * as Placing from '../viewport/placing/alignObjects';
import type { AlignSide, Axis } from '../viewport/placing/alignObjects';
import type { EditorApi } from '../api/EditorApi';
import type { Action } from '../api/Action';
import { hasSelection } from './hasSelection';

const several = ({ document }: EditorApi): boolean => document.selection.ids.length > 1;
const three = ({ document }: EditorApi): boolean => document.selection.ids.length > 2;

/** Body of an action: fetches the placing code, and runs the command that it makes for the selected objects. */
const runOn =
  (make: (placing: typeof Placing, scene: Scene, objects: readonly GameObject[]) => Command): Action['run'] =>
  async ({ document, commands }) => {
    const placing = await import('../viewport/placing/alignObjects');
    const { scene, selectedObjects } = document;
    if (selectedObjects.length > 0) commands.run(make(placing, scene, selectedObjects));
  };

/** Drops the selected objects onto the surface below them. */
export const drop: Action = {
  id: 'object.drop',
  label: 'Drop to ground',
  keys: ['End'],
  run: runOn(({ dropToGround }, scene, objects) => dropToGround(scene, objects)),
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
  run: runOn(({ alignObjects }, scene, objects) => alignObjects(scene, objects, axis, side)),
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
  run: runOn(({ distributeObjects }, scene, objects) => distributeObjects(scene, objects, axis, by)),
  enabled: three,
}));
