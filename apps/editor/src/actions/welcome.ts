import type { Action } from '../api/Action';

/** Opens the welcome page with samples, recent files and the tour. */
export const welcome: Action = {
  id: 'file.welcome',
  label: 'Welcome…',
  icon: 'lamp',
  menu: { menu: 'file', group: 'new' },
  run: ({ dialogs }) => void dialogs.show({ kind: 'welcome', recovery: null }),
};

export const startTour: Action = {
  id: 'help.tour',
  label: 'Tour of the editor',
  icon: 'eye',
  menu: { menu: 'help', group: 'learn' },
  run: ({ tour }) => tour.start(),
};
