import type { Action } from '../api/Action';

export const showStatistics: Action = {
  id: 'view.statistics',
  label: 'Figures of the frames',
  icon: 'chart',
  run({ viewport }) {
    viewport.showStatistics = !viewport.showStatistics;
  },
  checked: ({ viewport }) => viewport.showStatistics,
};
