import type { Action } from '../api/Action';
import type { EditorApi } from '../api/EditorApi';

type Flag = 'continuous' | `show${'Colliders' | 'Grid' | 'Icons' | 'PictureEffects' | 'Ranges' | 'Statistics'}`;

/** An action that switches a property of the viewport. */
const toggle = (flag: Flag, action: Omit<Action, 'run' | 'checked'>): Action => ({
  ...action,
  run({ viewport }: EditorApi) {
    viewport[flag] = !viewport[flag];
  },
  checked: ({ viewport }) => viewport[flag],
});

const show = { menu: 'view', group: 'show' } as const;
const figures = { menu: 'view', group: 'figures' } as const;

export const showGrid = toggle('showGrid', { id: 'view.grid', label: 'Grid', icon: 'grid', menu: show });

export const showIcons = toggle('showIcons', {
  id: 'view.icons',
  label: 'Icons of lights and cameras',
  icon: 'point',
  menu: show,
});

/** Shows ranges of all lights, or only of selected ones. */
export const showRanges = toggle('showRanges', {
  id: 'view.ranges',
  label: 'Ranges of all lights, not of selected ones alone',
  icon: 'ranges',
  menu: show,
});

/** Shows colliders of all objects, or only of selected ones. */
export const showColliders = toggle('showColliders', {
  id: 'view.colliders',
  label: 'Colliders and joints of all objects, not of selected ones alone',
  icon: 'collider',
  menu: show,
});

/** Shows the scene's effects, such as depth of field, which can be in the way of editing. */
export const showPictureEffects = toggle('showPictureEffects', {
  id: 'view.pictureEffects',
  label: 'Picture effects: bloom, depth of field, grading, vignette',
  icon: 'contrast',
  menu: show,
});

export const continuous = toggle('continuous', {
  id: 'view.continuous',
  label: 'Draw without pause, to see frame rates',
  icon: 'motion',
  menu: figures,
});

export const showStatistics = toggle('showStatistics', {
  id: 'view.statistics',
  label: 'Figures of the frames',
  icon: 'chart',
  menu: figures,
});
