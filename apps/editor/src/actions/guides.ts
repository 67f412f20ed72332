import type { Action } from '../api/Action';

const REPOSITORY = 'https://github.com/farol-renderer/farol/tree/main';

const pages = [
  ['editor', "The editor's guide", 'apps/editor#readme'],
  ['renderer', 'Guide to techniques and lights', 'packages/renderer#readme'],
  ['microshaders', 'Guide to effects and microshaders', 'packages/renderer/docs/authoring.md'],
  ['limits', 'What the techniques cannot do', 'packages/renderer/docs/limits.md'],
  ['examples', 'Examples for your own page', 'apps/viewer/examples'],
] as const;

/** One action for each page of the documentation, which opens in a new window. */
export const guides: readonly Action[] = pages.map(([name, label, path]) => ({
  id: `help.guide.${name}`,
  label,
  menu: { menu: 'help', group: 'learn', submenu: 'Guides and examples' },
  run: () => void window.open(`${REPOSITORY}/${path}`, '_blank', 'noopener,noreferrer'),
}));

/** Shows version and licence. */
export const about: Action = {
  id: 'help.about',
  label: 'About Farol',
  icon: 'lamp',
  menu: { menu: 'help', group: 'about' },
  run: ({ dialogs }) => void dialogs.show({ kind: 'about' }),
};
