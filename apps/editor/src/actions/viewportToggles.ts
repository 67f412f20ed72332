import type { Action } from './Action';

export const showGrid: Action = {
  id: 'view.grid',
  label: 'Grid',
  icon: 'grid',
  run({ viewport }) {
    viewport.showGrid = !viewport.showGrid;
  },
  checked: ({ viewport }) => viewport.showGrid,
};

export const showIcons: Action = {
  id: 'view.icons',
  label: 'Icons of lights and cameras',
  icon: 'point',
  run({ viewport }) {
    viewport.showIcons = !viewport.showIcons;
  },
  checked: ({ viewport }) => viewport.showIcons,
};

export const continuous: Action = {
  id: 'view.continuous',
  label: 'Draw without pause, to see frame rates',
  icon: 'motion',
  run({ viewport }) {
    viewport.continuous = !viewport.continuous;
  },
  checked: ({ viewport }) => viewport.continuous,
};
