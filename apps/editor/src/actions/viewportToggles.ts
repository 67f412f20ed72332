import type { Action } from '../api/Action';

export const showGrid: Action = {
  id: 'view.grid',
  label: 'Grid',
  icon: 'grid',
  menu: { menu: 'view', group: 'show' },
  run({ viewport }) {
    viewport.showGrid = !viewport.showGrid;
  },
  checked: ({ viewport }) => viewport.showGrid,
};

export const showIcons: Action = {
  id: 'view.icons',
  label: 'Icons of lights and cameras',
  icon: 'point',
  menu: { menu: 'view', group: 'show' },
  run({ viewport }) {
    viewport.showIcons = !viewport.showIcons;
  },
  checked: ({ viewport }) => viewport.showIcons,
};

/** Shows ranges of all lights, or only of selected ones. */
export const showRanges: Action = {
  id: 'view.ranges',
  label: 'Ranges of all lights, not of selected ones alone',
  icon: 'ranges',
  menu: { menu: 'view', group: 'show' },
  run({ viewport }) {
    viewport.showRanges = !viewport.showRanges;
  },
  checked: ({ viewport }) => viewport.showRanges,
};

/** Shows colliders of all objects, or only of selected ones. */
export const showColliders: Action = {
  id: 'view.colliders',
  label: 'Colliders and joints of all objects, not of selected ones alone',
  icon: 'collider',
  menu: { menu: 'view', group: 'show' },
  run({ viewport }) {
    viewport.showColliders = !viewport.showColliders;
  },
  checked: ({ viewport }) => viewport.showColliders,
};

/** Shows the scene's effects, such as depth of field, which can be in the way of editing. */
export const showPictureEffects: Action = {
  id: 'view.pictureEffects',
  label: 'Picture effects: bloom, depth of field, grading, vignette',
  icon: 'contrast',
  menu: { menu: 'view', group: 'show' },
  run({ viewport }) {
    viewport.showPictureEffects = !viewport.showPictureEffects;
  },
  checked: ({ viewport }) => viewport.showPictureEffects,
};

export const continuous: Action = {
  id: 'view.continuous',
  label: 'Draw without pause, to see frame rates',
  icon: 'motion',
  menu: { menu: 'view', group: 'figures' },
  run({ viewport }) {
    viewport.continuous = !viewport.continuous;
  },
  checked: ({ viewport }) => viewport.continuous,
};
