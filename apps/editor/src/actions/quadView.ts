import type { Action } from '../api/Action';

/** Switches between one view, and four: top, front, right and the main one. */
export const quadView: Action = {
  id: 'view.quad',
  label: 'Four views',
  keys: ['Ctrl+Alt+Q'],
  icon: 'quad',
  menu: { menu: 'view', group: 'views' },
  run({ preferences, viewport }) {
    const quad = !viewport.isQuad;
    preferences.setState(({ views }) => ({ views: { ...views, quad } }));
  },
  checked: ({ viewport }) => viewport.isQuad,
};

/** Activates the next of four views. */
export const nextView: Action = {
  id: 'view.nextView',
  label: 'Next view',
  keys: ['Ctrl+Alt+W'],
  menu: { menu: 'view', group: 'views' },
  run({ viewport }) {
    viewport.panes.activateNext(1);
    viewport.canvas.focus();
  },
  enabled: ({ viewport }) => viewport.isQuad,
};

/** Aims the side views at the main view's target again. */
export const resetViews: Action = {
  id: 'view.resetViews',
  label: 'Bring the other views to where this one looks',
  menu: { menu: 'view', group: 'views' },
  run({ viewport }) {
    viewport.panes.lookFromSides();
    viewport.viewChanged();
  },
  enabled: ({ viewport }) => viewport.isQuad,
};
