import type { Action } from '../api/Action';

/** One view, or four: from above, from the front, from the right, and the one there always is. */
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

/** The next of four views is the one that keys turn and shade. */
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

/** The views beside the main one show again what that shows. */
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
