import type { Action } from '../api/Action';

/** Opens the tool that measures the distance between two clicked points. */
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
