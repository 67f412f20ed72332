import type { Action } from '../api/Action';

export const focus: Action = {
  id: 'view.focus',
  label: 'Focus on the selection',
  keys: ['F', 'NumpadDecimal'],
  menu: { menu: 'view', group: 'camera' },
  run: ({ viewport }) => viewport.focus(),
  enabled: ({ viewport }) => viewport.flightProblem === null,
};
