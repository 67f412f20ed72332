import type { Action } from '../api/Action';

export const showStatistics: Action = {
  id: 'view.statistics',
  label: 'Figures of the frames',
  icon: 'chart',
  menu: { menu: 'view', group: 'figures' },
  run({ viewport }) {
    viewport.showStatistics = !viewport.showStatistics;
  },
  checked: ({ viewport }) => viewport.showStatistics,
};
