import type { Action } from '../api/Action';

/** Shows the distance between two points that are clicked. */
export const measureDistance: Action = {
  id: 'view.measure-distance',
  label: 'Measure distance',
  keys: ['M'],
  menu: { menu: 'view', group: 'measure' },
  async run({ viewport, tools }) {
    if (tools.current?.id === 'measure') return void tools.end();
    const { MeasureTool } = await import('../viewport/placing/MeasureTool');
    tools.open(new MeasureTool(viewport));
  },
  checked: ({ tools }) => tools.current?.id === 'measure',
};
