import type { Action } from '../api/Action';

export const play: Action = {
  id: 'play.play',
  label: 'Play',
  keys: ['Ctrl+P'],
  inFields: true,
  icon: 'play',
  menu: { menu: 'edit', group: 'play' },
  run({ document: { simulation } }) {
    if (simulation.isPlaying) simulation.stop();
    else simulation.play();
  },
  checked: ({ document }) => document.simulation.isPlaying,
};

export const pause: Action = {
  id: 'play.pause',
  label: 'Pause',
  keys: ['Ctrl+Shift+P'],
  inFields: true,
  icon: 'pause',
  menu: { menu: 'edit', group: 'play' },
  run({ document: { simulation } }) {
    if (simulation.isPlaying) simulation.pause();
    else simulation.play();
  },
  checked: ({ document }) => document.simulation.state === 'paused',
  enabled: ({ document }) => document.simulation.state !== 'stopped',
};

export const step: Action = {
  id: 'play.step',
  label: 'Step by 1/60 s',
  keys: ['Ctrl+Alt+P'],
  inFields: true,
  icon: 'step',
  menu: { menu: 'edit', group: 'play' },
  run: ({ document }) => document.simulation.step(),
};

export const stop: Action = {
  id: 'play.stop',
  label: 'Stop, and put everything back',
  icon: 'stop',
  menu: { menu: 'edit', group: 'play' },
  run: ({ document }) => document.simulation.stop(),
  enabled: ({ document }) => document.simulation.state !== 'stopped',
};
